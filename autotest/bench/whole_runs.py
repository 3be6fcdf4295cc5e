#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Whole runs of gdal2qmesh, one CSV row each: the median of several runs.

    whole_runs.py [--runs 5] [--only NAME] [--output FILE.csv] [--bin build/bin/gdal2qmesh]

Rows: run name, DEM, options, runs, CPU and wall seconds, tiles, CPU milliseconds per tile, vertices,
triangles, bytes, largest error reached in metres at the last zoom, peak memory in bytes. Real DEMs come from
QMESH_TEST_DATA; rows whose DEM is not there are left out, and it says so. The output folders are
temporary (TMPDIR says where), so put them on a fast disk to measure the program alone.
"""

import argparse
import csv
import json
import os
import pathlib
import statistics
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "autotest" / "utils"))

from measure import measured  # noqa: E402

DATA = pathlib.Path(os.environ.get("QMESH_TEST_DATA", ROOT.parent / "shared" / "data"))
BIGTUJUNGA = DATA / "bigtujunga_srtm_30m_utm11n.tif"
JACKSBORO = ROOT / "data" / "jacksboro_srtm3.tif"

# 5 m at zoom 12 doubling upwards: the errors other programs were measured with.
FIVE_METRES = ["--max-error", "20480/2^z"]

RUNS = [
    ("z12", BIGTUJUNGA, ["-z", "12", *FIVE_METRES]),
    ("z0-12", BIGTUJUNGA, ["-z", "0-12", *FIVE_METRES]),
    ("z0-12 without decimation", BIGTUJUNGA, ["-z", "0-12", *FIVE_METRES, "--decimate", "off"]),
    ("defaults", BIGTUJUNGA, []),
    ("delaunay", BIGTUJUNGA, ["--method", "delaunay"]),
    ("two threads", BIGTUJUNGA, ["-z", "0-12", *FIVE_METRES, "-j", "2"]),
    ("mercator", BIGTUJUNGA, ["-p", "mercator"]),
    ("shipped", JACKSBORO, []),
    ("degrees", DATA / "pyrenees_srtm3_n41n42e001.tif", []),
    ("degrees with voids", DATA / "capeflattery_srtm1_n48w125.tif", []),
    ("lidar", DATA / "slovenia_lidar_1m.tif", []),
    ("globe", DATA / "global_etopo_20min.tif", []),
]

FIELDS = ["name", "dem", "options", "runs", "cpu_seconds", "wall_seconds", "tiles", "cpu_ms_per_tile",
          "vertices", "triangles", "bytes", "error_reached", "peak_bytes"]


def one_run(program, dem, options):
    """Measures one run and reads its report; the output folder is removed again."""
    with tempfile.TemporaryDirectory(prefix="qmesh-bench-") as folder:
        report = pathlib.Path(folder) / "report.json"
        threads = [] if "-j" in options else ["-j", "1"]
        run = measured([program, "-q", *threads, *options, "--report", report, dem, f"{folder}/out"])
        if run["code"] != 0:
            sys.exit(f"{dem.name} {' '.join(options)}: exit code {run['code']}\n{run['err']}")
        return run, json.loads(report.read_text())


def row(program, name, dem, options, runs):
    taken = [one_run(program, dem, options) for _ in range(runs)]
    report = taken[0][1]
    cpu = statistics.median(run["cpu"] for run, _ in taken)
    total = report["total"]
    return {
        "name": name,
        "dem": dem.name,
        "options": " ".join(options),
        "runs": runs,
        "cpu_seconds": f"{cpu:.3f}",
        "wall_seconds": f"{statistics.median(run['wall'] for run, _ in taken):.3f}",
        "tiles": total["tiles"],
        "cpu_ms_per_tile": f"{1000 * cpu / total['tiles']:.3f}",
        "vertices": total["vertices"],
        "triangles": total["triangles"],
        "bytes": total["bytes"],
        "error_reached": f"{report['zooms'][-1]['errorReached']:.4f}",
        "peak_bytes": max(run["peak_bytes"] for run, _ in taken),
    }


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--only", action="append", help="a run's name; may be given again")
    parser.add_argument("--output", type=argparse.FileType("w"), default=sys.stdout)
    parser.add_argument("--bin", type=pathlib.Path,
                        default=os.environ.get("QMESH_BIN", ROOT / "build" / "bin" / "gdal2qmesh"))
    args = parser.parse_args()

    table = csv.DictWriter(args.output, FIELDS)
    table.writeheader()
    for name, dem, options in RUNS:
        if args.only and name not in args.only:
            continue
        if not dem.exists():
            print(f"left out: {name}, no {dem.name} in {DATA}", file=sys.stderr)
            continue
        table.writerow(row(args.bin, name, dem, options, args.runs))
        args.output.flush()


if __name__ == "__main__":
    main()
