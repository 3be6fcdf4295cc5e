#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
#
# docs/build.sh [OUTPUT]: HTML and man pages into OUTPUT (build/docs). Warnings are errors. Needs the packages
# QMESH_DOCS_PACKAGES of utils/packages.sh; CMake's target `docs` calls it.
set -euo pipefail

docs=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
output=${1:-$docs/../build/docs}
for python in python3 /usr/bin/python3; do
  "$python" -c 'import sphinx, myst_parser, furo' 2>/dev/null && break
done
for builder in html man; do
  "$python" -m sphinx -q -W --keep-going -b "$builder" -d "$output/doctrees-$builder" "$docs" "$output/$builder"
done
echo "$output/html/index.html"
