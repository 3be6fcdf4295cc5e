#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Triangles of the quadtree against --curvature, with and without an observer: CSV and plot.

The share is of the full mesh, two triangles for every cell of every tile of one zoom. The observer stands in the middle
of the DEM. Writes quadtree_shares.csv and quadtree_shares.svg into the folder asked for.

    quadtree_shares.py --data FOLDER --out docs/algorithms/images
"""

import argparse
import csv
import json
import pathlib
import subprocess
import tempfile

CELLS = 256
CURVATURES = (0.1, 0.3, 1, 3, 10, 30, 100, 300)
# DEM, zoom, observer's place (degrees) and range (metres)
DEMS = (
    ("bigtujunga_srtm_30m_utm11n", 12, "-118.19,34.31", 2000),
    ("montereybay_noaa_topobathy", 11, "-122.0,36.75", 4000),
    ("celticsea_etopo1", 8, "-9,50", 50000),
)


def triangles(command, dem, zoom, *options):
    """Triangles and tiles of one zoom, and the rms error in metres."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        subprocess.run([command, "-q", "-z", str(zoom), "--exclude", "--report", report, "--method", "quadtree", *options,
                        dem, pathlib.Path(folder) / "out"], check=True)
        made = json.loads(report.read_text())["zooms"][0]
        return made["triangles"], made["tiles"], made["rmsError"]


def measure(command, data):
    """Rows of the table."""
    for name, zoom, place, reach in DEMS:
        for observed in (False, True):
            for curvature in CURVATURES:
                options = ["--curvature", str(curvature)]
                if observed:
                    options += [f"--observer={place}", "--observer-range", str(reach)]
                count, tiles, rms = triangles(command, data / f"{name}.tif", zoom, *options)
                yield {"dem": name.split("_")[0], "zoom": zoom, "observer": int(observed), "curvature": curvature,
                       "triangles": count, "share": round(count / (2 * CELLS * CELLS * tiles), 5),
                       "rms_error_m": round(rms, 3)}


def plot(rows, path):
    """Shares over curvature, dashed with the observer; the paper's five percent as a line."""
    import matplotlib
    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "qmesh"
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7, 4.2))
    for k, name in enumerate(dict.fromkeys(row["dem"] for row in rows)):
        for observed in (0, 1):
            chosen = [row for row in rows if row["dem"] == name and row["observer"] == observed]
            axes.plot([row["curvature"] for row in chosen], [100 * row["share"] for row in chosen], color=f"C{k}",
                      linestyle="--" if observed else "-", marker="o", markersize=3,
                      label=name + (", observer" if observed else ""))
    axes.axhline(5, color="grey", linewidth=0.8)
    axes.annotate("the paper's 5 %", (CURVATURES[0], 5), xytext=(0, 3), textcoords="offset points", fontsize=8)
    axes.set(xscale="log", yscale="log", xlabel="--curvature", ylabel="triangles, % of the full mesh")
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="build/bin/gdal2qmesh")
    parser.add_argument("--data", type=pathlib.Path, required=True, help="folder of the DEMs")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for the CSV and the plot")
    arguments = parser.parse_args()
    rows = list(measure(arguments.command, arguments.data))
    arguments.out.mkdir(parents=True, exist_ok=True)
    with open(arguments.out / "quadtree_shares.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    plot(rows, arguments.out / "quadtree_shares.svg")


if __name__ == "__main__":
    main()
