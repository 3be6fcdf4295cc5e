# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The rules of the source layout. Each function takes a Tree and returns what breaks the rule, a sentence each."""

import collections
import re

from tree import MARK_PRIVATE, ORDER, folder_of, without_comments_and_strings

LONGEST_FUNCTION = 60  # lines
LONGEST_FILE = 400  # lines
MOST_FILES = 40  # in a folder of common/

# Headers of other projects: where they may be included.
FOREIGN = {
    "GDAL": (re.compile(r"^(gdal|cpl_|ogr|vrt)"), re.compile(
        r"^(common/(vsi|source|sink|tileset|validate|run)|driver|utils)/")),
    "CGAL": (re.compile(r"^CGAL/"), re.compile(r"^common/simplify/cgal/")),
    "nlohmann-json": (re.compile(r"^nlohmann/"), re.compile(
        r"^(common/(codec|pyramid|options|validate)/|utils/[a-z0-9]+/)")),
    "MPI": (re.compile(r"^mpi\.h$"), re.compile(r"^common/pyramid/mpi_")),
}


def matrix(tree):
    """For each folder the folders it includes: {common/pyramid: {base, grid, ...}}."""
    seen = collections.defaultdict(set)
    names = set(ORDER)
    for path in tree.files():
        own = folder_of(path)
        for quoted, name in tree.includes(path):
            other = name.split("/")[0]
            if quoted and "/" in name and other in names and str(own) != f"common/{other}":
                seen[own].add(other)
    return seen


def matrix_table(tree):
    """The include matrix for people: a row for each folder, a column for each folder of common/."""
    seen = matrix(tree)
    rows = [f"common/{name}" for name in ORDER] + sorted(str(f) for f in seen if f.parts[0] != "common")
    width = max(map(len, rows))
    lines = [" " * width + "".join(f" {name[:3]}" for name in ORDER)]
    by_name = {str(folder): others for folder, others in seen.items()}
    for row in rows:
        marks = "".join("   x" if name in by_name.get(row, ()) else "   ." for name in ORDER)
        lines.append(row.ljust(width) + marks)
    return "\n".join(lines)


def upward_includes(tree):
    faults = []
    for path in tree.files("common"):
        own = path.parts[1]
        for quoted, name in tree.includes(path):
            other = name.split("/")[0]
            if not quoted:
                continue
            if other not in ORDER:
                faults.append(f"{path} includes \"{name}\", which is in no folder of common/")
            elif ORDER.index(other) > ORDER.index(own):
                faults.append(f"{path} includes \"{name}\", but {other} is above {own}")
    return faults


def unlisted_folders(tree):
    return [f"common/{p.name} is missing in common/CMakeLists.txt"
            for p in sorted((tree.root / "common").iterdir()) if p.is_dir() and p.name not in ORDER]


def unlinked_includes(tree):
    """CMake links what the includes say, also where only a header is used."""
    faults = []
    for folder, others in sorted(matrix(tree).items()):
        if folder.parts[0] != "common":
            continue
        linked = {name for name in tree.links(folder) if name in ORDER and name != folder.name}
        faults += [f"{folder} includes {name}/ but its CMakeLists.txt does not depend on it"
                   for name in sorted(others - linked)]
        faults += [f"{folder}/CMakeLists.txt depends on {name}, which it does not include"
                   for name in sorted(linked - others)]
    return faults


def foreign_headers(tree):
    faults = []
    for path in tree.files():
        for _, name in tree.includes(path):
            for project, (header, allowed) in FOREIGN.items():
                if header.match(name) and not allowed.match(str(path)):
                    faults.append(f"{path} includes <{name}>: {project} has no business there")
    return faults


def repeated_types(tree):
    """Two types of one name in namespace qmesh are undefined behaviour, wherever they stand."""
    places = collections.defaultdict(set)
    definition = re.compile(r"^(?:template\s*<[^;{]*>\s*)?(?:class|struct|enum class|enum)\s+(\w+)(?:\s+final)?"
                            r"\s*(?::(?!:)[^;{]*)?\{", re.M)
    for path in tree.files("common", "utils"):
        text = without_comments_and_strings(tree.text(path))
        if path.suffix == ".cpp":
            text = outside_anonymous_namespaces(text)
        for name in definition.findall(text):
            places[name].add(str(path))
    return [f"{name} is defined in {' and in '.join(sorted(paths))}"
            for name, paths in sorted(places.items()) if len(paths) > 1]


def outside_anonymous_namespaces(text):
    pieces, start = [], 0
    for match in re.finditer(r"^namespace \{", text, re.M):
        if match.start() < start:
            continue
        pieces.append(text[start:match.start()])
        start = end_of_braces(text, match.end() - 1)
    return "".join(pieces) + text[start:]


def end_of_braces(text, opening):
    """Behind the brace that closes the one at `opening`."""
    depth = 0
    for at in range(opening, len(text)):
        if text[at] == "{":
            depth += 1
        elif text[at] == "}":
            depth -= 1
            if depth == 0:
                return at + 1
    return len(text)


def long_functions(tree):
    """Function bodies of more than LONGEST_FUNCTION lines, signature not counted; one that only returns a table is
    none."""
    faults = []
    body = re.compile(r"\)\s*(?:const\s*)?(?:noexcept\s*)?(?:override\s*)?(?:->\s*[\w:<>&*\s]+)?\{")
    for path in tree.files():
        text = without_comments_and_strings(tree.text(path))
        skip = 0
        for match in body.finditer(text):
            if match.start() < skip:
                continue
            end = end_of_braces(text, match.end() - 1)
            lines = text.count("\n", match.end(), end) - 1
            inside = text[match.end():end].strip()
            table = inside.startswith("return {") and inside.count(";") == 1
            if lines > LONGEST_FUNCTION and not table:
                line = text.count("\n", 0, match.start()) + 1
                faults.append(f"{path}:{line}: a function of {lines} lines; at most {LONGEST_FUNCTION}")
            skip = end
    return faults


def long_files(tree):
    return [f"{path} has {lines} lines; at most {LONGEST_FILE}" for path in tree.files()
            if (lines := tree.text(path).count("\n")) > LONGEST_FILE]


def crowded_folders(tree):
    faults = []
    for folder in sorted(p for p in (tree.root / "common").rglob("*") if p.is_dir()):
        count = sum(1 for p in folder.iterdir() if p.is_file())
        if count > MOST_FILES:
            faults.append(f"{folder.relative_to(tree.root)} holds {count} files; at most {MOST_FILES}")
    return faults


def is_private(tree, path):
    return MARK_PRIVATE in tree.text(path)


def private_headers(tree):
    """A header that is installed includes no private one, and nothing of nlohmann-json or CGAL."""
    faults = []
    headers = tree.files("common", endings=(".h",))
    private = {str(path.relative_to("common")) for path in headers if is_private(tree, path)}
    for path in headers:
        if str(path.relative_to("common")) in private:
            continue
        for quoted, name in tree.includes(path):
            if quoted and name in private:
                faults.append(f"{path} is installed but includes the private header {name}")
            if re.match(r"(CGAL|nlohmann)/", name):
                faults.append(f"{path} includes <{name}>; mark it with \"{MARK_PRIVATE}\"")
    return faults


ALL = [upward_includes, unlisted_folders, unlinked_includes, foreign_headers, repeated_types, long_functions,
       long_files, crowded_folders, private_headers]
