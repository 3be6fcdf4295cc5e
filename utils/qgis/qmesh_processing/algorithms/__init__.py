# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The algorithms of the provider, in the order of their making and use."""

from .generate import Generate
from .info import Info, Measure
from .preview import Preview
from .triangles import Triangles

ALGORITHMS = [Generate, Info, Triangles, Measure, Preview]
