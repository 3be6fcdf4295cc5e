#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Triangles of the quadtree against --curvature, with and without an observer: CSV and plot.

The share is of the full mesh, two triangles for every cell of every tile of one zoom. The observer stands in the middle
of the DEM. Writes quadtree_shares.csv and quadtree_shares.svg into the folder asked for; with --drawing also
quadtree_drawing.csv: triangles in the first view of the preview page of whole pyramids, and milliseconds to draw it in
headless Chromium (which draws in software; needs the Node packages of autotest/clients).

    quadtree_shares.py --data FOLDER --out docs/algorithms/images [--drawing]
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


def drawing(command, data):
    """Rows on what the preview page draws, beside the full mesh."""
    name, zoom, place, reach = DEMS[0]
    observer = [f"--observer={place}", "--observer-range", str(reach)]
    cases = [("full mesh", "", ["--method", "delaunay"]), ("greedy", "", [])]
    for curvature in ("1", "10", "100"):
        options = ["--method", "quadtree", "--curvature", curvature]
        cases += [("quadtree", curvature, options), ("quadtree, observer", curvature, options + observer)]
    for method, curvature, options in cases:
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "out"
            subprocess.run([command, "-q", "-z", f"0-{zoom}", "--exclude", "-w", "cesium", *options,
                            data / f"{name}.tif", out], check=True)
            drawn = subprocess.run(["node", pathlib.Path(__file__).with_name("drawing_cost.mjs"), out], check=True,
                                   capture_output=True, text=True)
            yield {"mesh": method, "curvature": curvature, **json.loads(drawn.stdout)}


def write(rows, path):
    """One CSV."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


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
    parser.add_argument("--drawing", action="store_true", help="open whole pyramids in the preview page, too")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    rows = list(measure(arguments.command, arguments.data))
    write(rows, arguments.out / "quadtree_shares.csv")
    plot(rows, arguments.out / "quadtree_shares.svg")
    if arguments.drawing:
        write(list(drawing(arguments.command, arguments.data)), arguments.out / "quadtree_drawing.csv")


if __name__ == "__main__":
    main()
