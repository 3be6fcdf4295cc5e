# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Extract triangles: the meshes of a terrain as vector features of any format."""

import os

from osgeo import gdal
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterEnum,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFile,
    QgsProcessingParameterNumber,
    QgsProcessingParameterVectorDestination,
    QgsVectorFileWriter,
)

from .. import gdal_driver
from .base import Algorithm

# What is extracted: layer of the driver, its open option GEOMETRY, sentence.
WHAT = {
    "polygons": ("triangles", "POLYGONS", "a polygon for each triangle"),
    "multipolygons": ("triangles", "MULTIPOLYGON", "a multipolygon for each tile"),
    "tin": ("triangles", "TIN", "a TIN for each tile"),
    "vertices": ("vertices", "POINTS", "a point for each vertex"),
    "tiles": ("tiles", "POLYGONS", "the footprint of each tile, with counts, bytes, heights and error"),
}


class Triangles(Algorithm):
    NAME = "triangles"
    TITLE = "Extract triangles"
    SENTENCE = (
        "Writes the triangles, vertices or tile footprints of one zoom of a terrain to any vector format, within an extent "
        "where one is given; only the tiles it meets are read. Heights are the Z of the geometries."
    )
    TAGS = ["tin", "mesh", "vector", "polygons"]

    def initAlgorithm(self, configuration=None):
        self.addParameter(QgsProcessingParameterFile("INPUT", "Terrain folder", QgsProcessingParameterFile.Folder))
        what = QgsProcessingParameterEnum(
            "WHAT", "What to extract", list(WHAT), defaultValue="polygons", usesStaticStrings=True
        )
        what.setHelp(" ".join(f"{name}: {sentence}." for name, (_, _, sentence) in WHAT.items()))
        zoom = QgsProcessingParameterNumber("ZOOM", "Zoom", optional=True, minValue=0, maxValue=24)
        zoom.setHelp("Default: the last zoom of the terrain.")
        self.addParameter(what)
        self.addParameter(zoom)
        self.addParameter(QgsProcessingParameterExtent("EXTENT", "Extent", optional=True))
        self.addParameter(
            QgsProcessingParameterVectorDestination("OUTPUT", "Triangles", QgsProcessing.TypeVectorAnyGeometry)
        )

    def processAlgorithm(self, parameters, context, feedback):
        if not gdal_driver.register():
            raise QgsProcessingException(gdal_driver.MISSING)
        source = self.parameterAsString(parameters, "INPUT", context)
        layer, geometry, _ = WHAT[self.parameterAsEnumString(parameters, "WHAT", context)]
        options = [f"GEOMETRY={geometry}"]
        if parameters.get("ZOOM") is not None:
            options.append(f"ZOOM={self.parameterAsInt(parameters, 'ZOOM', context)}")
        output = self.parameterAsOutputLayer(parameters, "OUTPUT", context)
        box = self.parameterAsExtent(parameters, "EXTENT", context)
        filters = {}
        if not box.isNull():
            crs = self.parameterAsExtentCrs(parameters, "EXTENT", context)
            filters["spatFilter"] = (box.xMinimum(), box.yMinimum(), box.xMaximum(), box.yMaximum())
            filters["spatSRS"] = (crs if crs.isValid() else QgsCoordinateReferenceSystem("EPSG:4326")).toWkt()
        written = _translate(source, options, output, {"layers": [layer], **filters}, feedback)
        return {"OUTPUT": output} if written else {}


def _translate(source, open_options, output, options, feedback):
    """ogr2ogr in this process, with the messages of GDAL as the exception's words. False where the user cancelled; then
    nothing is left of the output."""

    def progress(done, _message, _data):
        feedback.setProgress(100 * done)
        return 0 if feedback.isCanceled() else 1

    gdal.ErrorReset()
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        terrain = gdal.OpenEx(source, gdal.OF_VECTOR, [gdal_driver.NAME], open_options)
        if terrain is None:
            raise QgsProcessingException(gdal.GetLastErrorMsg() or f"{source} is no quantized-mesh terrain.")
        driver = gdal.GetDriverByName(QgsVectorFileWriter.driverForExtension(os.path.splitext(output)[1]))
        if driver is None:
            raise QgsProcessingException(f"GDAL writes no vector format that {output} could be: change its extension.")
        written = gdal.VectorTranslate(output, terrain, format=driver.ShortName, callback=progress, **options)
        failed = written is None
        message = gdal.GetLastErrorMsg()
        del written  # closes the file
        if feedback.isCanceled():
            driver.Delete(output)
            return False
        if failed:
            raise QgsProcessingException(message or f"{output} cannot be written.")
        return True
    finally:
        gdal.PopErrorHandler()
