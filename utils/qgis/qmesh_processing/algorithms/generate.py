# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Generate quantized-mesh terrain: gdal2qmesh as a form."""

import json

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingOutputNumber,
    QgsProcessingOutputRasterLayer,
    QgsProcessingOutputVectorLayer,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterRasterLayer,
    QgsProcessingUtils,
)

from .. import command, form, gdal_driver, rows
from .base import Algorithm

LOAD_RASTER, LOAD_TRIANGLES = "LOAD_RASTER", "LOAD_TRIANGLES"
RASTER, TRIANGLES = "RASTER", "TRIANGLES"
# Outputs that are numbers of the report's total.
_NUMBERS = {
    "TILES": ("tiles", "Tiles"),
    "TRIANGLE_COUNT": ("triangles", "Triangles"),
    "BYTES": ("bytes", "Bytes"),
    "ERROR_REACHED": ("errorReached", "Largest error [m]"),
}


class Generate(Algorithm):
    NAME = "generate"
    TITLE = "Generate quantized-mesh terrain"
    SENTENCE = (
        "Turns an elevation or bathymetry raster into a folder of quantized-mesh tiles for CesiumJS and its relatives: "
        "without seams, and within an error you choose."
    )
    TAGS = ["gdal2qmesh", "elevation", "bathymetry", "tin"]
    COMMAND = "gdal2qmesh"

    def shortHelpString(self):
        described = command.options_json(self.COMMAND)
        text = super().shortHelpString()
        return text + rows.option_help(described, rows.form_rows(described)) if described else text

    def initAlgorithm(self, configuration=None):
        described = command.options_json(self.COMMAND)
        if described:
            for parameter in form.parameters(rows.form_rows(described)):
                self.addParameter(parameter)
        else:
            # Without the command there is no form, but the algorithm says so when it is opened.
            self.addParameter(QgsProcessingParameterRasterLayer("INPUT", "DEM"))
            self.addParameter(QgsProcessingParameterFolderDestination("OUTPUT", "Terrain folder"))
        self.addParameter(
            QgsProcessingParameterBoolean(LOAD_RASTER, "Open the terrain as a raster layer when done", defaultValue=True)
        )
        self.addParameter(
            QgsProcessingParameterBoolean(LOAD_TRIANGLES, "Open the triangles of the last zoom when done", defaultValue=False)
        )
        self.addOutput(QgsProcessingOutputRasterLayer(RASTER, "Terrain as a raster layer"))
        self.addOutput(QgsProcessingOutputVectorLayer(TRIANGLES, "Triangles of the last zoom"))
        for name, (_, label) in _NUMBERS.items():
            self.addOutput(QgsProcessingOutputNumber(name, label))

    def processAlgorithm(self, parameters, context, feedback):
        described = command.described(self.COMMAND)
        words = form.command_line(rows.form_rows(described), form.Form(self, parameters, context, feedback))
        folder = words[-1]
        results = {"OUTPUT": folder}
        if "--report" in words:
            report = results["REPORT"] = words[words.index("--report") + 1]
        else:
            report = QgsProcessingUtils.generateTempFilename("report.json")
            words = ["--report", report, *words]
        if not command.run(self.COMMAND, words, feedback):
            return {}
        results.update(_numbers(report))
        results.update(self._layers(folder, parameters, context, feedback))
        return results

    def _layers(self, folder, parameters, context, feedback):
        """The terrain as layers for what comes after, opened in the project where that is wanted."""
        if not gdal_driver.register():
            feedback.pushWarning(gdal_driver.MISSING)
            return {}
        layers = {RASTER: folder, TRIANGLES: gdal_driver.triangles(folder)}
        hints = {RASTER: QgsProcessingUtils.LayerHint.Raster, TRIANGLES: QgsProcessingUtils.LayerHint.Vector}
        names = {RASTER: "Terrain", TRIANGLES: "Triangles"}
        for output, wanted in ((RASTER, LOAD_RASTER), (TRIANGLES, LOAD_TRIANGLES)):
            if self.parameterAsBool(parameters, wanted, context) and context.project() is not None:
                details = QgsProcessingContext.LayerDetails(names[output], context.project(), output, hints[output])
                context.addLayerToLoadOnCompletion(layers[output], details)
        return layers


def _numbers(report):
    with open(report, encoding="utf-8") as file:
        total = json.load(file)["total"]
    return {name: total[key] for name, (key, _) in _NUMBERS.items()}
