# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The benchmark script cannot rot: it runs once on the shipped DEM."""

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
