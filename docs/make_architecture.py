#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The folders of the sources and what they include: docs/images/folders.svg and a column of docs/architecture.md.

    python3 docs/make_architecture.py            writes them
    python3 docs/make_architecture.py --check    lists what differs, exit code 1 if anything does

Another root can be given as the last argument.
"""

import pathlib
import re
import sys

_INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
_ROW = re.compile(r"^\| `([\w/]+)` \| (.*) \| .* \|$", re.M)

ROW_HEIGHT = 76
BOX_HEIGHT = 32
GAP = 26
MARGIN = 24


# ---- What the sources say ---------------------------------------------------------------------------


def source_folders(root):
    """Name -> folder, in the order of common/CMakeLists.txt (includes point back in it), then driver and utils."""
    text = (root / "common/CMakeLists.txt").read_text()
    names = re.search(r"foreach\(module ([^)]*)\)", text).group(1).split()
    folders = {name: root / "common" / name for name in names}
    folders["driver"] = root / "driver"
    for folder in sorted((root / "utils").iterdir()):
        if any(folder.glob("*.cpp")):
            folders[f"utils/{folder.name}"] = folder
    return folders


def included_folders(root):
    """Name -> names of the folders that its files include by quoted path, in the order of source_folders()."""
    folders = source_folders(root)
    roots = [root / "common", root / "utils", root / "driver", root / "utils/preview"]
    result = {}
    for name, folder in folders.items():
        found = set()
        for file in sorted([*folder.rglob("*.h"), *folder.rglob("*.cpp")]):
            for path in _INCLUDE.findall(file.read_text()):
                place = next((top / path for top in [file.parent, *roots] if (top / path).exists()), None)
                found.update(other for other, inside in folders.items() if place and inside in place.parents)
        result[name] = [other for other in folders if other in found and other != name]
    return result


# ---- The picture ------------------------------------------------------------------------------------


def reduced(sees):
    """The arrows without those that follow from others."""

    def reach(name):
        return set(sees[name]).union(*(reach(other) for other in sees[name]))

    return {name: [to for to in tos if not any(to in reach(via) for via in tos if via != to)]
            for name, tos in sees.items()}


def layered(sees):
    """Rows of boxes, the lowest first: a folder lies one row above the highest that it includes. Arrows across
    several rows bend at a point in each, a tuple (from, to, row). Returns the rows and the parts of the arrows."""
    depth = {}
    for name in _from_below(sees):
        depth[name] = 1 + max((depth[to] for to in sees[name]), default=-1)
    rows = [[name for name in sees if depth[name] == level] for level in range(max(depth.values()) + 1)]
    arrows = []
    for name, tos in reduced(sees).items():
        for to in tos:
            bends = [(name, to, row) for row in range(depth[name] - 1, depth[to], -1)]
            for bend in bends:
                rows[bend[2]].append(bend)
            arrows.append([name, *bends, to])
    return rows, arrows


def _from_below(sees):
    done = []
    while len(done) < len(sees):
        ready = [name for name in sees if name not in done and all(to in done for to in sees[name])]
        if not ready:
            raise SystemExit("folders include each other in a circle: " +
                             ", ".join(name for name in sees if name not in done))
        done += ready
    return done


def ordered(rows, arrows):
    """The rows with few crossings: each box moves to the mean position of those that it is joined to."""
    joined = {}
    for path in arrows:
        for upper, lower in zip(path, path[1:]):
            joined.setdefault(upper, []).append(lower)
            joined.setdefault(lower, []).append(upper)
    rows = [list(row) for row in rows]
    for sweep in range(24):
        order = range(len(rows)) if sweep % 2 == 0 else range(len(rows) - 1, -1, -1)
        for level in order:
            beside = level - 1 if sweep % 2 == 0 else level + 1
            if not 0 <= beside < len(rows):
                continue
            at = {box: (i + 0.5) / len(rows[beside]) for i, box in enumerate(rows[beside])}
            own = {box: (i + 0.5) / len(rows[level]) for i, box in enumerate(rows[level])}

            def mean(box):
                places = [at[other] for other in joined.get(box, []) if other in at]
                return sum(places) / len(places) if places else own[box]

            rows[level].sort(key=mean)
    return rows


def box_width(box):
    return 8 if isinstance(box, tuple) else 9 * len(box) + 24


def placed(rows):
    """Box -> (x of its middle, y of its top), and the size of the picture. Rows fill the whole width."""
    width = max(sum(map(box_width, row)) + GAP * (len(row) + 1) for row in rows)
    height = ROW_HEIGHT * (len(rows) - 1) + BOX_HEIGHT
    places = {}
    for level, row in enumerate(rows):
        gap = (width - sum(map(box_width, row))) / (len(row) + 1)
        x = MARGIN + gap
        for box in row:
            places[box] = (x + box_width(box) / 2, MARGIN + height - BOX_HEIGHT - ROW_HEIGHT * level)
            x += box_width(box) + gap
    return places, (width + 2 * MARGIN, height + 2 * MARGIN)


def arrow_path(path, places):
    """From the bottom of the first box to the top of the last, upright through the points between."""
    x, top = places[path[0]]
    y = top + BOX_HEIGHT
    parts = [f"M{x:.0f} {y:.0f}"]
    for box in path[1:]:
        to_x, to_y = places[box]
        middle = (y + to_y) / 2
        parts.append(f"C{x:.0f} {middle:.0f} {to_x:.0f} {middle:.0f} {to_x:.0f} {to_y:.0f}")
        x, y = to_x, to_y
        if isinstance(box, tuple):
            y += BOX_HEIGHT
            parts.append(f"V{y:.0f}")
    return " ".join(parts)


def picture(sees):
    rows, arrows = layered(sees)
    places, (width, height) = placed(ordered(rows, arrows))
    lines = [
        "<!-- Made by docs/make_architecture.py -->",
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" '
        'font-family="monospace" font-size="14" text-anchor="middle">',
        "  <title>Folders and their includes</title>",
        '  <defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
        '<path d="M0 0L8 4L0 8z" fill="#57606a"/></marker></defs>',
        f'  <rect width="{width:.0f}" height="{height:.0f}" fill="#ffffff"/>',
        '  <g fill="none" stroke="#8c959f" stroke-width="1.3">',
    ]
    lines += [f'    <path d="{arrow_path(path, places)}" marker-end="url(#tip)"/>' for path in arrows]
    lines.append("  </g>")
    for name in sees:
        x, y = places[name]
        fill = "#f6f8fa" if "/" not in name and name != "driver" else "#ddf4ff"
        lines.append(f'  <rect x="{x - box_width(name) / 2:.0f}" y="{y:.0f}" width="{box_width(name)}" '
                     f'height="{BOX_HEIGHT}" rx="6" fill="{fill}" stroke="#57606a"/>'
                     f'<text x="{x:.0f}" y="{y + 21:.0f}" fill="#1f2328">{name}</text>')
    lines.append("</svg>")
    return "\n".join(lines) + "\n"


# ---- The table --------------------------------------------------------------------------------------


def table(text, sees):
    """The page with the rows in the order of the folders and the last column as it is in the sources."""
    ideas = dict(_ROW.findall(text))
    if set(ideas) != set(sees):
        raise SystemExit("docs/architecture.md: rows of the table to add or to remove: " +
                         ", ".join(sorted(set(ideas) ^ set(sees))))
    rows = [f"| `{name}` | {ideas[name]} | {', '.join(tos) or '-'} |" for name, tos in sees.items()]
    matches = list(_ROW.finditer(text))
    return text[: matches[0].start()] + "\n".join(rows) + text[matches[-1].end() :]


def main(arguments):
    check = "--check" in arguments
    roots = [argument for argument in arguments if argument != "--check"]
    root = pathlib.Path(roots[0] if roots else pathlib.Path(__file__).parent.parent).resolve()
    sees = included_folders(root)
    page = root / "docs/architecture.md"
    wanted = {root / "docs/images/folders.svg": picture(sees), page: table(page.read_text(), sees)}
    stale = [file for file, text in wanted.items() if not file.exists() or file.read_text() != text]
    for file in stale:
        if check:
            print(f"{file.relative_to(root)} differs from the sources: run docs/make_architecture.py")
        else:
            file.write_text(wanted[file])
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
