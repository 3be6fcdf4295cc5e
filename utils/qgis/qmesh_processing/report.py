# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The JSON of qmeshinfo as a page for the results viewer. Knows nothing of QGIS."""

import html

_STYLE = (
    "body{font-family:sans-serif} table{border-collapse:collapse} th,td{padding:2px 8px;text-align:right;"
    "border-bottom:1px solid #ccc} th:first-child,td:first-child{text-align:left} .error{color:#b00020}"
    ".warning{color:#9a5b00} .note{color:#555}"
)


def _text(value):
    if value is None:
        return ""
    return f"{value:.3f}".rstrip("0").rstrip(".") if isinstance(value, float) else html.escape(str(value))


def _table(columns, lines):
    """`columns` are pairs of key and heading; columns that no line fills are left out."""
    used = [(key, heading) for key, heading in columns if any(line.get(key) is not None for line in lines)]
    head = "".join(f"<th>{html.escape(heading)}</th>" for _, heading in used)
    body = "".join("<tr>" + "".join(f"<td>{_text(line.get(key))}</td>" for key, _ in used) + "</tr>" for line in lines)
    return f"<table><tr>{head}</tr>{body}</table>"


def _values(described, keys, heading):
    """What there is of these keys, a line each."""
    lines = [{"key": key, "value": described.get(key)} for key in keys if described.get(key) not in (None, "", [])]
    for line in lines:
        if isinstance(line["value"], list):
            line["value"] = ", ".join(_text(part) for part in line["value"])
    return _table([("key", heading), ("value", "")], lines)


def _description(layer):
    keys = ("name", "description", "attribution", "version", "projection", "scheme", "bounds", "extensions", "generator",
            "method", "cellsPerTile")  # fmt: skip
    return _values(layer, keys, "layer.json")


def _tile(tile):
    keys = ("tile", "box", "bytes", "triangles", "vertices", "minHeight", "maxHeight", "lowest", "highest", "extensions")
    return _values(tile, keys, "tile")


def _levels(described):
    """What layer.json says of each level, joined with what its tiles were found to be."""
    found = {level["zoom"]: level for level in described.get("stats", {}).get("levels", [])}
    lines = [{**found.get(level["zoom"], {}), **level} for level in described["levels"]]
    columns = [
        ("zoom", "zoom"), ("tiles", "tiles"), ("bytes", "bytes"), ("triangles", "triangles"), ("vertices", "vertices"),
        ("lowest", "lowest m"), ("highest", "highest m"), ("maxError", "max error m"), ("errorReached", "reached m"),
    ]  # fmt: skip
    return "<h3>Levels</h3>" + _table(columns, lines)


def _validation(validation):
    text = f"<h3>Validation</h3><p>{verdict(validation)}</p>"
    for finding in validation["findings"]:
        places = "; ".join(": ".join(filter(None, (p["place"], p.get("what")))) for p in finding["places"])
        text += (
            f"<h4 class='{html.escape(finding['severity'])}'>{_text(finding['code'])} {_text(finding['severity'])}: "
            f"{_text(finding['title'])} ({_text(finding['count'])})</h4>"
            f"<p>{_text(finding['explanation'])} {_text(finding['cure'])}</p><p>{_text(places)}</p>"
        )
    return text


def _measured(dem):
    columns = [
        ("zoom", "zoom"), ("cells", "cells"), ("uncovered", "not covered"), ("max", "largest m"), ("rms", "rms m"),
        ("mean", "mean m"), ("p99", "99 % below m"),
    ]  # fmt: skip
    return f"<h3>Error against {_text(dem['file'])}</h3>" + _table(columns, dem["levels"])


def verdict(validation):
    return (
        f"{validation['errors']} errors, {validation['warnings']} warnings, {validation['notes']} notes in "
        f"{validation['tiles']} tiles and {validation['seams']} seams."
    )


def page(described):
    """A page of all that is there."""
    body = f"<h2>{_text(described['set'])}</h2>"
    if "layer" in described:
        body += _description(described["layer"]) + _levels(described)
    if "tile" in described:
        body += _tile(described["tile"])
    if "validation" in described:
        body += _validation(described["validation"])
    if "dem" in described:
        body += _measured(described["dem"])
    return f"<!DOCTYPE html><html><head><meta charset='utf-8'><style>{_STYLE}</style></head><body>{body}</body></html>\n"
