#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
#
# autotest/driver/newest_gdal.sh [FOLDER]
#
# Compiles the driver and all else that includes GDAL against the headers of a newer GDAL than the one installed, so
# that the public API that moved since is used as it is there (driver/README.md). Debian has no newer one; the npm
# package gdal-async ships GDAL's sources. It is fetched once, into FOLDER (default build/newest-gdal).
set -euo pipefail

version=3.12.3
sha256=38bd1f5af66c3f85e0b9f219fe78ed3c5c1f81763eeecaff7a1dc9385901ae10

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:-$root/build/newest-gdal}
archive=gdal-async-$version.tgz
mkdir -p "$folder"
cd "$folder"
if [ ! -e "$archive" ]; then npm pack --silent "gdal-async@$version" >/dev/null; fi
echo "$sha256  $archive" | sha256sum --check --quiet
if [ ! -d package ]; then
  tar -xzf "$archive" package/deps/libgdal/arch/unix package/deps/libgdal/gdal/{gcore,port,ogr,alg,apps,frmts}
fi

headers=()
for part in gdal/gcore/gdal_version_full gdal/gcore gdal/port gdal/ogr gdal/ogr/ogrsf_frmts gdal/alg gdal/apps arch/unix; do
  headers+=(-isystem "$folder/package/deps/libgdal/$part")
done

check() {
  "${CXX:-g++}" -std=c++17 -fsyntax-only -Wall -Wextra -Werror=overloaded-virtual -Werror=suggest-override \
    -DQMESH_VERSION='"0"' "${headers[@]}" -I "$root/common" -I "$root/driver" "$@"
}

# The headers found must be those, not the system's.
printf '#include <gdal_version.h>\nstatic_assert(GDAL_VERSION_NUM >= %d, "not the newer GDAL");\n' \
  $((3 * 1000000 + 12 * 10000)) >version.cpp
check version.cpp

cd "$root"
count=0
failed=0
for file in driver/*.cpp common/vsi/*.cpp common/source/*.cpp common/sink/*.cpp common/tileset/*.cpp; do
  check "$file" || failed=1
  count=$((count + 1))
done
[ "$failed" = 0 ]
echo "$count files compile against GDAL $version"
