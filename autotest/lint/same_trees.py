#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Shows that a change of the source keeps every byte of the output.

  same_trees.py write BIN DEMS FILE    builds the tilesets with the gdal2qmesh in BIN, writes their digests
  same_trees.py compare BIN DEMS FILE  builds them again and compares with FILE; exit code 1 where one differs

DEMS is a folder of rasters (*.tif). Each is built with default options and with the three sets of options below.
A digest is the SHA-256 of the sorted list of all files of the tileset, each with the SHA-256 of its content.
"""

import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile

OPTIONS = {
    "default": [],
    "mercator": ["-p", "mercator", "--method", "qem", "--metadata", "3", "--screen-error", "4"],
    "voids": ["--void-fill", "interpolate", "--max-error", "0-6:4000/2^z,7-:40", "-x", "--tilesize", "128"],
    "inherit": ["--border", "inherit", "--schedule", "chessboard", "--screen-error", "2", "--method", "quadtree",
                "--compress", "none"],
}


def tree_digest(folder):
    total = hashlib.sha256()
    for file in sorted(p for p in folder.rglob("*") if p.is_file()):
        total.update(f"{file.relative_to(folder)} {hashlib.sha256(file.read_bytes()).hexdigest()}\n".encode())
    return total.hexdigest()


def build(program, dem, options):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        done = subprocess.run([program, "-q", *options, dem, out], capture_output=True, text=True)
        if done.returncode != 0:
            return f"exit code {done.returncode}: {done.stderr.strip()}"
        return tree_digest(out)


def main():
    action, folder, dems, file = sys.argv[1:]
    program = pathlib.Path(folder) / "gdal2qmesh"
    digests = {}
    for dem in sorted(pathlib.Path(dems).glob("*.tif")):
        for name, options in OPTIONS.items():
            digests[f"{dem.name} {name}"] = build(program, dem, options)
            print(dem.name, name, digests[f"{dem.name} {name}"], flush=True)
    if action == "write":
        pathlib.Path(file).write_text(json.dumps(digests, indent=1) + "\n")
        return 0
    before = json.loads(pathlib.Path(file).read_text())
    changed = sorted(k for k in before.keys() | digests.keys() if before.get(k) != digests.get(k))
    for key in changed:
        print("differs:", key)
    print(f"{len(digests) - len(changed)} passed, {len(changed)} failed")
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main())
