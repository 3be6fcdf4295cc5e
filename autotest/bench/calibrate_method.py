#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Triangles and errors of a method beside greedy's, as a Markdown table.

How the defaults of methods were found whose parameter is no max error: each DEM is meshed by greedy with its defaults
and by the method with its parameter at some multiples of every zoom's max error.

    calibrate_method.py --data FOLDER [--method qem] [--option svo] [--factors 0.5,0.65,0.8]
    calibrate_method.py --data FOLDER --method quadtree --option curvature --per-spacing --factors 80,120
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

EQUATOR = 40075016.7  # metres
DEMS = {  # zooms where the DEM has detail
    "bigtujunga_srtm_30m_utm11n": "8-11",
    "montereybay_noaa_topobathy": "7-10",
    "celticsea_etopo1": "6-8",
    "slovenia_lidar_1m": "14-17",
}


def build(command, dem, zooms, *options):
    """The zooms of the report of one run."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        subprocess.run([command, "-q", "-z", zooms, "--report", report, *options, dem, pathlib.Path(folder) / "out"],
                       check=True)
        return json.loads(report.read_text())["zooms"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="build/bin/gdal2qmesh")
    parser.add_argument("--data", type=pathlib.Path, required=True, help="folder of the DEMs")
    parser.add_argument("--method", default="qem")
    parser.add_argument("--option", default="svo")
    parser.add_argument("--factors", default="0.5,0.65,0.8")
    parser.add_argument("--per-spacing", action="store_true", help="the parameter is a multiple of max error / node spacing")
    parser.add_argument("--tilesize", type=int, default=256)
    arguments = parser.parse_args()
    print("| DEM, zooms | parameter relative to max error | triangles relative to greedy, by zoom "
          "| rms error relative to greedy | largest error relative to max error |")
    print("|---|---|---|---|---|")
    for dem, zooms in DEMS.items():
        source = arguments.data / f"{dem}.tif"
        tilesize = ("--tilesize", str(arguments.tilesize))
        greedy = build(arguments.command, source, zooms, *tilesize)
        for factor in map(float, arguments.factors.split(",")):
            unit = {z["zoom"]: EQUATOR / 2 ** (z["zoom"] + 1) / arguments.tilesize if arguments.per_spacing else 1
                    for z in greedy}
            spec = ",".join(f"{z['zoom']}:{factor * z['maxError'] / unit[z['zoom']]:.9g}" for z in greedy)
            made = build(arguments.command, source, zooms, *tilesize, "--method", arguments.method,
                         f"--{arguments.option}", spec)
            shares = " ".join(f"{m['triangles'] / g['triangles']:.2f}" for m, g in zip(made, greedy))
            rms = " ".join(f"{m['rmsError'] / g['rmsError']:.2f}" for m, g in zip(made, greedy))
            largest = " ".join(f"{m['errorReached'] / g['maxError']:.1f}" for m, g in zip(made, greedy))
            print(f"| {dem.split('_')[0]} {zooms} | {factor} | {shares} | {rms} | {largest} |", flush=True)


if __name__ == "__main__":
    main()
