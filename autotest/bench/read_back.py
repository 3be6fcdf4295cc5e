#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Reading a level of terrain whole through the GDAL driver, next to the same raster in tiled GeoTIFFs.

    read_back.py [--runs 5] [--cold] [--bin build/bin/gdal2qmesh] [--plugins build/gdalplugins]
                 [--dem FILE --zoom 12]

Prints a table: wall and CPU seconds of opening and reading all cells (median of the runs, each in a
process of its own), bytes and calls of read. Files are in the system's cache; with --cold they are put
out of it before every run (posix_fadvise; what the system knows of folders stays). The default DEM is
bigtujunga in QMESH_TEST_DATA. Needs a Python with osgeo.gdal.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = pathlib.Path(os.environ.get("QMESH_TEST_DATA", ROOT.parent / "shared" / "data"))

READER = """
import json, sys, time
from osgeo import gdal
gdal.UseExceptions()
def counters():
    lines = open("/proc/self/io").read().split("\\n")
    return {key: int(value) for key, value in (line.split(": ") for line in lines if line)}
before, wall, cpu = counters(), time.perf_counter(), time.process_time()
dataset = gdal.Open(sys.argv[1])
band = dataset.GetRasterBand(1)
total = 0
for y in range(0, band.YSize, 256):
    total += band.ReadRaster(0, y, band.XSize, min(256, band.YSize - y)) is not None
row = {"wall": time.perf_counter() - wall, "cpu": time.process_time() - cpu}
after = counters()
print(json.dumps({**row, "bytes": after["rchar"] - before["rchar"], "reads": after["syscr"] - before["syscr"],
                  "cells": band.XSize * band.YSize}))
"""


def read(path, plugins):
    done = subprocess.run([sys.executable, "-c", READER, str(path)], capture_output=True, text=True, check=True,
                          env={**os.environ, "GDAL_DRIVER_PATH": str(plugins)})
    return json.loads(done.stdout)


def forget(path):
    """Puts a file, or those of a folder, out of the system's cache."""
    for file in [path] if path.is_file() else path.rglob("*"):
        if file.is_file():
            with open(file, "rb") as stream:
                os.fsync(stream.fileno())
                os.posix_fadvise(stream.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--cold", action="store_true")
    parser.add_argument("--bin", default=str(ROOT / "build" / "bin" / "gdal2qmesh"))
    parser.add_argument("--plugins", default=str(ROOT / "build" / "gdalplugins"))
    parser.add_argument("--dem", default=str(DATA / "bigtujunga_srtm_30m_utm11n.tif"))
    parser.add_argument("--zoom", type=int, default=12)
    options = parser.parse_args()

    with tempfile.TemporaryDirectory(prefix="qmesh-bench-") as folder:
        terrain = pathlib.Path(folder) / "set"
        subprocess.run([options.bin, "-q", "-z", str(options.zoom), options.dem, str(terrain)], check=True)
        env = {**os.environ, "GDAL_DRIVER_PATH": options.plugins}
        places = {"quantized mesh": terrain}
        for name, creation in (("tiled GeoTIFF", []), ("tiled GeoTIFF, DEFLATE", ["COMPRESS=DEFLATE", "PREDICTOR=3"])):
            places[name] = pathlib.Path(folder) / f"{len(places)}.tif"
            more = [word for option in creation for word in ("-co", option)]
            subprocess.run(["gdal_translate", "-q", "-co", "TILED=YES", *more, str(terrain), str(places[name])],
                           check=True, env=env)
        print("| raster | wall s | CPU s | MB read | calls of read | Mcells/s |")
        print("|---|---|---|---|---|---|")
        for name, path in places.items():
            rows = []
            for _ in range(options.runs):
                if options.cold:
                    forget(path)
                rows.append(read(path, options.plugins))
            row = {key: statistics.median(r[key] for r in rows) for key in rows[0]}
            print(f"| {name} | {row['wall']:.3f} | {row['cpu']:.3f} | {row['bytes'] / 1e6:.2f} | "
                  f"{row['reads']:.0f} | {row['cells'] / row['wall'] / 1e6:.1f} |")


if __name__ == "__main__":
    main()
