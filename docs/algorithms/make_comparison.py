#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The comparison of methods in docs/algorithms: comparison.md and the pictures images/METHOD.png.

    python3 docs/algorithms/make_comparison.py FOLDER_OF_DEMS

Runs gdal2qmesh --compare (build/bin; QMESH_BIN names another) on one tile of each DEM; times in the
table are of this run. Needs ImageMagick for the pictures.
"""

import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
BIN = os.environ.get("QMESH_BIN", HERE.parents[1] / "build/bin/gdal2qmesh")
DEMS = {
    "Celtic Sea, bathymetry and coast, 1.9 km": "celticsea_etopo1.tif",
    "Monterey Bay, submarine canyon, 206 m": "montereybay_noaa_topobathy.tif",
    "Big Tujunga, mountains, 30 m": "bigtujunga_srtm_30m_utm11n.tif",
}
CELLS = 128
PICTURED, PICTURED_OPTIONS = "montereybay_noaa_topobathy.tif", ("--tilesize", 64, "--max-error", 15)
PICTURE_WIDTH, COLOURS, MOST_BYTES = 330, 16, 60_000
TITLES = {"count": "at equal triangle count", "error": "at equal max error", "defaults": "with their defaults"}


def compare(dem, folder, *options):
    """(rows of the CSV, CPU milliseconds by (target, method), the title line)"""
    command = [BIN, "--compare", *options, dem, folder]
    out = subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout
    with open(folder / "comparison.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    milliseconds, targets = {}, iter(["defaults", "count", "error"])
    target = None
    for line in out.splitlines():
        words = line.split()
        if line.startswith("method "):
            target = next(targets)
        elif target and words and words[0] in {row["method"] for row in rows}:
            milliseconds[target, words[0]] = float(words[11])
    return rows, milliseconds, next(line for line in out.splitlines() if "the measure" in line)


def shown(value):
    number = float(value)
    return f"{number:.0f}" if number >= 100 else f"{number:.3g}"


def table(rows, milliseconds, target):
    lines = [
        "| method | triangles | bytes | max | rms | mean | 3-D max | 3-D rms | 3-D mean | min angle | mean min angle "
        "| CPU ms | tuned |",
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|",
    ]
    for row in rows:
        if row["target"] != target:
            continue
        tuned = f"`--{row['option']} {float(row['value']):.4g}`" if row["option"] else ""
        if row["reached"] == "no":
            tuned = f"not reached ({tuned})" if tuned else "not reached"
        numbers = [row[key] for key in ("max_error", "rms_error", "mean_error", "max_distance", "rms_distance",
                                        "mean_distance", "min_angle", "mean_min_angle")]
        cells = [f"[{row['method']}]({page(row['method'])})", row["triangles"], row["bytes"], *map(shown, numbers),
                 shown(milliseconds[target, row["method"]]), tuned]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def page(method):
    return f"{method}.md" if (HERE / f"{method}.md").exists() else "index.md"


def picture(source, target):
    """Small enough for a page: fewer pixels, an indexed palette."""
    subprocess.run(["convert", source, "-resize", str(PICTURE_WIDTH), "+dither", "-colors", str(COLOURS),
                    "-strip", "-define", "png:exclude-chunks=date,time", f"PNG8:{target}"], check=True)
    size = target.stat().st_size
    if size > MOST_BYTES:
        sys.exit(f"{target} takes {size} bytes")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    data, text = pathlib.Path(sys.argv[1]), []
    (HERE / "images").mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        for title, file in DEMS.items():
            folder = pathlib.Path(scratch) / file
            rows, milliseconds, said = compare(data / file, folder, "--tilesize", CELLS)
            tile = re.search(r"tile (\S+),", said).group(1)
            text += [f"### {title}", "", f"Tile {tile} of `{file}`, {CELLS} cells per edge.", ""]
            for target in ("count", "error", "defaults"):
                text += [f"**Methods {TITLES[target]}** (errors in metres, angles in degrees)", ""]
                text += table(rows, milliseconds, target) + [""]
        rows, _, _ = compare(data / PICTURED, pathlib.Path(scratch) / "pictures", *PICTURED_OPTIONS)
        for row in rows:
            if row["target"] == "count":
                source = pathlib.Path(scratch) / "pictures" / f"{row['method']}-count.png"
                picture(source, HERE / "images" / f"{row['method']}.png")
    (HERE / "comparison.md").write_text("\n".join(text), encoding="utf-8")


main()
