#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The tables of options in docs/reference, made from what the programs say of themselves.

    python3 docs/make_reference.py            writes them
    python3 docs/make_reference.py --check    says which differ, exit code 1 where one does

The programs are those of build/bin (QMESH_BIN names another gdal2qmesh, the others lie beside it).
"""

import json
import os
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as etree

DOCS = pathlib.Path(__file__).resolve().parent
BIN = pathlib.Path(os.environ.get("QMESH_BIN", DOCS.parent / "build/bin/gdal2qmesh")).parent


def said_by(program, *words):
    return subprocess.run([BIN / program, *words], check=True, capture_output=True, text=True).stdout


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def switches(row):
    """How the option is written: letter, names and placeholder, as code."""
    if row.get("position"):
        return f"`{row['placeholder']}`"
    on = row["type"] == "flag" and row.get("default") == "on"
    names = [f"-{row['letter']}"] if "letter" in row else []
    names.append(("--[no-]" if on else "--") + row["name"])
    names += [f"--{alias}" for alias in row.get("aliases", [])]
    value = f" {row['placeholder']}" if row.get("placeholder") else ""
    return f"`{cell(', '.join(names) + value)}`"


def number(value):
    if value == int(value):
        return str(int(value))
    return f"{value:g}" if len(repr(value)) < 10 else f"1/{round(1 / value)}"


def value_range(row):
    if "minimum" not in row or row.get("choices"):
        return row.get("unit", "")
    high = f" to {number(row['maximum'])}" if "maximum" in row else " or more"
    return f"{number(row['minimum'])}{high} {row.get('unit', '')}".strip()


def meaning(row):
    text = cell(row["help"])
    choices = [f"`{c['name']}`" + (f": {cell(c['help'])}" if c.get("help") else "") for c in row.get("choices", [])]
    if choices:
        text += " " + "; ".join(choices) + "."
    methods = row.get("methods", [])
    only = f"method{'s' if len(methods) > 1 else ''} {', '.join(methods)}" if methods else ""
    notes = [only, value_range(row), "repeatable" if row.get("repeatable") else "", "advanced" if row.get("advanced") else ""]
    notes = [note for note in notes if note]
    return text + (f" *({', '.join(notes)})*" if notes else "")


def default(row):
    value = row.get("default", "")
    if value and value != "off":
        return f"`{cell(value)}`"
    return "" if value else cell(row.get("whenUnset", ""))


def option_groups(program):
    """The groups that have options, each with its rows."""
    said = json.loads(said_by(program, "--options-json"))
    for group in said["groups"]:
        rows = [row for row in said["options"] if row["group"] == group["name"]]
        if rows:
            yield group, rows


def options_table(program):
    """Without headings: Sphinx would take them out of the part that is for HTML only."""
    lines = []
    for group, rows in option_groups(program):
        lines += [f"**{group['name']}**: {group['help']}.", ""]
        lines += ["| option | meaning | default |", "|---|---|---|"]
        lines += [f"| {switches(row)} | {meaning(row)} | {default(row)} |" for row in rows]
        lines.append("")
    return "\n".join(lines)


def options_list(program):
    """The same as a list of definitions, for the man page: a terminal is too narrow for the table."""
    lines = []
    for group, rows in option_groups(program):
        lines += [f"**{group['name']}**: {group['help']}.", ""]
        for row in rows:
            value = default(row)
            lines += [switches(row).replace("\\|", "|"), f": {meaning(row)}{f' Default: {value}.' if value else ''}", ""]
    return "\n".join(lines)


def findings_page():
    """What `qmeshinfo --validate` can say, group by group, as a list of definitions."""
    kinds = json.loads(said_by("qmeshinfo", "--json", "--list-findings"))["findings"]
    lines = []
    for group in dict.fromkeys(kind["group"] for kind in kinds):
        lines += [f"### {group}: findings", ""]
        for kind in kinds:
            if kind["group"] == group:
                lines += [f"{kind['code']} ({kind['severity']}): {cell(kind['title'])}"]
                lines += [f": {cell(kind['explanation'])} *{cell(kind['cure'])}*", ""]
    return "\n".join(lines)


def driver_options(kind):
    """The table of one list of options that gdalinfo shows of the driver."""
    environment = {**os.environ, "GDAL_DRIVER_PATH": str(BIN.parent / "gdalplugins")}
    said = subprocess.run(["gdalinfo", "--format", "QMESH"], check=True, capture_output=True, text=True,
                          env=environment).stdout
    begin, end = f"<{kind}>", f"</{kind}>"
    options = etree.fromstring(said[said.index(begin):said.index(end) + len(end)])
    lines = ["| option | values | meaning | default |", "|---|---|---|---|"]
    for option in options:
        values = ", ".join(f"`{value.text}`" for value in option.findall("Value")) or VALUES[option.get("type")]
        if option.get("max") and len(option.get("max")) < 9:
            values += f" from {option.get('min')} to {option.get('max')}"
        text, _, unset = option.get("description").partition(" Default: ")
        chosen = f"`{option.get('default')}`" if option.get("default") else unset.rstrip(".")
        lines.append(f"| `{option.get('name')}` | {values} | {cell(text)} | {cell(chosen)} |")
    return "\n".join(lines)


VALUES = {"boolean": "`YES`, `NO`", "int": "whole number", "float": "number", "string": "text"}

PAGES = {
    "creation-options.md": lambda: driver_options("CreationOptionList"),
    "open-options.md": lambda: driver_options("OpenOptionList"),
    "options-gdal2qmesh.md": lambda: options_table("gdal2qmesh"),
    "options-gdal2qmesh-list.md": lambda: options_list("gdal2qmesh"),
    "options-qmeshinfo.md": lambda: options_table("qmeshinfo"),
    "options-qmeshinfo-list.md": lambda: options_list("qmeshinfo"),
    "findings.md": findings_page,
}


def main():
    check = "--check" in sys.argv[1:]
    stale = []
    for name, make in PAGES.items():
        path, text = DOCS / "reference" / name, make().rstrip() + "\n"
        if path.exists() and path.read_text() == text:
            continue
        stale.append(name)
        if not check:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)
    if check and stale:
        print("docs/reference is not what the programs say; run docs/make_reference.py:", *stale)
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
