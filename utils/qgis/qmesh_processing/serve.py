# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""A web server for one terrain folder on this machine, with the headers clients need.

    serve.py FOLDER [--idle SECONDS] [--title TEXT] [--cesium DIR]

Prints its address on the first line, answers this machine only, and ends when nobody has asked for anything for a
while. A folder without a preview page gets one, from memory: nothing is written. Knows nothing of QGIS.
"""

import argparse
import functools
import html
import http.server
import os
import time
import urllib.parse

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "preview")
PAGE_FILES = ("index.html", "preview.js", "look.js", "preview.css")
_TYPES = {".terrain": "application/vnd.quantized-mesh", ".js": "text/javascript", ".wasm": "application/wasm"}
_GZIP = b"\x1f\x8b"


def has_page(folder):
    """True where the folder has a preview page of its own."""
    return all(os.path.exists(os.path.join(folder, name)) for name in PAGE_FILES[:2])


def cesium_site():
    with open(os.path.join(PAGE, "cesium_site.txt"), encoding="utf-8") as file:
        return file.read().strip()


class Handler(http.server.SimpleHTTPRequestHandler):
    """Files of `directory`; of the page in memory and of a CesiumJS build where they are not there."""

    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, **_TYPES}
    protocol_version = "HTTP/1.1"

    def __init__(self, *arguments, title, cesium, **keywords):
        self.title = title
        self.cesium = cesium
        super().__init__(*arguments, **keywords)

    def send_head(self):
        # Another name for this machine is a page of somebody else that wants to look inside.
        if self.headers.get("Host") not in self.server.names:
            self.send_error(403)
            return None
        self.server.last_request = time.monotonic()
        path = urllib.parse.unquote(urllib.parse.urlsplit(self.path).path).lstrip("/") or "index.html"
        if path in PAGE_FILES and not has_page(self.directory):
            self._send_page(path)
            return None
        return super().send_head()

    def translate_path(self, path):
        found = super().translate_path(path)
        inside = os.path.relpath(found, self.directory).split(os.sep)
        if self.cesium and inside[0] == "Cesium" and not os.path.exists(found):
            return os.path.join(self.cesium, *inside[1:])
        return found

    def _send_page(self, name):
        with open(os.path.join(PAGE, name), encoding="utf-8") as file:
            text = file.read()
        if name == "index.html":
            base = "Cesium/" if self.cesium else cesium_site()
            text = text.replace("@TITLE@", html.escape(self.title)).replace("@CESIUM_BASE@", html.escape(base))
        data = text.encode("utf-8")
        self.send_response(200)
        self.send_header("Content-Type", self.guess_type(name) + "; charset=utf-8")
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        if self.command == "GET":
            self.wfile.write(data)

    def end_headers(self):
        if self.path.split("?")[0].endswith(".terrain") and self._is_packed():
            self.send_header("Content-Encoding", "gzip")
        # The set may be made anew at any time.
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def _is_packed(self):
        try:
            with open(self.translate_path(self.path), "rb") as file:
                return file.read(2) == _GZIP
        except OSError:
            return False

    def list_directory(self, path):
        self.send_error(404)

    def log_message(self, *arguments):
        pass


def open_server(folder, title="", cesium=""):
    """A server for this machine at a free port; `address(server)` tells where."""
    handler = functools.partial(
        Handler, directory=os.path.abspath(folder), title=title or os.path.basename(os.path.abspath(folder)), cesium=cesium
    )
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    server.daemon_threads = True
    server.names = {f"{host}:{server.server_address[1]}" for host in ("127.0.0.1", "localhost")}
    server.last_request = time.monotonic()
    return server


def address(server):
    return f"http://127.0.0.1:{server.server_address[1]}/"


def serve_until_idle(server, seconds):
    server.timeout = min(1.0, seconds)
    while time.monotonic() - server.last_request < seconds:
        server.handle_request()


def main():
    parser = argparse.ArgumentParser(description="Serves a terrain folder to this machine.")
    parser.add_argument("folder")
    parser.add_argument("--idle", type=float, default=1800, help="end after so many seconds without a request")
    parser.add_argument("--title", default="")
    parser.add_argument("--cesium", default="", help="a built CesiumJS to use instead of the download site")
    given = parser.parse_args()
    with open_server(given.folder, given.title, given.cesium) as server:
        print(address(server), flush=True)
        serve_until_idle(server, given.idle)


if __name__ == "__main__":
    main()
