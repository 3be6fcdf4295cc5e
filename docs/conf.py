# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""How Sphinx makes HTML and man pages of this folder: docs/build.sh."""

import pathlib
import re

_ROOT = pathlib.Path(__file__).resolve().parent.parent

project = "qmesh"
author = "the qmesh authors"
copyright = "2026, the qmesh authors"
release = re.search(r"project\(qmesh VERSION ([\d.]+)", (_ROOT / "CMakeLists.txt").read_text()).group(1)
version = release

extensions = ["myst_parser"]
myst_enable_extensions = ["colon_fence", "deflist"]
myst_heading_anchors = 3
# Parts that other pages include.
exclude_patterns = ["reference/*", "algorithms/comparison.md", "_build"]
source_suffix = {".md": "markdown"}
nitpicky = True
# Options in the text keep their two hyphens.
smartquotes = False

html_theme = "furo"
html_title = f"qmesh {release}"
html_static_path = ["_static"]
html_css_files = ["qmesh.css"]
html_copy_source = False
html_show_sphinx = False

man_pages = [
    ("gdal2qmesh", "gdal2qmesh", "convert a DEM to a Cesium quantized-mesh tileset", author, 1),
    ("qmeshinfo", "qmeshinfo", "describe, validate and measure quantized-mesh tilesets", author, 1),
]
