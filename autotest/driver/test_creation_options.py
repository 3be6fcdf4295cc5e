# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Creation options come from the option table: what is listed, what each does, what is refused."""

import json
import subprocess
import xml.etree.ElementTree as etree

import pytest
from osgeo import gdal

import harness
from made import SMALL, command_tree, config, hilly, messages, read_file, refused, tree

NOT_IN_DRIVER = {"band", "s_srs", "srcnodata", "te", "te-srs", "cutline", "oo", "if", "overwrite", "webviewer",
                 "cesium", "report", "dry-run", "quiet", "verbose", "config-file", "help", "version"}


def command_rows():
    said = harness.gdal2qmesh("--options-json").succeeded().out
    return {row["name"]: row for row in json.loads(said)["options"] if "position" not in row}


def listed(qmesh):
    root = etree.fromstring(qmesh.GetMetadataItem("DMD_CREATIONOPTIONLIST"))
    return {option.get("name"): option for option in root.findall("Option")}


def test_the_list_is_the_table(qmesh):
    rows, options = command_rows(), listed(qmesh)
    expected = {row["creationOption"] for row in rows.values() if "creationOption" in row}
    assert set(options) == expected
    assert {rows[name]["name"] for name in NOT_IN_DRIVER if "creationOption" in rows[name]} == set()
    for name in ("METHOD", "MAX_ERROR", "SCREEN_ERROR", "ZOOM", "PROFILE", "RESAMPLING", "NORMALS", "COMPRESS",
                 "NUM_THREADS", "TILESIZE", "VOID_FILL", "METADATA", "XYZ", "MEMORY", "TITLE", "COPYRIGHT",
                 "BATHYMETRY"):
        assert name in options


def test_types_defaults_and_choices(qmesh):
    options = listed(qmesh)
    types = {name: option.get("type") for name, option in options.items()}
    assert set(types.values()) <= {"boolean", "int", "float", "string", "string-select"}
    assert types["METHOD"] == "string-select" and types["NORMALS"] == "boolean" and types["MIN_ZOOM"] == "int"
    for row in command_rows().values():
        if "creationOption" not in row:
            continue
        option = options[row["creationOption"]]
        assert option.get("description"), row["name"]
        if row.get("choices") and option.get("type") == "string-select":
            assert [v.text for v in option.findall("Value")] == [c["name"] for c in row["choices"]]
        if row["type"] != "flag" and option.get("type") != "boolean":
            assert option.get("default", "") == row.get("default", "")
    assert options["NORMALS"].get("default") == "YES" and options["XYZ"].get("default") == "NO"
    assert "--" not in "".join(option.get("description") for option in options.values())


def test_every_default_written_out_changes_nothing(qmesh, vsimem):
    source = hilly()
    qmesh.CreateCopy(vsimem + "/plain", source, options=["TITLE=t", "MAX_ZOOM=6"])
    pairs = [f"{name}={option.get('default')}" for name, option in listed(qmesh).items() if option.get("default")]
    assert len(pairs) > 10
    with messages() as said:
        qmesh.CreateCopy(vsimem + "/written", source, options=[*pairs, "TITLE=t", "MAX_ZOOM=6"])
    assert said == []
    assert tree(vsimem + "/written") == tree(vsimem + "/plain")


def other_value(option):
    """A value that is not the default."""
    if option.get("type") == "boolean":
        return "NO" if option.get("default") == "YES" else "YES"
    if option.get("type") == "string-select":
        return [v.text for v in option.findall("Value") if v.text != option.get("default")][0]
    return {"MIN_ZOOM": "1", "MAX_ZOOM": "5", "ZOOM": "0-5", "VOID_FILL": "20", "MAX_ERROR": "30", "METADATA": "2",
            "SCREEN_ERROR": "2", "CLIP_LOW": "300", "CLIP_HIGH": "500", "SCALE_ABOVE": "2", "SCALE_BELOW": "3",
            "NUM_THREADS": "1", "MEMORY": "300MB", "BLOCK_TILES": "4", "TITLE": "other", "COPYRIGHT": "me",
            "MIN_X": "0", "MIN_Y": "0", "MAX_X": "9999999", "MAX_Y": "9999999"}.get(option.get("name"))


def test_every_option_does_what_the_command_does(qmesh, tmp_path):
    """Each alone, against the command's option of the same row."""
    path = str(tmp_path / "dem.tif")
    hilly(rows=40, columns=40, name=path, driver="GTiff").FlushCache()
    source, rows, seen = gdal.Open(path), command_rows(), 0
    for name, option in listed(qmesh).items():
        value = other_value(option)
        if value is None:
            continue
        row = next(row for row in rows.values() if row.get("creationOption") == name)
        word = [f"--{row['name']}={value}"]
        if row["type"] == "flag":
            word = ["--" + ("" if value == "YES" else "no-") + row["name"]]
        elif option.get("type") == "boolean":
            word = [f"--{row['name']}={'on' if value == 'YES' else 'off'}"]
        base = [] if name in ("ZOOM", "TILESIZE", "MIN_ZOOM", "MAX_ZOOM") else ["MAX_ZOOM=6"]
        words = ["--max-zoom=6"] if base else []
        if name != "TILESIZE":
            base, words = [*base, *SMALL], [*words, "--tilesize=32"]
        command = harness.gdal2qmesh(*word, *words, path, tmp_path / "command" / name)
        if command.code != 0:
            # options that do not go with the default method: the driver refuses them in the same words
            said = command.err.strip().splitlines()[-1].split("error: ")[1]
            text = refused(lambda: qmesh.CreateCopy(str(tmp_path / "driver" / name), source,
                                                    options=[f"{name}={value}", *base]))
            assert text.split()[-3:] == said.split()[-3:], (text, said)
            continue
        with messages():
            qmesh.CreateCopy(str(tmp_path / "driver" / name), source, options=[f"{name}={value}", *base])
        assert tree(tmp_path / "driver" / name) == command_tree(tmp_path / "command" / name), name
        seen += 1
    assert seen >= 25


@pytest.mark.parametrize(
    "pair, words",
    {
        "MAX_ERROR=-1": ["MAX_ERROR=-1"],
        "MAX_ERROR=five": ["MAX_ERROR=five"],
        "METHOD=best": ["METHOD=best", "greedy"],
        "ZOOM=12-3": ["ZOOM=12-3"],
        "MIN_ZOOM=99": ["MIN_ZOOM=99", "0 to 24"],
        "TILESIZE=100": ["TILESIZE=100", "power of two"],
        "PROFILE=raster": ["PROFILE=raster", "geodetic", "gdal2tiles"],
        "NORMALS=MAYBE": ["NORMALS=MAYBE", "on"],
        "NUM_THREADS=0": ["NUM_THREADS=0"],
        "MEMORY=1KB": ["MEMORY is too small", "TILESIZE"],
        "MEMORY=much": ["MEMORY=much"],
        "VOID_FILL=deep": ["VOID_FILL=deep"],
        "MAX_EROR=5": ["MAX_EROR", "did you mean MAX_ERROR"],
        "COLOUR=RED": ["COLOUR", "gdalinfo --format QMESH"],
        "S_SRS=EPSG:4326": ["S_SRS", "-a_srs of gdal_translate"],
        "BAND=2": ["BAND", "-b of gdal_translate"],
        "OVERWRITE=YES": ["OVERWRITE", "option of gdal2qmesh, not of the driver"],
        "XYZ": ["XYZ", "NAME=VALUE"],
    }.items(),
)
def test_wrong_options_are_errors(qmesh, vsimem, pair, words):
    refused(lambda: qmesh.CreateCopy(vsimem + "/set", hilly(), options=[pair]), *words,
            number=gdal.CPLE_IllegalArg)
    assert gdal.VSIStatL(vsimem + "/set") is None


@pytest.mark.parametrize("pairs, words", [
    (["CLIP_LOW=100", "CLIP_HIGH=0"], ["CLIP_LOW is above CLIP_HIGH"]),
    (["MIN_ZOOM=5", "MAX_ZOOM=3"], ["minimum zoom"]),
    (["MAX_ERROR=1", "max_error=2"], ["MAX_ERROR=1 and max_error=2"]),
    (["MIN_X=1", "MAX_X=0"], ["MIN_X is above MAX_X"]),
])
def test_contradictions_are_errors_in_the_drivers_words(qmesh, vsimem, pairs, words):
    text = refused(lambda: qmesh.CreateCopy(vsimem + "/set", hilly(), options=pairs), *words)
    assert "--" not in text


def test_names_and_choices_in_any_case(qmesh, vsimem):
    qmesh.CreateCopy(vsimem + "/a", hilly(), options=["TILESIZE=32", "METHOD=delaunay", "NORMALS=NO", "TITLE=t"])
    qmesh.CreateCopy(vsimem + "/b", hilly(), options=["tileSize=32", "method=DELAUNAY", "Normals=no", "title=t"])
    qmesh.CreateCopy(vsimem + "/c", hilly(), options=["TILESIZE=32", "METHOD=Delaunay", "NORMALS=false", "TITLE=t"])
    assert tree(vsimem + "/a") == tree(vsimem + "/b") == tree(vsimem + "/c")


def test_gdals_own_options_are_passed_over(qmesh, vsimem):
    with messages() as said:
        options = [*SMALL, "@QUIET_DELETE_ON_CREATE_COPY=NO", "QUIET_DELETE_ON_CREATE_COPY=NO"]
        assert qmesh.CreateCopy(vsimem + "/set", hilly(), options=options) is not None
    assert not [text for _, _, text in said if text.startswith("QMESH:")]


def test_gdal_num_threads_stands_in(qmesh, vsimem):
    with config("GDAL_NUM_THREADS", "1"), messages() as said:
        qmesh.CreateCopy(vsimem + "/set", hilly(), options=SMALL)
    assert said == []
    with config("GDAL_NUM_THREADS", "many"), messages() as said:
        qmesh.CreateCopy(vsimem + "/set2", hilly(), options=SMALL)
    assert [kind for kind, _, _ in said] == [gdal.CE_Warning] and "GDAL_NUM_THREADS=many" in said[0][2]
    with config("GDAL_NUM_THREADS", "many"), messages() as said:
        qmesh.CreateCopy(vsimem + "/set3", hilly(), options=[*SMALL, "NUM_THREADS=2"])
    assert said == []


def test_metadata_of_the_driver(qmesh):
    said = qmesh.GetMetadata()
    assert said["DMD_LONGNAME"] and said["DMD_HELPTOPIC"]
    assert said["DMD_EXTENSION"] == said["DMD_EXTENSIONS"] == "terrain"
    for capability in ("DCAP_RASTER", "DCAP_VECTOR", "DCAP_OPEN", "DCAP_CREATECOPY", "DCAP_VIRTUALIO"):
        assert said[capability] == "YES"
    assert "DCAP_CREATE" not in said
    assert {"Byte", "Int16", "UInt16", "Int32", "UInt32", "Float32", "Float64"} <= set(
        said["DMD_CREATIONDATATYPES"].split())
    options = {o.get("name") for o in etree.fromstring(said["DMD_OPENOPTIONLIST"]).findall("Option")}
    assert {"ZOOM", "FILL", "GEOMETRY", "REGISTRATION"} <= options
    text = subprocess.run(["gdalinfo", "--format", "QMESH"], capture_output=True, text=True, check=True).stdout
    for part in ("Long Name", "Extension: terrain", "Help Topic", "CreateCopy()", "MAX_ERROR", "Virtual IO"):
        assert part in text


def test_the_plugin_exports_its_entry_only():
    import conftest

    said = subprocess.run(["nm", "-D", "--defined-only", conftest.PLUGINS / "gdal_QMESH.so"], capture_output=True,
                          text=True, check=True).stdout
    assert [line.split()[-1] for line in said.splitlines()] == ["GDALRegister_QMESH"]


def test_title_reaches_the_layer(qmesh, vsimem):
    qmesh.CreateCopy(vsimem + "/set", hilly(), options=[*SMALL, "TITLE=Über & <all>", "COPYRIGHT=© x"])
    layer = json.loads(read_file(vsimem + "/set/layer.json"))
    assert layer["name"] == "Über & <all>" and layer["attribution"] == "© x"
