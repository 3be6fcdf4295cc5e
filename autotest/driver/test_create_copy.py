# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""CreateCopy writes what gdal2qmesh writes, from every kind of source to every kind of place."""

import json
import os
import subprocess

import dems
import numpy as np
import pytest
from osgeo import gdal

import harness
from made import SMALL, array_source, command_tree, hilly, messages, read_file, refused, tiles, tree, write_file

# (creation options, the same for the command)
RUNS = {
    "defaults": ([], []),
    "max-error": (["MAX_ERROR=5"], ["--max-error", "5"]),
    "per-zoom": (["MAX_ERROR=0-6:2000/2^z,7-:8", "ZOOM=0-9"], ["--max-error", "0-6:2000/2^z,7-:8", "-z", "0-9"]),
    "mercator-xyz": (["PROFILE=mercator", "XYZ=YES"], ["-p", "mercator", "--xyz"]),
    "plain": (["NORMALS=NO", "COMPRESS=none"], ["--no-normals", "--compress", "none"]),
    "metadata": (["METADATA=4", "RESAMPLING=cubic", "TITLE=A & B", "COPYRIGHT=(c) them"],
                 ["--metadata", "4", "-r", "cubic", "-t", "A & B", "-c", "(c) them"]),
    "all-nodes": (["METHOD=delaunay", "MAX_ZOOM=7"], ["--method", "delaunay", "--max-zoom", "7"]),
    "bridged": (["VOID_FILL=interpolate", "EXCLUDE=YES"], ["--void-fill", "interpolate", "-x"]),
    "heights": (["BATHYMETRY=YES", "CLIP_LOW=-50", "SCALE_BELOW=2"],
                ["--bathymetry", "--clip-low", "-50", "--scale-below", "2"]),
}


@pytest.mark.parametrize("run", RUNS)
def test_same_bytes_as_the_command(qmesh, dem, command_set, vsimem, run):
    options, words = RUNS[run]
    expected = command_set("jacksboro", "--tilesize", "64", *words)
    qmesh.CreateCopy(vsimem + "/set", gdal.Open(str(dem("jacksboro"))), options=["TILESIZE=64", *options])
    assert tree(vsimem + "/set") == command_tree(expected)


WIDE = {"global", "global_etopo", "north_pole", "south_pole"}  # thousands of tiles beyond zoom 4


@pytest.mark.parametrize("name", sorted(dems.DEMS))
def test_same_bytes_for_every_dem(qmesh, dem, command_set, tmp_path, name):
    zoom = "4" if name in WIDE else "9"
    expected = command_set(name, "--tilesize", "32", "--max-zoom", zoom)
    source = gdal.Open(str(dem(name)))
    qmesh.CreateCopy(str(tmp_path / "set"), source, options=["TILESIZE=32", "MAX_ZOOM=" + zoom])
    assert tree(tmp_path / "set") == command_tree(expected)


def test_gdal_translate(dem, command_set, tmp_path):
    expected = command_set("jacksboro", "--tilesize", "64", "--max-error", "5")
    command = ["gdal_translate", "-of", "QMESH", str(dem("jacksboro")), "out", "-co", "MAX_ERROR=5",
               "-co", "tilesize=64"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.rstrip().endswith("100 - done.") and not done.stderr
    assert tree(tmp_path / "out") == command_tree(expected)
    assert harness.hidden_files(tmp_path / "out") == []


def sources(folder, path):
    """Kinds of source that all hold the pixels of the GeoTIFF at `path`: name -> function that opens it."""
    gdal.Translate(folder + "/copy.tif", path)
    gdal.BuildVRT(folder + "/mosaic.vrt", [path]).FlushCache()
    gdal.Warp(folder + "/warped.vrt", path, format="VRT", resampleAlg="near").FlushCache()

    def unlinked():
        gdal.Translate(folder + "/gone.tif", path)
        opened = gdal.Open(folder + "/gone.tif")
        opened.ReadRaster()
        gdal.Unlink(folder + "/gone.tif")
        write_file(folder + "/gone.tif", b"something else")
        return opened

    return {
        "vsimem": lambda: gdal.Open(folder + "/copy.tif"),
        "memory": lambda: gdal.GetDriverByName("MEM").CreateCopy("", gdal.Open(path)),
        "vrt file": lambda: gdal.Open(folder + "/mosaic.vrt"),
        "vrt without a name": lambda: gdal.BuildVRT("", [path]),
        "vrt as text": lambda: gdal.Open(read_file(folder + "/mosaic.vrt").decode()),
        "warped vrt": lambda: gdal.Open(folder + "/warped.vrt"),
        "warped vrt without a name": lambda: gdal.Warp("", path, format="VRT", resampleAlg="near"),
        "update mode": lambda: gdal.Open(folder + "/copy.tif", gdal.GA_Update),
        "subdataset": lambda: gdal.Open("GTIFF_DIR:1:" + folder + "/copy.tif"),
        "file replaced while open": unlinked,
    }


KINDS = ["vsimem", "memory", "vrt file", "vrt without a name", "vrt as text", "warped vrt",
         "warped vrt without a name", "update mode", "subdataset", "file replaced while open"]


@pytest.mark.parametrize("kind", KINDS)
def test_sources_of_every_kind(qmesh, dem, vsimem, kind):
    path = str(dem("jacksboro"))
    options = ["TILESIZE=32", "MAX_ZOOM=9", "NUM_THREADS=3"]
    qmesh.CreateCopy(vsimem + "/plain", gdal.Open(path), options=options)
    source = sources(vsimem, path)[kind]()
    qmesh.CreateCopy(vsimem + "/other", source, options=options)
    assert tiles(vsimem + "/other") == tiles(vsimem + "/plain")
    plain = gdal.Open(path)
    assert source.GetRasterBand(1).Checksum() == plain.GetRasterBand(1).Checksum()


def test_unsaved_changes_count(qmesh, vsimem):
    """Pixels written but not flushed, and a nodata value set on a read-only dataset."""
    hilly(name=vsimem + "/a.tif", driver="GTiff").FlushCache()
    changed = gdal.Open(vsimem + "/a.tif", gdal.GA_Update)
    values = changed.ReadAsArray()
    values[20:30, 20:30] += 500
    changed.GetRasterBand(1).WriteArray(values[20:30, 20:30], 20, 20)
    qmesh.CreateCopy(vsimem + "/changed", changed, options=SMALL)
    qmesh.CreateCopy(vsimem + "/expected", array_source(values), options=SMALL)
    assert tiles(vsimem + "/changed") == tiles(vsimem + "/expected")

    values[40:50, 40:50] = -1
    with_void = array_source(values, name=vsimem + "/b.tif", driver="GTiff")
    with_void.FlushCache()
    opened = gdal.Open(vsimem + "/b.tif")
    opened.GetRasterBand(1).SetNoDataValue(-1)
    qmesh.CreateCopy(vsimem + "/void", opened, options=SMALL)
    expected = array_source(values)
    expected.GetRasterBand(1).SetNoDataValue(-1)
    qmesh.CreateCopy(vsimem + "/expected void", expected, options=SMALL)
    assert tiles(vsimem + "/void") == tiles(vsimem + "/expected void")
    assert tiles(vsimem + "/void") != tiles(vsimem + "/changed")


def test_a_vrt_changed_after_it_was_opened(qmesh, vsimem):
    hilly(name=vsimem + "/a.tif", driver="GTiff").FlushCache()
    array_source(dems.hills(60, 70, seed=5), name=vsimem + "/b.tif", driver="GTiff").FlushCache()
    gdal.BuildVRT(vsimem + "/m.vrt", [vsimem + "/a.tif"]).FlushCache()
    opened = gdal.Open(vsimem + "/m.vrt")
    xml = gdal.BuildVRT("", [vsimem + "/b.tif"]).GetMetadata("xml:VRT")[0]
    source = xml[xml.index("<SimpleSource") : xml.index("</SimpleSource>") + len("</SimpleSource>")] if (
        "<SimpleSource" in xml) else xml[xml.index("<ComplexSource") : xml.index("</ComplexSource>") + 16]
    opened.GetRasterBand(1).SetMetadata({"source_0": source}, "vrt_sources")
    qmesh.CreateCopy(vsimem + "/changed", opened, options=SMALL)
    qmesh.CreateCopy(vsimem + "/expected", gdal.Open(vsimem + "/b.tif"), options=SMALL)
    assert tiles(vsimem + "/changed") == tiles(vsimem + "/expected")


def test_open_options_of_the_source_count(qmesh, vsimem):
    gdal.Translate(vsimem + "/a.tif", hilly(rows=128, columns=128)).BuildOverviews("AVERAGE", [2])
    opened = gdal.OpenEx(vsimem + "/a.tif", open_options=["OVERVIEW_LEVEL=0"])
    assert opened.RasterXSize == 64
    qmesh.CreateCopy(vsimem + "/overview", opened, options=SMALL)
    copied = gdal.GetDriverByName("MEM").CreateCopy("", opened)
    qmesh.CreateCopy(vsimem + "/copied", copied, options=SMALL)
    assert tiles(vsimem + "/overview") == tiles(vsimem + "/copied")


def test_overviews_of_the_source_are_used_as_the_command_does(qmesh, tmp_path):
    """Zooms much coarser than the cells read an overview: also one that holds other heights."""
    path = str(tmp_path / "dem.tif")
    gdal.Translate(path, hilly(512, 512, transform=(10.0, 0.001, 0, 47.0, 0, -0.001)))
    options, words = ["TILESIZE=32", "MAX_ZOOM=5"], ["--tilesize", "32", "--max-zoom", "5"]
    trees = {}
    for levels in ([], [2, 4, 8, 16]):
        if levels:
            opened = gdal.Open(path, gdal.GA_Update)
            opened.BuildOverviews("NEAREST", levels)
            opened = None
        qmesh.CreateCopy(str(tmp_path / f"driver{len(levels)}"), gdal.Open(path), options=options)
        harness.gdal2qmesh(*words, path, tmp_path / f"command{len(levels)}").succeeded()
        trees[len(levels)] = tree(tmp_path / f"driver{len(levels)}")
        assert trees[len(levels)] == command_tree(tmp_path / f"command{len(levels)}")
    assert trees[0] != trees[4], "no overview was read, so this shows nothing"


@pytest.mark.parametrize("kind", ["Byte", "UInt16", "Int16", "UInt32", "Int32", "Float32", "Float64"])
def test_numeric_types(qmesh, vsimem, kind):
    heights = np.round(dems.hills(50, 50, 0, 250))
    qmesh.CreateCopy(vsimem + "/typed", array_source(heights, kind=gdal.GetDataTypeByName(kind)), options=SMALL)
    qmesh.CreateCopy(vsimem + "/float", array_source(heights), options=SMALL)
    assert tiles(vsimem + "/typed") == tiles(vsimem + "/float")


def test_scale_offset_and_unit_count(qmesh, vsimem):
    heights = np.round(dems.hills(50, 50, 100, 900))
    feet = array_source((heights - 100) * 2, kind=gdal.GDT_Float64)
    feet.GetRasterBand(1).SetScale(0.5)
    feet.GetRasterBand(1).SetOffset(100)
    qmesh.CreateCopy(vsimem + "/scaled", feet, options=SMALL)
    qmesh.CreateCopy(vsimem + "/plain", array_source(heights), options=SMALL)
    assert tiles(vsimem + "/scaled") == tiles(vsimem + "/plain")
    feet.GetRasterBand(1).SetUnitType("ft")
    qmesh.CreateCopy(vsimem + "/feet", feet, options=SMALL)
    assert tiles(vsimem + "/feet") != tiles(vsimem + "/plain")


def test_threads_do_not_change_a_byte(qmesh, vsimem):
    source = hilly(200, 200)
    for threads in ("1", "4", "ALL_CPUS"):
        qmesh.CreateCopy(f"{vsimem}/{threads}", source, options=[*SMALL, "TITLE=t", f"NUM_THREADS={threads}"])
    assert tree(vsimem + "/1") == tree(vsimem + "/4") == tree(vsimem + "/ALL_CPUS")


def test_the_hosts_block_cache_is_left_alone(qmesh, vsimem):
    before = gdal.GetCacheMax()
    qmesh.CreateCopy(vsimem + "/set", hilly(), options=[*SMALL, "MEMORY=100MB"])
    assert gdal.GetCacheMax() == before


def test_strict_and_other_bands(qmesh, vsimem):
    heights = hilly()
    two = gdal.GetDriverByName("MEM").Create("", 70, 60, 2, gdal.GDT_Float32)
    two.SetGeoTransform(heights.GetGeoTransform())
    two.SetSpatialRef(heights.GetSpatialRef())
    two.GetRasterBand(1).WriteArray(heights.ReadAsArray())
    refused(lambda: qmesh.CreateCopy(vsimem + "/no", two, strict=1, options=SMALL), "2 bands", "-b",
            number=gdal.CPLE_NotSupported)
    assert gdal.VSIStatL(vsimem + "/no") is None
    with messages() as said:
        assert qmesh.CreateCopy(vsimem + "/one", two, strict=0, options=SMALL) is not None
    assert [kind for kind, _, _ in said] == [gdal.CE_Warning] and "band 1" in said[0][2]
    qmesh.CreateCopy(vsimem + "/single", heights, options=SMALL)
    assert tiles(vsimem + "/one") == tiles(vsimem + "/single")

    two.GetRasterBand(2).SetColorInterpretation(gdal.GCI_AlphaBand)
    two.GetRasterBand(2).Fill(255)
    with messages() as said:
        qmesh.CreateCopy(vsimem + "/alpha", two, strict=1, options=SMALL)
    assert said == [] and tiles(vsimem + "/alpha") == tiles(vsimem + "/single")


def test_sources_that_cannot_be_terrain(qmesh, vsimem):
    bare = gdal.GetDriverByName("MEM").Create("", 4, 4, 0)
    refused(lambda: qmesh.CreateCopy(vsimem + "/a", bare), "no raster band", number=gdal.CPLE_NotSupported)
    heights = dems.hills(20, 20)
    complex_ = array_source(heights, kind=gdal.GDT_CFloat32)
    refused(lambda: qmesh.CreateCopy(vsimem + "/a", complex_), "complex", number=gdal.CPLE_NotSupported)
    refused(lambda: qmesh.CreateCopy(vsimem + "/a", array_source(heights, transform=None)), "not georeferenced",
            "-a_ullr")
    refused(lambda: qmesh.CreateCopy(vsimem + "/a", array_source(heights, srs=None)), "-a_srs")
    by_points = array_source(heights, transform=None, srs=None)
    by_points.SetGCPs([gdal.GCP(10, 47, 0, 0, 0), gdal.GCP(11, 47, 0, 20, 0), gdal.GCP(10, 46, 0, 0, 20)],
                      hilly().GetProjection())
    refused(lambda: qmesh.CreateCopy(vsimem + "/a", by_points), "control points", "gdalwarp")
    by_sensor = array_source(heights, transform=None, srs=None)
    by_sensor.SetMetadata({"LINE_OFF": "1"}, "RPC")
    refused(lambda: qmesh.CreateCopy(vsimem + "/a", by_sensor), "sensor model", "gdalwarp")
    nothing = array_source(np.full((20, 20), np.nan, dtype=np.float32))
    refused(lambda: qmesh.CreateCopy(vsimem + "/a", nothing, options=SMALL), "no cell has a height", "-a_nodata")
    assert gdal.ReadDir(vsimem) in (None, [])


def test_a_source_that_breaks_in_the_middle(qmesh, tmp_path):
    path = str(tmp_path / "torn.tif")
    gdal.GetDriverByName("GTiff").CreateCopy(path, hilly(400, 400))
    os.truncate(path, os.path.getsize(path) // 2)
    refused(lambda: qmesh.CreateCopy(str(tmp_path / "set"), gdal.Open(path), options=SMALL), "cannot be read")
    assert not (tmp_path / "set").exists()


def test_places(qmesh, tmp_path, monkeypatch, vsimem):
    """Relative names, slashes at the end, folders that are missing, the prefix, the layer.json."""
    source = hilly()
    qmesh.CreateCopy(vsimem + "/expected", source, options=[*SMALL, "TITLE=t"])
    expected = tree(vsimem + "/expected")
    monkeypatch.chdir(tmp_path)
    for name, folder in {"plain": "plain", "slash/": "slash", "a/b/deep": "a/b/deep", "./dot": "dot",
                         "QMESH:prefix": "prefix", "named/layer.json": "named"}.items():
        assert qmesh.CreateCopy(name, source, options=[*SMALL, "TITLE=t"]) is not None, name
        assert tree(tmp_path / folder) == expected, name


def test_names(qmesh, vsimem):
    def name_in(folder):
        return json.loads(read_file(folder + "/layer.json"))["name"]

    qmesh.CreateCopy(vsimem + "/mountains", hilly(), options=SMALL)
    assert name_in(vsimem + "/mountains") == "mountains"
    named = hilly(name=vsimem + "/hills.tif", driver="GTiff")
    qmesh.CreateCopy(vsimem + "/set", named, options=SMALL)
    assert name_in(vsimem + "/set") == "hills"


def test_what_comes_back_is_the_set(qmesh, vsimem):
    made = qmesh.CreateCopy(vsimem + "/set", hilly(), options=[*SMALL, "MAX_ZOOM=6"])
    assert made.GetDriver().ShortName == "QMESH" and made.RasterCount == 1
    heights = made.GetRasterBand(1).ReadAsArray()
    # the DEM covers a part of its tiles; the rest of the globe is filled with 0
    assert 100 <= heights.max() <= 910 and made.GetRasterBand(1).DataType == gdal.GDT_Float32


def test_a_set_is_a_source_too(qmesh, vsimem):
    first = qmesh.CreateCopy(vsimem + "/first", hilly(), options=[*SMALL, "MAX_ZOOM=6"])
    qmesh.CreateCopy(vsimem + "/second", first, options=[*SMALL, "MAX_ZOOM=6", "METHOD=delaunay"])
    assert gdal.Open(vsimem + "/second").RasterXSize == first.RasterXSize


def test_a_new_name_with_the_prefix_makes_no_noise(tmp_path):
    """The prefix alone names the driver."""
    hilly(rows=40, columns=40, name=str(tmp_path / "dem.tif"), driver="GTiff").FlushCache()
    done = subprocess.run(["gdal_translate", "-q", "-co", "TILESIZE=32", tmp_path / "dem.tif", f"QMESH:{tmp_path}/set"],
                          capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, ""), done.stderr
    assert (tmp_path / "set" / "layer.json").exists()
