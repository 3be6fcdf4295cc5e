# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Runs qmeshinfo as its users do."""

import json
import os
import pathlib
import subprocess

import harness

BIN = pathlib.Path(os.environ.get("QMESH_INFO_BIN", harness.BIN.parent / "qmeshinfo"))
SCHEMA = harness.ROOT / "data" / "schema" / "qmeshinfo.schema.json"
CLEAN, FOUND, USAGE, INTERRUPTED, INPUT, OUTPUT = range(6)


def qmeshinfo(*args, text=None):
    """A finished harness.Run; `text` is its standard input."""
    command = [str(BIN), *map(str, args)]
    done = subprocess.run(command, input=text or "", capture_output=True, text=True, timeout=harness.TIMEOUT,
                          check=False)
    return harness.Run(command, done.returncode, done.stdout, done.stderr)


def info_json(*args, code=CLEAN, text=None):
    """The JSON that the command prints."""
    run = qmeshinfo("-q", "--json", *args, text=text)
    assert run.code == code, f"{run}\n{run.err}"
    return json.loads(run.out)


def findings(folder, *args):
    """Code -> finding of --validate, and the exit code."""
    run = qmeshinfo("-q", "--json", "--validate", *args, folder)
    assert run.code in (CLEAN, FOUND), f"{run}\n{run.err}"
    report = json.loads(run.out)
    return {f["code"]: f for f in report["validation"]["findings"]}, run.code


def refused(run, code, *words):
    """Asserts the exit code and one clear line that holds the words."""
    assert run.code == code, f"{run}\n{run.err}"
    lines = run.err.strip().splitlines()
    assert lines and lines[-1].startswith("qmeshinfo: error: "), run.err
    for word in words:
        assert word.lower() in lines[-1].lower(), f"no {word!r} in: {lines[-1]}"
    assert run.out == ""
