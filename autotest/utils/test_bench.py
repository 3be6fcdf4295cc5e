# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The benchmark scripts cannot rot: they run once on the shipped DEM."""

import csv
import subprocess
import sys

import harness


def test_whole_runs_writes_its_table(tmp_path):
    script = harness.ROOT / "autotest" / "bench" / "whole_runs.py"
    table = tmp_path / "runs.csv"
    subprocess.run([sys.executable, script, "--runs", "1", "--only", "shipped", "--output", table,
                    "--bin", harness.BIN], check=True)
    (row,) = csv.DictReader(table.open())
    assert row["dem"] == "jacksboro_srtm3.tif"
    assert int(row["tiles"]) > 10 and float(row["cpu_ms_per_tile"]) > 0
    assert int(row["peak_bytes"]) > 1 << 20


def test_read_back_prints_its_table():
    script = harness.ROOT / "autotest" / "bench" / "read_back.py"
    told = subprocess.run([sys.executable, script, "--runs", "1", "--bin", harness.BIN, "--dem", harness.SHIPPED,
                           "--zoom", "10"], check=True, capture_output=True, text=True).stdout
    rows = [line.strip("| ").split(" | ") for line in told.splitlines()[2:]]
    assert [row[0] for row in rows] == ["quantized mesh", "tiled GeoTIFF", "tiled GeoTIFF, DEFLATE"]
    assert all(float(row[1]) > 0 and float(row[3]) > 0 for row in rows)
