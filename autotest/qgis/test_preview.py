# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The algorithm Open preview and its web server."""

import gzip
import http.client
import os
import subprocess
import sys
import time
import urllib.error
import urllib.request

import pytest
from conftest import BUILD, DEM, PLUGINS

SERVE = PLUGINS / "qmesh_processing" / "serve.py"
NO_SCREEN = {"DISPLAY": "", "WAYLAND_DISPLAY": ""}


@pytest.fixture(scope="module")
def terrain(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sets") / "two words"
    subprocess.run([BUILD / "bin" / "gdal2qmesh", "-q", "-z", "0-5", "--tilesize", "64", DEM, folder], check=True)
    return folder


@pytest.fixture
def server(terrain):
    process, url = serve(terrain)
    yield url
    process.terminate()
    process.wait(20)


def serve(folder, *words):
    process = subprocess.Popen([sys.executable, SERVE, folder, *words], stdout=subprocess.PIPE)
    return process, process.stdout.readline().decode().strip()


def get(url):
    with urllib.request.urlopen(url, timeout=20) as answer:
        return answer.headers, answer.read()


def test_qgis_process_returns_and_the_server_goes_on(run_process, terrain):
    started = time.monotonic()
    process = run_process("qmesh:preview", NO_SCREEN, INPUT=terrain, MINUTES=1)
    url = process.succeeded()["URL"]
    assert time.monotonic() - started < 30
    assert "No web browser could be opened" in process.text and "no preview page" in process.text
    assert b'data-cesium="https://' in get(url)[1]
    assert get(url + "layer.json")[1] == (terrain / "layer.json").read_bytes()


def test_python_gives_the_address(qgis, terrain):
    import processing

    url = processing.run("qmesh:preview", {"INPUT": str(terrain), "BROWSER": False, "MINUTES": 1})["URL"]
    assert get(url)[0]["Content-Type"] == "text/html; charset=utf-8"


def test_a_folder_without_terrain_is_refused(run_process, terrain, tmp_path):
    run_process("qmesh:preview", NO_SCREEN, INPUT=tmp_path).failed("no layer.json")
    run_process("qmesh:preview", NO_SCREEN, INPUT=terrain, CESIUM=tmp_path).failed("no Cesium.js")


def test_headers_of_packed_and_plain_tiles(server, terrain, tmp_path):
    headers, data = get(server + "0/0/0.terrain?v=1")
    assert headers["Content-Encoding"] == "gzip" and headers["Content-Type"] == "application/vnd.quantized-mesh"
    assert headers["Cache-Control"] == "no-cache"
    assert data == (terrain / "0" / "0" / "0.terrain").read_bytes()
    subprocess.run(
        [BUILD / "bin" / "gdal2qmesh", "-q", "-z", "0-1", "--tilesize", "64", "--compress", "none", DEM, tmp_path / "plain"],
        check=True,
    )
    process, url = serve(tmp_path / "plain")
    headers, plain = get(url + "0/0/0.terrain")
    process.terminate()
    process.wait(20)
    assert headers["Content-Encoding"] is None and plain == gzip.decompress(data)


def test_the_page_is_the_commands(server, terrain, tmp_path):
    """The page from memory is what `-w cesium` writes, and a folder with a page shows its own."""
    subprocess.run([BUILD / "bin" / "gdal2qmesh", "-q", "-z", "0-1", "-w", "cesium", "-t", "two words", DEM, tmp_path / "own"],
                   check=True)
    for name in ("index.html", "preview.js", "look.js", "preview.css"):
        assert get(server + name)[1] == (tmp_path / "own" / name).read_bytes(), name
    (tmp_path / "own" / "index.html").write_text("mine")
    process, url = serve(tmp_path / "own")
    page = get(url)[1]
    process.terminate()
    process.wait(20)
    assert page == b"mine"
    assert not (terrain / "index.html").exists()


def test_nothing_but_the_folder_and_nobody_but_this_machine(server):
    port = int(server.rstrip("/").rpartition(":")[2])

    def status(path, host="localhost"):
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
        connection.request("GET", path, headers={"Host": f"{host}:{port}"})
        return connection.getresponse().status

    assert status("/layer.json") == 200
    assert status("/layer.json", "elsewhere.example") == 403
    assert status("/../" + os.path.basename(__file__)) == 404
    assert status("/%2e%2e/%2e%2e/etc/passwd") == 404
    assert status("/0/") == 404


def test_a_cesium_build_of_ones_own(terrain, tmp_path):
    (tmp_path / "Workers").mkdir()
    (tmp_path / "Cesium.js").write_text("// Cesium")
    (tmp_path / "Workers" / "one.js").write_text("// worker")
    process, url = serve(terrain, "--cesium", tmp_path)
    page, script, worker = (get(url + name)[1] for name in ("", "Cesium/Cesium.js", "Cesium/Workers/one.js"))
    process.terminate()
    process.wait(20)
    assert b'data-cesium="Cesium/"' in page and script == b"// Cesium" and worker == b"// worker"


def test_the_server_ends_when_nobody_asks(terrain):
    process, url = serve(terrain, "--idle", "1.5")
    time.sleep(1)
    get(url + "layer.json")
    time.sleep(1)
    get(url + "layer.json")
    assert process.wait(20) == 0
    with pytest.raises(urllib.error.URLError):
        get(url)
