# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Sources in memory, trees of virtual files and what GDAL says, for the driver's tests."""

import contextlib
import hashlib

import dems
import harness
from osgeo import gdal, osr

SMALL = ["TILESIZE=32"]  # a DEM of some hundred cells makes a handful of tiles


def array_source(values, name="", driver="MEM", srs="EPSG:4326", transform=(10.0, 0.01, 0, 47.0, 0, -0.01), kind=None):
    """A dataset of an array, rows from the north."""
    rows, columns = values.shape
    kind = gdal.GDT_Float32 if kind is None else kind
    source = gdal.GetDriverByName(driver).Create(name, columns, rows, 1, kind)
    if transform is not None:
        source.SetGeoTransform(transform)
    if srs is not None:
        reference = osr.SpatialReference()
        reference.SetFromUserInput(srs)
        source.SetSpatialRef(reference)
    source.GetRasterBand(1).WriteArray(values)
    return source


def hilly(rows=60, columns=70, **options):
    return array_source(dems.hills(rows, columns), **options)


def read_file(path):
    handle = gdal.VSIFOpenL(path, "rb")
    assert handle is not None, path
    try:
        gdal.VSIFSeekL(handle, 0, 2)
        size = gdal.VSIFTellL(handle)
        gdal.VSIFSeekL(handle, 0, 0)
        return bytes(gdal.VSIFReadL(1, size, handle)) if size else b""
    finally:
        gdal.VSIFCloseL(handle)


def write_file(path, data):
    handle = gdal.VSIFOpenL(path, "wb")
    assert handle is not None, path
    gdal.VSIFWriteL(data, 1, len(data), handle)
    gdal.VSIFCloseL(handle)


def tree(folder):
    """Relative path -> sha256 of every file below a folder of any file system of GDAL's."""
    files = {}
    for name in gdal.ReadDirRecursive(str(folder)) or []:
        if not name.endswith("/"):
            files[name] = hashlib.sha256(read_file(f"{folder}/{name}")).hexdigest()
    return files


def tiles(folder):
    return {name: digest for name, digest in tree(folder).items() if name.endswith(".terrain")}


def command_tree(folder):
    """The same of a set that gdal2qmesh wrote."""
    return {name: digest for name, digest in harness.tree(folder).items() if digest is not None}


@contextlib.contextmanager
def config(name, value):
    """A configuration option of GDAL's, for a while."""
    before = gdal.GetConfigOption(name)
    gdal.SetConfigOption(name, value)
    try:
        yield
    finally:
        gdal.SetConfigOption(name, before)


@contextlib.contextmanager
def messages():
    """Collects what GDAL says meanwhile, as (class, number, text)."""
    said = []
    gdal.PushErrorHandler(lambda kind, number, text: said.append((kind, number, text)))
    try:
        yield said
    finally:
        gdal.PopErrorHandler()


def refused(action, *words, number=None):
    """Asserts that `action` fails with one error that says the words; returns its text."""
    with messages() as said:
        raised = None
        try:
            result = action()
        except RuntimeError as error:
            raised, result = error, None
    assert result is None or result != 0, "it was accepted"
    failures = [entry for entry in said if entry[0] >= gdal.CE_Failure]
    assert len(failures) == 1 or (raised is not None and not failures), failures
    text = failures[0][2] if failures else str(raised)
    for word in words:
        assert word.lower() in text.lower(), f"no {word!r} in: {text}"
    if number is not None:
        found = failures[0][1] if failures else gdal.GetLastErrorNo()
        assert found == number, f"error {found}: {text}"
    return text
