#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Triangles and bytes against the error, for docs/choosing-the-error.md: a CSV of measurements and a plot of it.

    python3 autotest/bench/error_curves.py --output FOLDER [--dem FILE ...]

Each DEM (default: the shipped one) becomes terrain with --screen-error 1/8 to 4 pixels, all zooms to the native one; the
figures are those of --report. Without matplotlib only the CSV is written.
"""

import argparse
import csv
import json
import os
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = os.environ.get("QMESH_BIN", str(ROOT / "build/bin/gdal2qmesh"))
PIXELS = [0.125, 0.25, 0.5, 1, 2, 4]
FIELDS = ["dem", "pixels", "lastZoom", "maxError", "tiles", "triangles", "bytes", "rmsLastZoom", "errorLastZoom"]


def measure(dem, pixels):
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        subprocess.run(
            [BIN, "-q", "--screen-error", str(pixels), "--report", str(report), str(dem), f"{folder}/set"], check=True
        )
        said = json.loads(report.read_text())
    last, total = said["zooms"][-1], said["total"]
    return dict(
        zip(FIELDS, [dem.stem.split("_")[0], pixels, last["zoom"], last["maxError"], total["tiles"], total["triangles"],
                     total["bytes"], round(last["rmsError"], 4), round(last["errorReached"], 4)])
    )


def plot(rows, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.6), constrained_layout=True)
    for dem in dict.fromkeys(row["dem"] for row in rows):
        mine = [row for row in rows if row["dem"] == dem]
        pixels = [row["pixels"] for row in mine]
        for axes, value in ((left, "triangles"), (right, "bytes")):
            axes.plot(pixels, [row[value] / row["tiles"] for row in mine], marker="o", markersize=3.5, label=dem)
    for axes, label in ((left, "triangles per tile"), (right, "bytes per tile")):
        axes.set(xscale="log", yscale="log", xlabel="--screen-error, pixels", ylabel=label)
        axes.set_xticks(PIXELS, [f"{p:g}" for p in PIXELS])
        axes.minorticks_off()
        axes.axvline(0.5, color="0.6", linewidth=0.8, linestyle=":")
        axes.grid(color="0.92")
    left.legend(frameon=False, fontsize=8)
    figure.savefig(path)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--output", type=pathlib.Path, required=True, help="folder for error_curves.csv and .svg")
    words.add_argument("--dem", type=pathlib.Path, nargs="+", default=[ROOT / "data/jacksboro_srtm3.tif"])
    words.add_argument("--pixels", type=float, nargs="+", default=PIXELS)
    said = words.parse_args()
    said.output.mkdir(parents=True, exist_ok=True)
    rows = [measure(dem, pixels) for dem in said.dem for pixels in said.pixels]
    with open(said.output / "error_curves.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS)
        writer.writeheader()
        writer.writerows(rows)
    try:
        plot(rows, said.output / "error_curves.svg")
    except ImportError:
        print("no matplotlib: the plot is left out")


if __name__ == "__main__":
    main()
