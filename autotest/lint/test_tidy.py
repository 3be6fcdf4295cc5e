# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""clang-tidy is quiet about the files that were changed last.

Changed: since QMESH_LINT_BASE, a commit; without it since the commit before the last. At most MOST files are looked
at, the smallest first, so that the run stays short; the others are named.
"""

import concurrent.futures
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
MOST = 20


def changed_sources():
    base = os.environ.get("QMESH_LINT_BASE", "HEAD~1")
    done = subprocess.run(["git", "diff", "--name-only", "--diff-filter=d", base, "--", "common", "utils"], cwd=ROOT,
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"git cannot compare with {base}: {done.stderr}"
    # Files with CGAL take a minute each.
    return [name for name in done.stdout.split() if name.endswith(".cpp") and "/cgal/" not in name]


def complaints(name):
    done = subprocess.run(["clang-tidy", "-p", str(BUILD), "--quiet", name], cwd=ROOT, capture_output=True, text=True,
                          check=False)
    return re.findall(r"^.*(?:warning|error): .*$", done.stdout, re.M)


def test_changed_files_are_tidy():
    names = sorted(changed_sources(), key=lambda name: (ROOT / name).stat().st_size)
    if len(names) > MOST:
        print("not looked at:", *names[MOST:])
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(complaints, names[:MOST]))
    assert not any(found), "\n".join(line for lines in found for line in lines)
