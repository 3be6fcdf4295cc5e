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
_FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)


def pages():
    """The README and every page of docs/, parts included by others left out."""
    found = [p for p in sorted((ROOT / "docs").rglob("*.md")) if "reference" not in p.parts]
    return [ROOT / "README.md", *found]


def blocks(page, language):
    """The code blocks of one language on a page."""
    return [text for kind, text in _FENCE.findall(page.read_text()) if kind == language]
