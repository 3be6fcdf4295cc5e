# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The server configurations of docs/hosting.md, run by nginx and Apache themselves: what a browser gets to see."""

import gzip
import pathlib
import subprocess
import time
import urllib.request

import harness
import pytest
from conftest import ROOT, blocks

PORT = 18766
PAGE = ROOT / "docs" / "hosting.md"
APACHE_MODULES = pathlib.Path("/usr/lib/apache2/modules")


@pytest.fixture(scope="module")
def terrain(tmp_path_factory):
    folder = tmp_path_factory.mktemp("srv") / "terrain"
    harness.gdal2qmesh("-q", "-z", "0-2", harness.SHIPPED, folder).succeeded()
    for path in [*folder.parents][:2]:
        path.chmod(0o755)
    return folder


def _nginx(folder, terrain):
    [block] = blocks(PAGE, "nginx")
    config = folder / "nginx.conf"
    config.write_text(
        f"daemon off; pid {folder}/pid; error_log {folder}/error.log; events {{}}\n"
        f"http {{ access_log off; types {{ application/json json; }}\n"
        + "".join(f"{kind}_temp_path {folder}/{kind};\n" for kind in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi"))
        + f"server {{ listen 127.0.0.1:{PORT};\n{block.replace('/srv/terrain', str(terrain))}\n}} }}\n"
    )
    return ["/usr/sbin/nginx", "-c", str(config), "-e", str(folder / "error.log"), "-g", "user root;"]


def _apache(folder, terrain):
    [block] = blocks(PAGE, "apache")
    config = folder / "apache.conf"
    modules = ["mpm_event", "authz_core", "alias", "mime", "headers", "env"]
    config.write_text(
        "".join(f"LoadModule {m}_module {APACHE_MODULES}/mod_{m}.so\n" for m in modules)
        + f"ServerName localhost\nListen 127.0.0.1:{PORT}\nPidFile {folder}/pid\nErrorLog {folder}/error.log\n"
        f"TypesConfig /dev/null\nDocumentRoot {folder}\nAlias /terrain {terrain}\n"
        + block.replace("/srv/terrain", str(terrain))
    )
    return ["/usr/sbin/apache2", "-f", str(config), "-DFOREGROUND"]


def _get(path):
    request = urllib.request.Request(f"http://127.0.0.1:{PORT}/terrain/{path}", headers={"Accept-Encoding": "gzip"})
    return urllib.request.urlopen(request, timeout=10)


def _wait_until_it_answers(server, folder):
    for _ in range(100):
        try:
            return _get("layer.json")
        except OSError:
            assert server.poll() is None, server.stderr.read() + (folder / "error.log").read_text()
            time.sleep(0.1)
    raise AssertionError((folder / "error.log").read_text())


@pytest.mark.parametrize("configure", [_nginx, _apache], ids=["nginx", "apache"])
def test_the_headers_are_those_a_browser_needs(tmp_path, terrain, configure):
    server = subprocess.Popen(configure(tmp_path, terrain), stderr=subprocess.PIPE, text=True)
    try:
        layer = _wait_until_it_answers(server, tmp_path)
        assert layer.headers["Access-Control-Allow-Origin"] == "*"
        tile = _get("0/0/0.terrain?v=1")
        assert tile.headers["Content-Encoding"] == "gzip"
        assert tile.headers["Access-Control-Allow-Origin"] == "*"
        assert "max-age=31536000" in tile.headers["Cache-Control"]
        assert tile.headers["Content-Type"] == "application/vnd.quantized-mesh"
        assert gzip.decompress(tile.read()) == gzip.decompress((terrain / "0/0/0.terrain").read_bytes())
    finally:
        server.terminate()
        server.wait(20)
