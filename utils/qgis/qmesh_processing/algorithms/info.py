# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""qmeshinfo as two forms: Terrain information and validation, Measure error against DEM."""

import json

from qgis.core import (
    QgsProcessingOutputBoolean,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
)

from .. import command, form, report, rows
from .base import Algorithm

REPORT, JSON = "REPORT", "JSON"


class InfoAlgorithm(Algorithm):
    """`ROWS` are the options of qmeshinfo that the form shows, `TICKED` its flags that are on to begin with, `NUMBERS`
    the outputs: name -> label."""

    COMMAND = "qmeshinfo"
    TAGS = ["qmeshinfo"]
    ROWS = ()
    TICKED = ()
    NUMBERS = {}

    def shortHelpString(self):
        described = command.options_json(self.COMMAND)
        text = super().shortHelpString()
        return text + rows.option_help(described, rows.form_rows(described, self.ROWS)) if described else text

    def initAlgorithm(self, configuration=None):
        described = command.options_json(self.COMMAND)
        if described:
            for parameter in form.parameters(rows.form_rows(described, self.ROWS), self.TICKED):
                self.addParameter(parameter)
        else:
            # Without the command there is no form, but the algorithm says so when it is opened.
            self.addParameter(QgsProcessingParameterFile("INPUT", "Terrain folder", QgsProcessingParameterFile.Folder))
        self.addParameter(
            QgsProcessingParameterFileDestination(REPORT, "Report", "HTML files (*.html)", optional=True)
        )
        self.addParameter(
            QgsProcessingParameterFileDestination(
                JSON, "Report for programs", "JSON files (*.json)", optional=True, createByDefault=False
            )
        )
        for name, label in self.NUMBERS.items():
            self.addOutput(QgsProcessingOutputNumber(name, label))

    def processAlgorithm(self, parameters, context, feedback):
        shown = rows.form_rows(command.described(self.COMMAND), self.ROWS)
        words = form.command_line(shown, form.Form(self, parameters, context, feedback))
        found = command.run_json(self.COMMAND, ["--json", *words], feedback, (command.DONE, command.FINDINGS))
        if found is None:
            return {}
        results = self.results(found, feedback)
        if "--error-raster" in words:
            results["ERROR_RASTER"] = words[words.index("--error-raster") + 1]
        for name, text in ((REPORT, report.page(found)), (JSON, json.dumps(found, indent=2) + "\n")):
            path = self.parameterAsFileOutput(parameters, name, context)
            if path:
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
                results[name] = path
        return results

    def results(self, found, feedback):
        """The outputs from what qmeshinfo found; tells the user the gist of it."""
        raise NotImplementedError


class Info(InfoAlgorithm):
    NAME = "info"
    TITLE = "Terrain information and validation"
    SENTENCE = (
        "Describes any quantized-mesh tileset and validates it: the specification, meshes, seams, layer.json and known "
        "problems of viewers. Each finding has a number and a suggested fix."
    )
    ROWS = ("set", "stats", "validate", "zoom", "max-findings", "ignore", "num-threads")
    TICKED = ("stats", "validate")
    NUMBERS = {
        "TILES": "Tiles",
        "TRIANGLE_COUNT": "Triangles",
        "BYTES": "Bytes",
        "ERRORS": "Findings that are errors",
        "WARNINGS": "Findings that are warnings",
        "NOTES": "Findings that are notes",
    }

    def initAlgorithm(self, configuration=None):
        super().initAlgorithm(configuration)
        self.addOutput(QgsProcessingOutputBoolean("VALID", "No finding is an error"))

    def results(self, found, feedback):
        # No levels: one tile alone was looked at.
        results = {"TILES": sum(level["tiles"] for level in found["levels"]) if "levels" in found else 1}
        if "stats" in found:
            levels = found["stats"]["levels"]
            results["TRIANGLE_COUNT"] = sum(level["triangles"] for level in levels)
            results["BYTES"] = sum(level["bytes"] for level in levels)
        if "validation" in found:
            validation = found["validation"]
            results.update({name: validation[name.lower()] for name in ("ERRORS", "WARNINGS", "NOTES")})
            results["VALID"] = validation["errors"] == 0
            _tell(validation, feedback)
        return results


def _tell(validation, feedback):
    tell = {"error": feedback.reportError, "warning": feedback.pushWarning}
    for finding in validation["findings"]:
        text = f"{finding['code']}: {finding['title']} ({finding['count']}). {finding['cure']}"
        tell.get(finding["severity"], feedback.pushInfo)(text)
    feedback.pushInfo(report.verdict(validation))


class Measure(InfoAlgorithm):
    NAME = "measure"
    TITLE = "Measure error against DEM"
    SENTENCE = (
        "Measures how far each zoom of a terrain is from the DEM it was made from, at the cells of the DEM itself: largest, "
        "mean and root mean square error, and the one 99 % of the cells stay below."
    )
    ROWS = ("set", "dem", "band", "srcnodata", "bathymetry", "zoom", "s_srs", "dem-step", "oo", "if", "num-threads",
            "error-raster")  # fmt: skip
    TAGS = ["qmeshinfo", "accuracy", "difference"]
    NUMBERS = {
        "ZOOM_MEASURED": "Deepest zoom measured",
        "MAX": "Its largest error [m]",
        "RMS": "Its root mean square error [m]",
        "MEAN": "Its mean error [m]",
        "P99": "Error that 99 % of its cells stay below [m]",
    }

    def results(self, found, feedback):
        measured = [level for level in found["dem"]["levels"] if level["cells"]]
        for level in measured:
            feedback.pushInfo(
                f"zoom {level['zoom']}: largest {level['max']:.3f} m, rms {level['rms']:.3f} m, "
                f"99 % below {level['p99']:.3f} m, {level['uncovered']} cells not covered"
            )
        if not measured:
            feedback.pushWarning("The terrain and the DEM do not meet: nothing was measured.")
            return {}
        deepest = measured[-1]
        return {"ZOOM_MEASURED": deepest["zoom"], **{n: deepest[n.lower()] for n in ("MAX", "RMS", "MEAN", "P99")}}
