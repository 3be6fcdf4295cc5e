# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The README's first command in a fresh copy of the sources, as a newcomer runs it."""

import json
import shutil
import subprocess

from conftest import ROOT


def test_quickstart_makes_terrain_with_a_page(tmp_path):
    copy = tmp_path / "qmesh"
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True)
    for name in listed.stdout.splitlines():
        if (ROOT / name).is_file():
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, copy / name)
    run = subprocess.run(["utils/quickstart.sh"], cwd=copy, capture_output=True, text=True, timeout=1200)
    assert run.returncode == 0, run.stdout + run.stderr
    terrain = copy / "quickstart-terrain"
    assert str(terrain) in run.stdout
    assert json.loads((terrain / "layer.json").read_text())["format"] == "quantized-mesh-1.0"
    assert (terrain / "index.html").exists()
    export = next(line for line in run.stdout.splitlines() if line.strip().startswith("export PATH="))
    words = f"{export}; qmeshinfo --validate {terrain} && gdalinfo {terrain}"
    tried = subprocess.run(["bash", "-c", words], capture_output=True, text=True)
    assert tried.returncode == 0 and "Driver: QMESH" in tried.stdout, tried.stdout + tried.stderr
    assert (terrain / "0/0/0.terrain").exists() and (terrain / "0/1/0.terrain").exists()
