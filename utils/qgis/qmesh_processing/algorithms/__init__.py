# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The algorithms of the provider, in the order of the toolbox."""

from .generate import Generate

ALGORITHMS = [Generate]
