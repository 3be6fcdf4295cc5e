# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The source tree as the rules see it: folders, files, includes, links. Standard library only."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]


def folders_in_order():
    """The folders of common/ in the order in which includes may point: each sees those before it."""
    lists = (ROOT / "common" / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"foreach\(module\s+([^)]*)\)", lists).group(1).split()


ORDER = folders_in_order()

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.M)
MARK_PRIVATE = "// Private header: not installed."


class Tree:
    """A checkout, or a copy of its common/, driver/ and utils/."""

    def __init__(self, root):
        self.root = pathlib.Path(root)

    def files(self, *tops, endings=(".h", ".cpp")):
        """Paths relative to the root, sorted."""
        found = []
        for top in tops or ("common", "driver", "utils"):
            found += [p.relative_to(self.root) for p in (self.root / top).rglob("*") if p.suffix in endings]
        return sorted(found)

    def text(self, path):
        return (self.root / path).read_text(encoding="utf-8")

    def includes(self, path):
        """(quoted, name) of each include of a file."""
        return [(mark == '"', name) for mark, name in INCLUDE.findall(self.text(path))]

    def links(self, folder):
        """The folders of common/ that the CMakeLists.txt of a folder names under DEPENDS."""
        names = set()
        for lists in [folder / "CMakeLists.txt", *sorted((self.root / folder).glob("*/CMakeLists.txt"))]:
            path = self.root / lists
            if path.is_file():
                for block in re.findall(r"\bDEPENDS\s+([^()]*?)(?:\bLINKS\b|\))", path.read_text(encoding="utf-8")):
                    names |= set(block.split())
        return names


def folder_of(path):
    """The folder that a file belongs to: common/pyramid, driver, utils/console."""
    parts = path.parts
    return pathlib.Path(*parts[:1]) if parts[0] == "driver" else pathlib.Path(*parts[:2])


def without_comments_and_strings(text):
    """C++ with comments, strings and characters blanked out; lines stay where they are."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), text)
