# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""One class a kind of field: the parameter it shows for an option row, and the words it says on the command line."""

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterBand,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterCrs,
    QgsProcessingParameterEnum,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
    QgsProcessingParameterVectorLayer,
    QgsProcessingUtils,
    QgsProviderRegistry,
    QgsRasterLayer,
)

from . import rows

# Files that the command writes, with the filter of the file dialog.
_WRITTEN = {"report": "JSON files (*.json)"}
_WRITTEN_FOLDERS = {"debug-meshes"}


class Field:
    """`words(form)` is called only where the user gave a value."""

    def __init__(self, row):
        self.row = row
        self.name = rows.parameter_name(row)
        self.label = rows.label(row)
        self.optional = "whenUnset" in row

    def option(self, *values):
        return ["--" + self.row["name"], *values] if values and values[0] != "" else []


class Flag(Field):
    def parameter(self):
        return QgsProcessingParameterBoolean(self.name, self.label, defaultValue=rows.is_on(self.row))

    def words(self, form):
        on = form.algorithm.parameterAsBool(form.parameters, self.name, form.context)
        if on == rows.is_on(self.row):
            return []
        return ["--" + self.row["name"] if on else "--no-" + self.row["name"]]


class Text(Field):
    """Any text the command understands: SPEC, memory, threads, ..."""

    def parameter(self):
        return QgsProcessingParameterString(
            self.name, self.label, defaultValue=self.row.get("default"), optional=self.optional
        )

    def words(self, form):
        text = form.text(self.name)
        return [] if text == self.row.get("default") else self.option(text)


class Lines(Field):
    """A repeatable option: one use a line."""

    def parameter(self):
        return QgsProcessingParameterString(self.name, self.label, multiLine=True, optional=True)

    def words(self, form):
        lines = [line.strip() for line in form.text(self.name).splitlines()]
        return [word for line in lines for word in self.option(line)]


class Number(Field):
    def _limits(self):
        limits = {"minValue": self.row.get("minimum"), "maxValue": self.row.get("maximum")}
        return {name: value for name, value in limits.items() if value is not None}

    def parameter(self):
        whole = self.row["type"] == "integer"
        kind = QgsProcessingParameterNumber.Integer if whole else QgsProcessingParameterNumber.Double
        default = self.row.get("default")
        return QgsProcessingParameterNumber(
            self.name,
            self.label,
            kind,
            None if default is None else (int if whole else float)(default),
            self.optional,
            **self._limits(),
        )

    def words(self, form):
        if self.row["type"] == "integer":
            number = form.algorithm.parameterAsInt(form.parameters, self.name, form.context)
        else:
            number = form.algorithm.parameterAsDouble(form.parameters, self.name, form.context)
        default = self.row.get("default")
        return [] if default is not None and number == float(default) else self.option(repr(number))


class Band(Number):
    """Of the raster in the parameter `RASTER`."""

    RASTER = "INPUT"

    def parameter(self):
        # Optional, because QGIS 3.22 asks for a band even where there is a default.
        return QgsProcessingParameterBand(self.name, self.label, int(self.row["default"]), self.RASTER, optional=True)


class BandOfDem(Band):
    RASTER = "DEM"


class Choice(Field):
    def parameter(self):
        return QgsProcessingParameterEnum(
            self.name,
            self.label,
            [choice["name"] for choice in self.row["choices"]],
            defaultValue=self.row.get("default"),
            optional=self.optional,
            usesStaticStrings=True,
        )

    def words(self, form):
        value = form.algorithm.parameterAsEnumString(form.parameters, self.name, form.context)
        return [] if value == self.row.get("default") else self.option(value)


class OnOff(Field):
    """A choice of on and off is a check box here."""

    def parameter(self):
        return QgsProcessingParameterBoolean(self.name, self.label, defaultValue=rows.is_on(self.row))

    def words(self, form):
        on = form.algorithm.parameterAsBool(form.parameters, self.name, form.context)
        return [] if on == rows.is_on(self.row) else self.option("on" if on else "off")


class Crs(Field):
    def parameter(self):
        return QgsProcessingParameterCrs(self.name, self.label, optional=self.optional)

    def words(self, form):
        return self.option(crs_text(form.algorithm.parameterAsCrs(form.parameters, self.name, form.context)))


class Extent(Field):
    """With its CRS as --te-srs."""

    def parameter(self):
        return QgsProcessingParameterExtent(self.name, self.label, optional=self.optional)

    def words(self, form):
        box = form.algorithm.parameterAsExtent(form.parameters, self.name, form.context)
        if box.isNull():
            return []
        numbers = (box.xMinimum(), box.yMinimum(), box.xMaximum(), box.yMaximum())
        words = self.option(*map(repr, numbers))
        crs = crs_text(form.algorithm.parameterAsExtentCrs(form.parameters, self.name, form.context))
        return words + (["--te-srs", crs] if crs else [])


class Dem(Field):
    """A raster layer, or anything GDAL opens; its open options come along."""

    def parameter(self):
        return QgsProcessingParameterRasterLayer(self.name, self.label)

    def source(self, form):
        """The place of the raster as GDAL takes it, and its open options."""
        layer = form.algorithm.parameterAsRasterLayer(form.parameters, self.name, form.context)
        if not isinstance(layer, QgsRasterLayer):
            # Not a layer: the command says best what is wrong with it.
            return form.text(self.name), []
        if layer.providerType() != "gdal":
            raise QgsProcessingException(
                f"The layer '{layer.name()}' is not read by GDAL ({layer.providerType()}): export it to a file first."
            )
        return gdal_source(layer.source())

    def words(self, form):
        return [self.source(form)[0]]

    def options(self, form):
        return [word for option in self.source(form)[1] for word in ("--oo", option)]


class DemOption(Dem):
    """The DEM as a value of --dem."""

    def words(self, form):
        return self.option(super().words(form)[0]) + super().options(form)

    def options(self, form):
        return []


class Dems(Dem):
    """A row that takes many rasters."""

    def parameter(self):
        return QgsProcessingParameterMultipleLayers(self.name, self.label, QgsProcessing.TypeRaster)

    def words(self, form):
        layers = form.algorithm.parameterAsLayerList(form.parameters, self.name, form.context)
        if not layers:
            raise QgsProcessingException("No DEM that QGIS can open was chosen.")
        return [gdal_source(layer.source())[0] for layer in layers]

    def options(self, form):
        return []


class Cutline(Field):
    """Polygons of any layer; written to a file, because the command reads the first layer of one."""

    def parameter(self):
        return QgsProcessingParameterVectorLayer(
            self.name, self.label, [QgsProcessing.TypeVectorPolygon], optional=self.optional
        )

    def words(self, form):
        layer = form.algorithm.parameterAsVectorLayer(form.parameters, self.name, form.context)
        if layer is None:
            return self.option(form.text(self.name))
        path = QgsProcessingUtils.convertToCompatibleFormat(
            layer, False, "cutline", [], "gpkg", form.context, form.feedback
        )
        return self.option(path)


class InputPath(Field):
    def parameter(self):
        folder = self.row["type"] == "folder"
        behaviour = QgsProcessingParameterFile.Folder if folder else QgsProcessingParameterFile.File
        return QgsProcessingParameterFile(self.name, self.label, behaviour, optional=self.optional)

    def words(self, form):
        return self.option(form.text(self.name))


class WrittenFile(Field):
    def parameter(self):
        return QgsProcessingParameterFileDestination(
            self.name, self.label, _WRITTEN[self.row["name"]], optional=True, createByDefault=False
        )

    def words(self, form):
        return self.option(form.algorithm.parameterAsFileOutput(form.parameters, self.name, form.context))


class WrittenFolder(Field):
    def parameter(self):
        return QgsProcessingParameterFolderDestination(self.name, self.label, optional=True, createByDefault=False)

    def words(self, form):
        return self.option(form.text(self.name))


class WrittenRaster(Field):
    def parameter(self):
        return QgsProcessingParameterRasterDestination(self.name, self.label, optional=True, createByDefault=False)

    def words(self, form):
        return self.option(form.algorithm.parameterAsOutputLayer(form.parameters, self.name, form.context))


class Terrain(Field):
    """A folder; an address may be written there as well."""

    def parameter(self):
        return QgsProcessingParameterFile(self.name, self.label, QgsProcessingParameterFile.Folder)

    def words(self, form):
        return [form.text(self.name)]


class OutputFolder(Field):
    def parameter(self):
        return QgsProcessingParameterFolderDestination(self.name, self.label)

    def words(self, form):
        return [form.text(self.name)]


_BY_NAME = {"band": Band, "cutline": Cutline, "dem": DemOption, "error-raster": WrittenRaster}
_BY_TYPE = {
    "flag": Flag,
    "integer": Number,
    "number": Number,
    "choice": Choice,
    "srs": Crs,
    "extent": Extent,
    "file": InputPath,
    "folder": InputPath,
}


def fields(shown):
    """The field of each of the rows that a form shows."""
    made = [field(row) for row in shown]
    if any(isinstance(item, DemOption) for item in made):
        made = [BandOfDem(item.row) if isinstance(item, Band) else item for item in made]
    return made


def field(row):
    """The kind of field for a row; text for a type that is not known here."""
    if row.get("position"):
        if row["type"] in ("folder", "text"):
            return OutputFolder(row) if row["type"] == "folder" else Terrain(row)
        return Dems(row) if row.get("repeatable") else Dem(row)
    if row["name"] in _BY_NAME:
        return _BY_NAME[row["name"]](row)
    if row["name"] in _WRITTEN:
        return WrittenFile(row)
    if row["name"] in _WRITTEN_FOLDERS:
        return WrittenFolder(row)
    if row.get("repeatable"):
        return Lines(row)
    if row.get("choices"):
        names = {choice["name"] for choice in row["choices"]}
        return OnOff(row) if names == {"on", "off"} else Choice(row)
    return _BY_TYPE.get(row["type"], Text)(row)


def crs_text(crs):
    """A CRS as the commands take it; empty where it is not valid."""
    if not crs.isValid():
        return ""
    known = crs.authid()
    if known and not known.startswith("USER:"):
        return known
    return crs.toWkt(QgsCoordinateReferenceSystem.WKT_PREFERRED)


def gdal_source(source):
    """The path and the open options in the source of a raster layer read by GDAL."""
    parts = QgsProviderRegistry.instance().decodeUri("gdal", source)
    if parts.get("openOptions"):
        return parts["path"], list(parts["openOptions"])
    return source, []
