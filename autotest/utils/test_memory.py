# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""P4: memory stays within --memory whatever the size of the DEM; empty space costs nothing."""

import re

import numpy as np
import pytest
from make_dem import make_dem
from osgeo import gdal

import dems
import harness
from measure import measured
from oracle.tileset import TileSet

BASE = 24 << 20  # program and libraries, beside the data that --memory speaks of


@pytest.fixture(scope="module")
def huge(tmp_path_factory):
    """9000 x 9000 cells, 160 MB of pixels in memory, from a small pattern repeated."""
    path = tmp_path_factory.mktemp("huge") / "huge.tif"
    data = gdal.GetDriverByName("GTiff").Create(
        str(path), 9000, 9000, 1, gdal.GDT_Float32, ["TILED=YES", "COMPRESS=DEFLATE", "ZLEVEL=1"])
    data.SetGeoTransform((10.0, 0.00025, 0, 47.0, 0, -0.00025))
    reference = gdal.osr.SpatialReference()
    reference.SetFromUserInput("EPSG:4326")
    data.SetProjection(reference.ExportToWkt())
    pattern = dems.hills(512, 9000)
    for row in range(0, 9000, 512):
        rows = min(512, 9000 - row)
        turned = pattern if row // 512 % 2 else pattern[::-1]
        data.GetRasterBand(1).WriteArray(turned[:rows], 0, row)
    data = None
    return path


@pytest.fixture(scope="module")
def rough(tmp_path_factory):
    """Hills in two tiles of zoom 11, at the spacing of the nodes of 256 cells a tile."""
    path = tmp_path_factory.mktemp("rough") / "rough.tif"
    return make_dem("terrain", path, size=(480, 227), lonlat_box=(9.85, 46.06, 10.015, 46.138))


@pytest.mark.parametrize("megabytes", [128, 256])
def test_memory_stays_within_the_budget(tmp_path, huge, megabytes):
    run = measured([harness.BIN, "-q", "-j", "2", "--memory", f"{megabytes}MB", "-z", "0-12",
                    huge, tmp_path / "a"])
    assert run["code"] == 0, run["err"]
    assert run["peak_bytes"] < (megabytes << 20) + BASE, f"{run['peak_bytes'] >> 20} MB at the peak"


def least_memory(*args):
    """The least --memory, in MB, that a run says it needs."""
    refused = harness.gdal2qmesh("--memory", "2MB", *args)
    refused.failed(harness.USAGE, "memory", "MB")
    return int(re.search(r"at least (\d+)MB", refused.err).group(1))


# Settings that leave the most of a mesh, besides the defaults.
DENSE = {
    "greedy": ["--max-error", 0], "collapse": ["--max-error", 0], "qem": ["--svo", 0],
    "quadtree": ["--curvature", 0], "grid": ["--cell-size", 0.001], "random": ["--random-percent", 0],
    "hierarchy": ["--cluster-size", 1], "wlop": ["--retain-percent", 100], "delaunay": [],
}


@pytest.mark.parametrize("border", ["shared", "inherit"])
@pytest.mark.parametrize("method", DENSE)
def test_every_method_stays_within_the_least_memory_it_asks_for(tmp_path, rough, method, border):
    """With tiles of 256 cells, 512 with QMESH_FULL: large ones need more memory than the rest of the run. Then also
    the slow ones of the dense settings."""
    cells, zoom = (512, 10) if harness.FULL else (256, 11)
    common = ["-q", "-j", 2, "--method", method, "--border", border, "--tilesize", cells, "-z", f"{zoom}-{zoom}"]
    dense = harness.FULL or (border == "shared" and method != "wlop")
    for options in [[], DENSE[method]] if dense else [[]]:
        megabytes = least_memory(*common, *options, rough, tmp_path / "a")
        run = measured([harness.BIN, *common, *options, "--overwrite", "--memory", f"{megabytes}MB", rough, tmp_path / "a"])
        assert run["code"] == 0, run["err"]
        # The program itself is in what it asks for: builds may differ by this much.
        most = (megabytes + 2) << 20
        assert run["peak_bytes"] < most, f"{options}: {run['peak_bytes'] >> 20} MB of {megabytes} MB"


def test_a_raster_that_could_never_be_held(tmp_path, dem):
    """A VRT of 200,000 x 200,000 cells that is void but for two small DEMs at its ends."""
    values = dems.hills(200, 200)
    west = dems.write(tmp_path / "w.tif", values, (-120.0, 0.0005, 0, 60.0, 0, -0.0005), nodata=-9999)
    east = dems.write(tmp_path / "e.tif", values, (120.0, 0.0005, 0, -40.0, 0, -0.0005), nodata=-9999)
    gdal.BuildVRT(str(tmp_path / "far.vrt"), [str(west), str(east)]).FlushCache()
    shape = gdal.Open(str(tmp_path / "far.vrt"))
    assert shape.RasterXSize > 400_000 and shape.RasterYSize > 190_000
    run = measured([harness.BIN, "-q", "-x", "--memory", "256MB", tmp_path / "far.vrt",
                    tmp_path / "a"], seconds=60)
    assert run["code"] == 0, f"the empty space between them is paid for: {run}"
    assert run["peak_bytes"] < (256 << 20) + BASE
    tiles = TileSet(tmp_path / "a")
    top = max(tiles.levels())
    heights = [tiles.tile(*t).heights().max() for t in tiles.levels()[top]]
    assert np.max(heights) == pytest.approx(900, abs=5)
    assert len(tiles.levels()[top]) < 20


def test_too_little_memory_names_the_minimum(tmp_path, dem):
    run = harness.gdal2qmesh("--memory", "2MB", dem("jacksboro"), tmp_path / "a")
    run.failed(harness.USAGE, "memory", "MB")
    assert not (tmp_path / "a").exists()
