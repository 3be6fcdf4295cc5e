# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""A set as vector layers: triangles, vertices and tiles, filters, FIDs, other formats."""

import numpy as np
import pytest
from osgeo import gdal, ogr

from formula_sets import Writer, plane, pyramid
from looking import raster, vector
from made import messages
from oracle.tileset import TileSet

CELLS = 4
PER_TILE = {"TIN": 1, "MULTIPOLYGON": 1, "POLYGONS": 2 * CELLS * CELLS}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Level 3 has two separate areas of 2 x 1 and 1 x 2 tiles."""
    writer = pyramid(tmp_path_factory.mktemp("vector") / "set", top=2, cells=CELLS)
    writer.write_level(3, 4, 4, 5, 4).write_level(3, 9, 2, 9, 3)
    return writer.write_layer()


TILES = {(4, 4), (5, 4), (9, 2), (9, 3)}


def features(layer):
    layer.ResetReading()
    return [feature for feature in layer]  # list() asks for the count first


def content(feature):
    return feature.GetFID(), feature.items(), feature.geometry().ExportToWkt()


def rings(geometry):
    """The triangles of a TIN, multipolygon or polygon as arrays of three corners (x, y, z)."""
    if geometry.GetGeometryName() in ("TIN", "MULTIPOLYGON"):
        return [ring for part in geometry for ring in rings(part)]
    points = geometry.GetGeometryRef(0).GetPoints()
    assert len(points) == 4 and points[0] == points[3]
    return [np.array(points[:3])]


# ---- Layers -----------------------------------------------------------------------------------------


def test_the_layers(folder):
    dataset = vector(folder)
    assert [dataset.GetLayer(k).GetName() for k in range(dataset.GetLayerCount())] == ["triangles", "vertices", "tiles"]
    assert dataset.RasterCount == 0
    kinds = [layer.GetGeomType() for layer in map(dataset.GetLayer, range(3))]
    assert kinds == [ogr.wkbTINZ, ogr.wkbPoint25D, ogr.wkbPolygon]
    for layer in map(dataset.GetLayer, range(3)):
        assert layer.GetSpatialRef().GetAuthorityCode(None) == "4326"
        assert layer.GetSpatialRef().GetDataAxisToSRSAxisMapping() == [2, 1]
        assert layer.TestCapability(ogr.OLCRandomRead) and not layer.TestCapability(ogr.OLCSequentialWrite)
    assert dataset.GetLayer(3) is None and dataset.GetLayerByName("lines") is None


def test_raster_and_vector_in_one_dataset(folder):
    both = gdal.OpenEx(str(folder), gdal.OF_RASTER | gdal.OF_VECTOR)
    assert both.RasterCount == 1 and both.GetLayerCount() == 3
    assert raster(folder).GetLayerCount() == 0


@pytest.mark.parametrize("geometry", PER_TILE)
def test_triangles_cover_the_tiles_with_heights(folder, geometry):
    dataset = vector(folder, GEOMETRY=geometry)
    layer = dataset.GetLayer("triangles")
    found = features(layer)
    assert len(found) == layer.GetFeatureCount() == len(TILES) * PER_TILE[geometry]
    assert {(f["x"], f["y"]) for f in found} == TILES and {f["zoom"] for f in found} == {3}
    area, count = 0.0, 0
    for feature in found:
        assert feature.geometry().GetGeometryType() == layer.GetGeomType()
        for corners in rings(feature.geometry()):
            (x0, y0, _), (x1, y1, _), (x2, y2, _) = corners
            area += ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2
            assert np.abs(plane(corners[:, 0], corners[:, 1]) - corners[:, 2]).max() < 0.05
            count += 1
    assert count == len(TILES) * 2 * CELLS * CELLS
    assert area == pytest.approx(len(TILES) * 22.5**2)


def test_polygons_are_valid(folder):
    dataset = vector(folder, GEOMETRY="POLYGONS")
    for feature in dataset.GetLayer("triangles"):
        assert feature.geometry().IsValid()


def test_points_only(folder):
    dataset = vector(folder, GEOMETRY="POINTS")
    assert [dataset.GetLayer(k).GetName() for k in range(dataset.GetLayerCount())] == ["vertices", "tiles"]


def test_vertices(folder):
    dataset = vector(folder)
    layer = dataset.GetLayer("vertices")
    found = features(layer)
    assert len(found) == layer.GetFeatureCount() == len(TILES) * (CELLS + 1) ** 2
    for feature in found:
        lon, lat, height = feature.geometry().GetPoint()
        assert feature["height"] == height
        assert height == pytest.approx(plane(lon, lat), abs=0.05)


def test_tiles_tell_what_is_in_them(command_set):
    folder = command_set("jacksboro", "-q", "--tilesize", 64)
    tiles = TileSet(folder)
    top = max(tiles.levels())
    dataset = vector(folder)
    layer = dataset.GetLayer("tiles")
    found = features(layer)
    assert len(found) == layer.GetFeatureCount() == len(tiles.levels()[top])
    reached = tiles.layer["qmesh"]["levels"][-1]["errorReached"]
    for feature in found:
        name = (feature["zoom"], feature["x"], feature["y"])
        tile = tiles.tile(*name)
        assert feature["vertices"] == len(tile.u) and feature["triangles"] == len(tile.triangles)
        assert feature["bytes"] == tiles.path(*name).stat().st_size
        assert (feature["min_height"], feature["max_height"]) == (tile.min_height, tile.max_height)
        assert feature["error"] == reached
        west, south, east, north = tiles.scheme.box(*name)
        assert feature.geometry().GetEnvelope() == pytest.approx((west, east, south, north), abs=1e-12)
        assert feature.geometry().IsValid()


def test_neighbours_share_their_edges_exactly(command_set):
    """Vertices of a mercator set, whose latitudes are not round numbers."""
    folder = command_set("jacksboro", "-q", "--tilesize", 64, "-p", "mercator")
    dataset = vector(folder)
    west, east, south, north = dataset.GetLayer("tiles").GetExtent()
    edges = {}
    for feature in dataset.GetLayer("vertices"):
        lon, lat, height = feature.geometry().GetPoint()
        edges.setdefault((lon, lat), []).append(height)
    shared = [heights for heights in edges.values() if len(heights) > 1]
    assert len(shared) > 50 and max(np.ptp(heights) for heights in shared) < 1e-3
    inner = [place for place in edges if west < place[0] < east and south < place[1] < north]
    scheme, z = TileSet(folder).scheme, int(dataset.GetMetadataItem("ZOOM"))
    lines = {float(scheme.box(z, x, 0)[0]) for x in range(scheme.tiles_x(z))}
    on_lines = [place for place in inner if place[0] in lines]
    assert on_lines and all(len(edges[place]) >= 2 for place in on_lines)


def test_zoom(folder):
    dataset = vector(folder, ZOOM=1)
    assert dataset.GetLayer("tiles").GetFeatureCount() == 8
    assert dataset.GetLayer("triangles").GetExtent() == (-180, 180, -90, 90)


# ---- Filters, counts, FIDs --------------------------------------------------------------------------


def test_the_extent_and_the_count_need_no_tile(folder, tmp_path):
    """layer.json is enough: there are no tiles at all here."""
    (tmp_path / "layer.json").write_text((folder / "layer.json").read_text())
    dataset = vector(tmp_path)
    for name in ("triangles", "tiles"):
        layer = dataset.GetLayer(name)
        assert layer.TestCapability(ogr.OLCFastFeatureCount) and layer.TestCapability(ogr.OLCFastGetExtent)
        assert layer.GetFeatureCount() == 4
        assert layer.GetExtent() == (-90.0, 45.0, -45.0, 22.5)
    with messages() as said:
        assert len(features(dataset.GetLayer("tiles"))) == 4
        assert dataset.GetLayer("vertices").GetFeatureCount() == 0
    assert not [text for kind, _, text in said if kind >= gdal.CE_Failure]


def test_a_spatial_filter_reads_its_tiles_only(tmp_path):
    """The other tiles are damaged."""
    writer = pyramid(tmp_path, top=1, cells=CELLS)
    writer.write_level(4, 0, 0, 31, 15)
    for file in (tmp_path / "4").rglob("*.terrain"):
        if file.parent.name != "17":
            file.write_bytes(b"damaged")
    dataset = vector(writer.write_layer(), GEOMETRY="POLYGONS")
    layer = dataset.GetLayer("triangles")
    layer.SetSpatialFilterRect(180 / 16 + 1, 1, 180 / 16 + 2, 2)
    found = features(layer)
    assert found and {(f["x"], f["y"]) for f in found} == {(17, 8)}
    assert len(found) == layer.GetFeatureCount() < 2 * CELLS * CELLS
    layer.SetSpatialFilterRect(500, 1, 600, 2)
    assert features(layer) == [] and layer.GetFeatureCount() == 0
    layer.SetSpatialFilterRect(180 / 16 + 1, -80, 180 / 16 + 2, 80)
    assert {f["y"] for f in features(layer)} >= set(range(1, 15))
    layer.SetSpatialFilter(None)
    with messages() as said:
        try:
            features(layer)
        except RuntimeError:
            pass
    assert [text for kind, _, text in said if kind == gdal.CE_Failure and "4/0/0.terrain" in text]


def test_filters_give_what_a_plain_search_gives(folder):
    dataset = vector(folder, GEOMETRY="POLYGONS")
    layer = dataset.GetLayer("triangles")
    everything = features(layer)
    random = np.random.default_rng(5)
    for _ in range(20):
        west, south = random.uniform(-95, 45), random.uniform(-50, 25)
        box = ogr.CreateGeometryFromWkt(
            f"POLYGON(({west} {south},{west + 20} {south},{west + 9} {south + 20},{west} {south}))")
        layer.SetSpatialFilter(box)
        layer.SetAttributeFilter("x <> 5")
        expected = {f.GetFID() for f in everything if f.geometry().Intersects(box) and f["x"] != 5}
        assert {f.GetFID() for f in features(layer)} == expected
    layer.SetSpatialFilter(None)
    layer.SetAttributeFilter("x = 9 AND y = 3")
    assert layer.GetFeatureCount() == 2 * CELLS * CELLS and not layer.TestCapability(ogr.OLCFastFeatureCount)


@pytest.mark.parametrize("geometry", PER_TILE)
def test_fids_are_unique_and_find_their_feature(folder, geometry):
    dataset = vector(folder, GEOMETRY=geometry)
    again = vector(folder, GEOMETRY=geometry)
    for name in ("triangles", "vertices", "tiles"):
        layer = dataset.GetLayer(name)
        found = features(layer)
        fids = [f.GetFID() for f in found]
        assert len(set(fids)) == len(fids) and min(fids) >= 0
        for feature in found[:: max(1, len(found) // 25)]:
            same = again.GetLayer(name).GetFeature(feature.GetFID())
            assert content(same) == content(feature)
        with messages():
            for fid in (-1, 10**6, max(fids) + 5000, 2**62):
                try:
                    assert again.GetLayer(name).GetFeature(fid) is None
                except RuntimeError:
                    pass


def test_getting_a_feature_does_not_disturb_reading(folder):
    dataset = vector(folder)
    layer = dataset.GetLayer("vertices")
    fids = [f.GetFID() for f in features(layer)]
    layer.ResetReading()
    seen = []
    for _ in fids:
        seen.append(layer.GetNextFeature().GetFID())
        layer.GetFeature(fids[len(seen) * 7 % len(fids)])
    assert seen == fids


def test_ignored_fields_spare_the_reading(tmp_path):
    """Footprints of tiles that cannot be read."""
    writer = Writer(tmp_path).write_level(0, 0, 0, 1, 0)
    for file in tmp_path.rglob("*.terrain"):
        file.write_bytes(b"damaged")
    dataset = vector(writer.write_layer())
    layer = dataset.GetLayer("tiles")
    with messages() as said:
        damaged = features(layer)
    assert len([text for kind, _, text in said if kind == gdal.CE_Warning]) == 2
    assert [f["vertices"] for f in damaged] == [None, None] and damaged[0]["bytes"] == len(b"damaged")
    layer.SetIgnoredFields(["vertices", "triangles", "bytes", "min_height", "max_height"])
    with messages() as said:
        assert len(features(layer)) == 2
    assert said == []


def test_a_damaged_tile_is_one_error(tmp_path):
    writer = Writer(tmp_path, cells=CELLS).write_level(0, 0, 0, 1, 0)
    (tmp_path / "0" / "0" / "0.terrain").write_bytes(b"damaged")
    dataset = vector(writer.write_layer())
    with messages() as said:
        try:
            assert dataset.GetLayer("triangles").GetNextFeature() is None
        except RuntimeError:
            pass
    assert len([text for kind, _, text in said if kind == gdal.CE_Failure and "0/0/0.terrain" in text]) <= 1


# ---- Other formats ----------------------------------------------------------------------------------


@pytest.mark.parametrize("driver, suffix", [("GPKG", "gpkg"), ("FlatGeobuf", "fgb"), ("GeoJSON", "json")])
@pytest.mark.parametrize("geometry", PER_TILE)
def test_translation(folder, tmp_path, driver, suffix, geometry):
    if driver == "GeoJSON" and geometry == "TIN":
        return  # that format has no TIN
    target = tmp_path / f"out.{suffix}"
    with messages() as said:
        done = gdal.VectorTranslate(str(target), vector(folder, GEOMETRY=geometry), format=driver, layers=["triangles"])
        del done
    assert not [text for kind, _, text in said if kind >= gdal.CE_Failure]
    source = vector(folder, GEOMETRY=geometry)
    expected = sorted(f.geometry().ExportToWkt() for f in source.GetLayer("triangles"))
    written = ogr.Open(str(target))
    layer = written.GetLayer(0)
    assert layer.GetFeatureCount() == len(expected)
    if driver != "GeoJSON":  # which rounds
        assert sorted(f.geometry().ExportToWkt() for f in layer) == expected


def test_the_vector_utilities(folder, tmp_path):
    import subprocess

    said = subprocess.run(["ogrinfo", "-so", "-al", str(folder)], capture_output=True, text=True, check=True)
    assert said.stdout.count("Feature Count: ") == 3 and "ERROR" not in said.stderr
    done = subprocess.run(["ogr2ogr", "-f", "GPKG", str(tmp_path / "all.gpkg"), str(folder)], capture_output=True,
                          text=True, check=True)
    assert "ERROR" not in done.stderr
    written = ogr.Open(str(tmp_path / "all.gpkg"))
    assert sorted(layer.GetName() for layer in written) == ["tiles", "triangles", "vertices"]
