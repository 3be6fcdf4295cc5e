# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The option rows of a command, as `--options-json` prints them, in the words of a form. Knows nothing of QGIS."""

import html
import re

# Said by a form in another way, or of use in a terminal only.
LEFT_OUT = {
    "zoom": "min-zoom and max-zoom say the same",
    "te-srs": "an extent of QGIS carries its CRS",
    "dry-run": "writes no terrain",
    "compare": "writes no terrain",
    "compare-tile": "belongs to compare",
    "quiet": "the log is QGIS's",
    "verbose": "the log is QGIS's",
}
# Options whose name is an abbreviation.
_LABELS = {
    "input": "DEM",
    "output": "Terrain folder",
    "s_srs": "CRS of the DEM",
    "srcnodata": "Nodata value",
    "te": "Extent",
    "te-srs": "its CRS",
    "oo": "Open options, one KEY=VALUE a line",
    "if": "GDAL drivers that may open the DEM, one a line",
    "min-x": "First tile column of the last zoom",
    "max-x": "Last tile column of the last zoom",
    "min-y": "First tile row of the last zoom, from the south",
    "max-y": "Last tile row of the last zoom, from the south",
    "tilesize": "Cells per tile edge",
    "exclude": "Leave out tiles without data",
    "xyz": "Number rows from the north (XYZ)",
    "svo": "Smallest visible object",
    "webviewer": "Preview page",
    "cesium": "Folder of a CesiumJS build",
    "debug-meshes": "Folder for every tile's mesh",
    "num-threads": "Threads",
    "set": "Terrain folder",
    "dem": "DEM",
    "dem-step": "Measure at every N-th column and row; 0: by itself",
    "zoom": "Zooms",
    "stats": "Read every tile for its numbers",
    "ignore": "Findings to pass over, one a line",
    "max-findings": "Places told of each finding; 0: all",
}
# A form has less room than a help text: few people need these.
_ADVANCED_IN_A_FORM = {
    "s_srs", "cutline", "clip-low", "clip-high", "scale-above", "scale-below", "tilesize", "resampling",
    "overview-resampling", "exclude", "xyz", "decimate", "compress", "cesium", "report", "if", "oo", "dem-step", "max-findings", "ignore",
}  # fmt: skip
_LABELLED_UNITS = {"tilesize", "dem-step"}


def form_rows(described, names=None):
    """The rows of a parsed `--options-json` that a form shows: all that mean something there, or those named, in the
    order of the names."""
    if names is not None:
        by_name = {row["name"]: row for row in described["options"]}
        return [by_name[name] for name in names if name in by_name]
    return [
        row
        for row in described["options"]
        if row["name"] not in LEFT_OUT
        and row["group"] != "Information"
        and not row.get("ignored")
        and not row.get("commandLineOnly")
        and ("default" in row or "whenUnset" in row or row.get("position"))
    ]


def parameter_name(row):
    """MAX_ERROR for max-error, as the creation option of the GDAL driver. What an algorithm begins with is INPUT."""
    if row.get("position") == 1:
        return "INPUT"
    return row["name"].upper().replace("-", "_")


def _method(row):
    """"collapse" where a row belongs to that method."""
    methods = row.get("methods", [])
    return methods[0] if len(methods) == 1 else "point sets" if methods else ""


def _plain(name):
    return name.replace("-", " ").replace("_", " ").capitalize()


def label(row):
    text = _LABELS.get(row["name"]) or _plain(row["name"])
    if _method(row):
        text = f"{_method(row)}: {text[0].lower() + text[1:]}"
    if row.get("unit") and row["name"] not in _LABELLED_UNITS:
        text += f" [{row['unit']}]"
    return text


def is_advanced(row):
    return bool(row.get("advanced")) or row["group"] == "Running" or row["name"] in _ADVANCED_IN_A_FORM


def is_on(row):
    return row.get("default") == "on"


_SPEC_HELP = "One value, or one per zoom: 5000/2^z; 500,200,100; 0-9:2000/2^z,10-:0.5."


def _in_words_of_the_form(text):
    """--max-error becomes 'Max error', OUTPUT the terrain folder; a form has no exit code."""
    text = re.sub(r" Exit code [^.]*\.", "", text)
    text = re.sub(r"\b(an )?OUTPUT\b", "the terrain folder", text)
    text = re.sub(r"\bINPUT\b", "the DEM", text)
    return re.sub(r"--([a-z][a-z0-9_-]*[a-z0-9])", lambda m: _LABELS.get(m.group(1)) or f"'{_plain(m.group(1))}'", text)


def help_text(row):
    """The row's sentence, choices and default, for a tooltip and for qgis_process."""
    text = _in_words_of_the_form(row["help"])
    text += "".join(f" {c['name']}: {c['help']}." for c in row.get("choices", []) if "help" in c)
    if row["type"] == "spec":
        text += " " + _SPEC_HELP
    if row.get("whenUnset", "none") != "none" and not row.get("position"):
        text += f" Default: {_in_words_of_the_form(row['whenUnset'])}."
    return text


def option_help(described, shown):
    """The options everybody uses, by group, for the panel beside the form."""
    common = [row for row in shown if not is_advanced(row) and not row.get("position")]
    text = ""
    for group in described["groups"]:
        members = [row for row in common if row["group"] == group["name"]]
        if members:
            text += f"<h3>{html.escape(group['name'], False)}</h3>"
            text += "".join(f"<p><b>{html.escape(label(r), False)}</b>: {html.escape(help_text(r), False)}</p>" for r in members)
    return text


class BadTable(Exception):
    """The table of values per zoom cannot be read; says why."""


def _cell_text(cell):
    """QGIS makes numbers of the cells that look like one."""
    if isinstance(cell, float) and cell.is_integer():
        cell = int(cell)
    return "" if cell is None else str(cell).strip()


TABLE_HEADERS = ["Option", "Zooms", "Value"]


def spec_of_table(cells, spec_rows):
    """Option name -> SPEC from the flat cells of a table with TABLE_HEADERS. Lines without zooms and value count as
    empty. An option may have many lines."""
    known = {name: row["name"] for row in spec_rows for name in (row["name"], parameter_name(row), label(row))}
    specs = {}
    if len(cells) % 3:
        raise BadTable(f"The table of values per zoom has {len(cells)} cells: three a line are expected.")
    for k in range(0, len(cells), 3):
        option, zooms, value = map(_cell_text, cells[k : k + 3])
        if not zooms and not value:
            continue
        option = option.lstrip("-")
        if option not in known:
            names = ", ".join(row["name"] for row in spec_rows)
            raise BadTable(f"The table of values per zoom names '{option}'; expected one of {names}.")
        if not zooms or not value:
            raise BadTable(f"The table of values per zoom has a line of {option} without {'value' if zooms else 'zooms'}.")
        name = known[option]
        specs[name] = f"{specs[name]},{zooms}:{value}" if name in specs else f"{zooms}:{value}"
    return specs
