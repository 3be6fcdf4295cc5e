# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Option rows as parameters of Processing, and a filled form as the words of a command line."""

from qgis.core import QgsProcessingException, QgsProcessingParameterDefinition, QgsProcessingParameterMatrix

from . import rows
from .fields import Dem, Flag, fields

TABLE = "PER_ZOOM"


class Form:
    """What a user chose, for one run of an algorithm."""

    def __init__(self, algorithm, parameters, context, feedback):
        self.algorithm = algorithm
        self.parameters = parameters
        self.context = context
        self.feedback = feedback

    def given(self, name):
        return self.parameters.get(name) is not None

    def text(self, name):
        return self.algorithm.parameterAsString(self.parameters, name, self.context).strip()


def _spec_rows(shown):
    return [row for row in shown if row["type"] == "spec"]


def _table(specs):
    """The parameter of values per zoom: lines for the specs that everybody uses stand in it already."""
    cells = [cell for row in specs if not rows.is_advanced(row) for cell in (row["name"], "", "")]
    table = QgsProcessingParameterMatrix(
        TABLE, "Values per zoom (table)", len(cells) // 3, False, rows.TABLE_HEADERS, cells, optional=True
    )
    names = ", ".join(row["name"] for row in specs)
    table.setHelp(
        f"Another way to write options that may differ per zoom ({names}): a line each for an option, its zooms (3, "
        "0-9 or 10-) and the value there (a number or a formula as 2000/2^z). Lines without zooms and value do not count."
    )
    return table


def parameters(shown, ticked=()):
    """The parameters of rows, in their order; the table of values per zoom follows the last common SPEC. Flags named in
    `ticked` are on to begin with."""
    made, specs = [], _spec_rows(shown)
    common = [row["name"] for row in specs if not rows.is_advanced(row)]
    for item in fields(shown):
        parameter = item.parameter()
        parameter.setHelp(rows.help_text(item.row))
        if item.row["name"] in ticked:
            parameter.setDefaultValue(True)
        if rows.is_advanced(item.row):
            parameter.setFlags(parameter.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
        made.append(parameter)
        if common and item.row["name"] == common[-1]:
            made.append(_table(specs))
    return made


def command_line(shown, form):
    """The words after the command's name: options that differ from their defaults, then the arguments."""
    options, arguments = [], []
    for item in fields(shown):
        if item.row.get("position"):
            arguments += item.words(form)
            options += item.options(form) if isinstance(item, Dem) else []
        elif form.given(item.name) or isinstance(item, Flag):
            options += item.words(form)
    return options + _table_words(_spec_rows(shown), form, options) + arguments


def _table_words(specs, form, options):
    cells = form.algorithm.parameterAsMatrix(form.parameters, TABLE, form.context) if form.given(TABLE) else []
    try:
        written = rows.spec_of_table(cells, specs)
    except rows.BadTable as fault:
        raise QgsProcessingException(str(fault)) from fault
    for name in written:
        if "--" + name in options:
            raise QgsProcessingException(f"{name} is given twice, as a value and in the table of values per zoom.")
    return [word for name, spec in written.items() for word in ("--" + name, spec)]
