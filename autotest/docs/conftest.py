# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""What the tests of the documentation share: its pages and their blocks of code."""

import pathlib
import re
import sys

_HERE = pathlib.Path(__file__).resolve().parent
for folder in (_HERE, _HERE.parent / "utils", _HERE.parent, _HERE.parent / "tools"):
    sys.path.insert(0, str(folder))

ROOT = _HERE.parents[1]
_INCLUDE = re.compile(r"^```\{include\} (\S+)$", re.M)
_FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)


def pages():
    """The README and every page of docs/, parts that others include left out."""
    found = sorted((ROOT / "docs").rglob("*.md"))
    parts = {(page.parent / name).resolve() for page in found for name in _INCLUDE.findall(page.read_text())}
    return [ROOT / "README.md", *(page for page in found if page not in parts)]


def blocks(page, language):
    """The code blocks of one language on a page."""
    return [text for kind, text in _FENCE.findall(page.read_text()) if kind == language]
