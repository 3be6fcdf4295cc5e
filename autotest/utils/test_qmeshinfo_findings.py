# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Each finding of qmeshinfo --validate: a good set is damaged in just that way, and that finding and no other error
is seen."""

import gzip
import json
import re
import struct

import numpy as np
import pytest
from infos import CLEAN, FOUND, findings, info_json, qmeshinfo
from made_set import MAX, METADATA, NORMALS, WATER, MadeSet, box_of, make_tile, oct_encode

ONE = (2, 4, 2)  # a tile with neighbours
ALONE = (1, 2, 1)  # the only one of its level
DAMAGES = []


def damage(code, *, more=()):
    """Registers a function that damages a MadeSet; `more`: other findings, no errors, that it brings."""

    def register(function):
        DAMAGES.append(pytest.param(code, function, set(more), id=f"{code}-{function.__name__}"))
        return function

    return register


# ---- layer.json ----------------------------------------------------------------------------------------------


@damage("QM101")
def no_layer(made):
    made.layer_text = ""


@damage("QM102")
def broken_json(made):
    made.layer_text = '{"format": '


@damage("QM103")
def no_format(made):
    del made.layer["format"]


@damage("QM103")
def other_format(made):
    made.layer["format"] = "heightmap-1.0"


@damage("QM104")
def no_tiles(made):
    del made.layer["tiles"]


@damage("QM104")
def tiles_as_text(made):
    made.layer["tiles"] = made.layer["tiles"][0]


@damage("QM105")
def unknown_projection(made):
    made.layer["projection"] = "EPSG:25832"


@damage("QM106")
def xyz(made):
    made.layer["scheme"] = "xyz"
    turned = {}
    for (z, x, y), tile in made.tiles.items():
        turned[z, x, 2**z - 1 - y] = tile
    made.tiles = turned


@damage("QM107")
def schema(made):
    made.layer["schema"] = made.layer.pop("scheme")


@damage("QM108")
def no_available(made):
    del made.layer["available"]


@damage("QM108")
def empty_available(made):
    made.layer["available"] = []


@damage("QM109", more={"QM602", "QM114"})
def malformed_level(made):
    made.layer["available"][2] = "all"


@damage("QM109", more={"QM602"})
def range_outside_its_level(made):
    made.layer["available"][2][0]["endX"] = 99


@damage("QM110")
def listed_twice(made):
    made.layer["available"][2].append(made.range(4, 2, 4, 2))


@damage("QM111", more={"QM602"})
def level_gap(made):
    made.layer["available"][1] = []


@damage("QM112", more={"QM602"})
def missing_root(made):
    made.layer["available"][0] = [made.range(1, 0, 1, 0)]


@damage("QM113")
def small_maxzoom(made):
    made.layer["maxzoom"] = 1


@damage("QM114")
def large_maxzoom(made):
    made.layer["maxzoom"] = 9


@damage("QM115")
def wrong_minzoom(made):
    made.layer["minzoom"] = 1


@damage("QM116")
def no_version(made):
    del made.layer["version"]


@damage("QM117")
def address_without_row(made):
    made.layer["tiles"] = ["{z}/{x}.terrain"]


@damage("QM118")
def no_bounds(made):
    del made.layer["bounds"]


@damage("QM118")
def bounds_in_metres(made):
    made.layer["bounds"] = [0, 0, 10018754, 20037508]


@damage("QM119")
def bounds_leave_out_tiles(made):
    made.layer["bounds"] = [0, 0, 40, 90]


@damage("QM120")
def unknown_word(made):
    made.layer["extensions"].append("octvertexnormal")


@damage("QM121")
def old_name(made):
    made.layer["extensions"] = ["vertexnormals"]
    made.raw = {name: tile.encode(lengths=">") for name, tile in made.tiles.items()}


@damage("QM122")
def metadata_number(made):
    made.layer["metadataAvailability"] = 0.5


@damage("QM123")
def no_attribution(made):
    del made.layer["attribution"]


# ---- the bytes of a tile --------------------------------------------------------------------------------------


@damage("QM201")
def broken_gzip(made):
    made.raw[ONE] = gzip.compress(made.tiles[ONE].encode())[:-40]


@damage("QM202")
def html(made):
    made.raw[ONE] = b"<!DOCTYPE html><html><body>404 Not Found</body></html>"


@damage("QM202")
def empty_file(made):
    made.raw[ONE] = b""


@damage("QM203", more={"QM611", "QM612"})
def compressed_twice(made):
    made.raw[ONE] = gzip.compress(gzip.compress(made.tiles[ONE].encode()))


def cut(where):
    def cut_file(made):
        made.raw[ONE] = made.tiles[ONE].encode()[:where]

    cut_file.__name__ = f"cut_at_{where}"
    return cut_file


for place in (10, 88, 90, 200, 600, 1000):  # header, vertices, triangles, edge lists
    damage("QM204")(cut(place))


@damage("QM204")
def no_triangles(made):
    made.raw[ONE] = made.tiles[ONE].encode(codes=[])


@damage("QM205")
def vertex_outside(made):
    tile = made.tiles[ONE]
    tile.u[np.flatnonzero(tile.u == MAX)[0]] += 60


@damage("QM206")
def index_of_nothing(made):
    codes = [0, 0, 0] * len(made.tiles[ONE].triangles)
    made.raw[ONE] = made.tiles[ONE].encode(codes=codes[: len(made.tiles[ONE].triangles)])


@damage("QM207")
def wide_indices(made):
    made.raw[ONE] = made.tiles[ONE].encode(index_bytes=4)


@damage("QM208")
def edge_list_too_short(made):
    made.tiles[ONE].edges[1] = made.tiles[ONE].edges[1][:-1]


@damage("QM208")
def edge_list_names_nothing(made):
    made.tiles[ONE].edges[3] = np.append(made.tiles[ONE].edges[3][:-1], 60000)


@damage("QM209")
def exchanged_edges(made):
    edges = made.tiles[ONE].edges
    edges[1], edges[3] = edges[3], edges[1]


@damage("QM210")
def extension_beyond_file(made):
    made.raw[ONE] = made.tiles[ONE].encode()[:-7]


@damage("QM210")
def half_an_extension_head(made):
    made.raw[ONE] = made.tiles[ONE].encode() + b"\x01\x02"


@damage("QM211")
def big_endian_lengths(made):
    made.raw[ONE] = made.tiles[ONE].encode(lengths=">")


@damage("QM212")
def long_normals(made):
    """The well-known 16 n for 2 n."""
    made.tiles[ONE].replace_extension(NORMALS, b"\x80" * (16 * len(made.tiles[ONE].u)))


@damage("QM213", more={"QM610"})
def short_water_mask(made):
    made.tiles[ONE].extensions.append((WATER, b"\0" * 7))


@damage("QM214")
def metadata_longer_than_its_extension(made):
    made.add_metadata()
    made.tiles[0, 1, 0].replace_extension(METADATA, struct.pack("<I", 999) + b"{}")


@damage("QM214")
def metadata_is_no_json(made):
    made.add_metadata()
    made.tiles[0, 1, 0].replace_extension(METADATA, struct.pack("<I", 4) + b"none")


@damage("QM215")
def extension_twice(made):
    made.tiles[ONE].extensions *= 2


@damage("QM216")
def unknown_extension(made):
    made.tiles[ONE].extensions.append((77, b"?"))


@damage("QM217", more={"QM501", "QM502"})
def ambiguous_vertex_count(made):
    made.tiles[ONE] = make_tile(box_of(*ONE), 255)
    assert len(made.tiles[ONE].u) == 65536


# ---- the mesh -------------------------------------------------------------------------------------------------


def inner_vertex(tile):
    inside = (tile.u > 0) & (tile.u < MAX) & (tile.v > 0) & (tile.v < MAX)
    return int(np.flatnonzero(inside)[len(tile.u) // 4])


def append_vertex(tile, like, u=None):
    """A new vertex with the height and normal of another one; its number."""
    tile.u = np.append(tile.u, tile.u[like] if u is None else u)
    tile.v, tile.q = np.append(tile.v, tile.v[like]), np.append(tile.q, tile.q[like])
    old = dict(tile.extensions)[NORMALS]
    tile.replace_extension(NORMALS, old + old[2 * like : 2 * like + 2])
    return len(tile.u) - 1


@damage("QM301")
def degenerate_triangle(made):
    tile = made.tiles[ONE]
    a, b, _ = tile.triangles[60:63]
    tile.triangles += [a, b, b]


@damage("QM302")
def flipped_triangle(made):
    tile = made.tiles[ONE]
    tile.triangles[-2:] = tile.triangles[-2:][::-1]


@damage("QM303")
def duplicate_vertex(made):
    tile = made.tiles[ONE]
    old = inner_vertex(tile)
    new = append_vertex(tile, old)
    last = len(tile.triangles) - 1 - tile.triangles[::-1].index(old)
    tile.triangles[last] = new
    made.raw[ONE] = renumbered(tile).encode()


@damage("QM304")
def unused_vertex(made):
    tile = made.tiles[ONE]
    like = inner_vertex(tile)
    append_vertex(tile, like, tile.u[like] + 9)


@damage("QM305")
def triangle_twice(made):
    tile = made.tiles[ONE]
    tile.triangles += tile.triangles[60:63]


@damage("QM306")
def t_vertex(made):
    """One of the two triangles on a horizontal inner edge is split at the edge's middle."""
    tile = made.tiles[ONE]
    for t in range(0, len(tile.triangles), 3):
        a, b, c = tile.triangles[t : t + 3]
        if tile.v[a] == tile.v[b] and 0 < tile.v[a] < MAX and tile.u[a] < tile.u[b]:
            break
    middle = append_vertex(tile, a, (tile.u[a] + tile.u[b]) // 2)
    del tile.triangles[t : t + 3]
    tile.triangles += [a, middle, c, middle, b, c]
    made.raw[ONE] = renumbered(tile).encode()


@damage("QM307")
def hole(made):
    tile = made.tiles[ONE]
    del tile.triangles[60:63]


def renumbered(tile):
    """Vertices in order of first use, as high-water marks need them."""
    order = list(dict.fromkeys(tile.triangles))
    number = {old: new for new, old in enumerate(order)}
    tile.triangles = [number[k] for k in tile.triangles]
    tile.u, tile.v, tile.q = tile.u[order], tile.v[order], tile.q[order]
    normals = np.frombuffer(dict(tile.extensions)[NORMALS], np.uint8).reshape(-1, 2)
    tile.replace_extension(NORMALS, normals[order].tobytes())
    return tile.fit()


@damage("QM308", more={"QM504"})
def normals_into_the_ground(made):
    tile = made.tiles[ONE]
    points = tile.points()
    tile.replace_extension(NORMALS, oct_encode(-points / np.linalg.norm(points, axis=1)[:, None]).tobytes())


@damage("QM309")
def two_triangles(made):
    made.tiles[ALONE] = make_tile(box_of(*ALONE), 1)


# ---- the header -----------------------------------------------------------------------------------------------


def header(code, what, **changes):
    def change(made):
        tile = made.tiles[ALONE]
        for key, value in changes.items():
            setattr(tile, key, value(getattr(tile, key)))

    change.__name__ = what
    damage(code)(change)


NAN = float("nan")
header("QM401", "horizon_nan", horizon=lambda h: h * NAN)
header("QM401", "horizon_infinite", horizon=lambda h: h * float("inf"))
header("QM401", "sphere_nan", radius=lambda r: NAN)
header("QM401", "centre_nan", centre=lambda c: c * NAN)
header("QM402", "small_sphere", radius=lambda r: r * 0.99)
header("QM402", "sphere_elsewhere", sphere=lambda s: s + 500)
header("QM403", "large_sphere", radius=lambda r: r * 3)
header("QM404", "low_horizon", horizon=lambda h: h * 0.9)
header("QM404", "no_horizon", horizon=lambda h: h * 0)
header("QM405", "high_horizon", horizon=lambda h: h * 10)
header("QM409", "centre_elsewhere", centre=lambda c: c * 3)


@damage("QM401", more={"QM407"})
def height_nan(made):
    """The mesh is looked at all the same, at height 0."""
    tile = made.tiles[ALONE]
    tile.low, tile.high = NAN, 0.0
    tile.q[:] = 0
    tile.low = 0.0
    tile.fit()
    tile.low = NAN


@damage("QM406")
def heights_upside_down(made):
    tile = made.tiles[ALONE]
    tile.low, tile.high = tile.high, tile.low
    tile.fit()


@damage("QM407")
def wide_heights(made):
    tile = made.tiles[ALONE]
    heights = tile.heights()
    tile.high = 4e6
    tile.q = np.round(heights / tile.high * MAX).astype(int)
    tile.fit()


@damage("QM408")
def nodata_as_height(made):
    tile = made.tiles[ALONE]
    tile.low, tile.high = -32768.0, -32768.0 + float(tile.high)
    tile.fit()


# ---- seams ----------------------------------------------------------------------------------------------------


@damage("QM501", more={"QM502"})
def other_vertices(made):
    made.tiles[ONE] = make_tile(box_of(*ONE), 16)


def lift_border(made, steps):
    tile = made.tiles[ONE]
    on_east = np.flatnonzero((tile.u == MAX) & (tile.v > 0) & (tile.v < MAX))
    tile.q[on_east[2]] += steps
    tile.fit()


@damage("QM502")
def rounded_differently(made):
    lift_border(made, 1)


@damage("QM503")
def crack(made):
    lift_border(made, 100)


@damage("QM503")
def crack_at_the_antimeridian(made):
    tile = made.tiles[0, 1, 0]
    at_180 = np.flatnonzero((tile.u == MAX) & (tile.v > 0) & (tile.v < MAX))
    tile.q[at_180[5]] += 100
    tile.fit()


@damage("QM504")
def other_normal(made):
    tile = made.tiles[ONE]
    normals = bytearray(dict(tile.extensions)[NORMALS])
    normals[2 * int(tile.edges[2][3])] ^= 8
    tile.replace_extension(NORMALS, bytes(normals))


@damage("QM505")
def pole_with_two_heights(made):
    tile = made.tiles[0, 0, 0]
    pole = np.flatnonzero((tile.v == MAX) & (tile.u > 0) & (tile.u < MAX))
    tile.q[pole[4]] += 100
    tile.fit()


# ---- availability ---------------------------------------------------------------------------------------------


@damage("QM601")
def missing_file(made):
    del made.tiles[ONE]


@damage("QM602")
def unlisted_file(made):
    made.tiles[2, 7, 3] = make_tile(box_of(2, 7, 3), 8)


@damage("QM603", more={"QM119"})
def orphan(made):
    made.tiles[2, 0, 1] = make_tile(box_of(2, 0, 1), 8)
    made.layer["available"][2].append(made.range(0, 1, 0, 1))


@damage("QM604")
def unexpected_metadata(made):
    made.tiles[ONE].extensions.append((METADATA, struct.pack("<I", 2) + b"{}"))


@damage("QM605")
def promised_metadata(made):
    made.layer["metadataAvailability"] = 10


@damage("QM606")
def metadata_without_a_tile(made):
    levels = made.layer["available"]
    levels[2] = [made.range(4, 2, 5, 2), made.range(4, 3, 4, 3)]
    made.add_metadata()
    levels[2] = [made.range(4, 2, 5, 3)]


@damage("QM606", more={"QM602"})
def metadata_with_one_too_many(made):
    made.add_metadata()
    made.layer["available"][2] = [made.range(4, 2, 5, 2)]


@damage("QM607")
def announced_normals(made):
    made.tiles[ONE].extensions = []


@damage("QM608")
def unannounced_normals(made):
    made.layer["extensions"] = []


@damage("QM609")
def announced_water(made):
    made.layer["extensions"].append("watermask")


@damage("QM610")
def unannounced_water(made):
    made.tiles[ONE].extensions.append((WATER, b"\xff"))


@damage("QM611")
def gzip_everywhere(made):
    made.packed = set(made.tiles)


@damage("QM612", more={"QM611"})
def gzip_somewhere(made):
    made.packed = {ONE}


@pytest.mark.parametrize("code, function, more", DAMAGES)
def test_damage_is_found(tmp_path, code, function, more):
    made = MadeSet()
    function(made)
    seen, exit_code = findings(made.write(tmp_path / "set"))
    assert code in seen, seen
    finding = seen[code]
    assert finding["count"] >= 1 and finding["places"][0]["place"]
    others = {c: f["places"] for c, f in seen.items() if c != code and c not in more}
    assert not others, others
    is_error = finding["severity"] == "error"
    assert all(seen[c]["severity"] != "error" for c in more & set(seen))
    assert exit_code == (FOUND if is_error else CLEAN)


def test_good_sets_have_no_findings(tmp_path):
    assert findings(MadeSet().write(tmp_path / "plain")) == ({}, CLEAN)
    made = MadeSet()
    made.add_metadata()
    assert findings(made.write(tmp_path / "metadata")) == ({}, CLEAN)


def test_unreadable_file(tmp_path):
    folder = MadeSet().write(tmp_path / "set")
    file = folder / "2" / "4" / "2.terrain"
    file.unlink()
    file.mkdir()
    seen, code = findings(folder)
    assert set(seen) & {"QM218", "QM601"} and code == FOUND


def test_every_finding_has_a_test():
    listed = {kind["code"] for kind in info_list()}
    assert listed - {param.values[0] for param in DAMAGES} == {"QM218"}


def info_list():
    return json.loads(qmeshinfo("--json", "--list-findings").out)["findings"]


def test_list_of_findings_as_text():
    text = qmeshinfo("--list-findings").out
    kinds = info_list()
    assert re.findall(r"^  (QM\d+) ", text, re.M) == [kind["code"] for kind in kinds]
    assert len({kind["title"] for kind in kinds}) == len(kinds)


def test_ignored_findings_do_not_count(tmp_path):
    made = MadeSet()
    crack(made)
    folder = made.write(tmp_path / "set")
    assert findings(folder, "--ignore", "QM503") == ({}, CLEAN)
    assert findings(folder, "--ignore", "503") == ({}, CLEAN)
    assert qmeshinfo("--validate", "--ignore", "QM999", folder).code == 2


def test_places_are_limited_and_counted(tmp_path):
    made = MadeSet()
    for tile in made.tiles.values():
        tile.horizon = tile.horizon * float("nan")
    folder = made.write(tmp_path / "set")
    seen, _ = findings(folder, "--max-findings", 2)
    assert seen["QM401"]["count"] == 7 and len(seen["QM401"]["places"]) == 2
    seen, _ = findings(folder, "--max-findings", 0)
    assert len(seen["QM401"]["places"]) == 7
    assert "... and 5 more" in qmeshinfo("--validate", "--max-findings", 2, folder).out


def test_one_tile_alone(tmp_path):
    made = MadeSet()
    flipped_triangle(made)
    folder = made.write(tmp_path / "set")
    seen, code = findings(folder / "2" / "4" / "2.terrain")
    assert set(seen) == {"QM302"} and code == FOUND
    assert findings(folder / "2" / "5" / "2.terrain") == ({}, CLEAN)
    made.raw[ONE] = b"no tile"
    made.write(folder)
    seen, code = findings(folder / "2" / "4" / "2.terrain")
    assert set(seen) == {"QM204"} and code == FOUND


def test_threads_say_the_same(tmp_path):
    made = MadeSet()
    crack(made)
    hole(made)
    folder = made.write(tmp_path / "set")
    one = info_json("--validate", "-j", 1, folder, code=FOUND)
    assert info_json("--validate", "-j", 4, folder, code=FOUND) == one
