# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Runs the command as its users do and looks at what it leaves behind."""

import hashlib
import os
import pathlib
import subprocess
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ.get("QMESH_BIN", ROOT / "build" / "bin" / "gdal2qmesh"))
DATA = pathlib.Path(os.environ.get("QMESH_TEST_DATA", ROOT.parent / "shared" / "data"))
SHIPPED = ROOT / "data" / "jacksboro_srtm3.tif"
FULL = os.environ.get("QMESH_FULL") == "1"
TIMEOUT = 600

DONE, INTERNAL, USAGE, INTERRUPTED, INPUT, OUTPUT = range(6)


@dataclass
class Run:
    """A finished process."""

    command: list
    code: int
    out: str
    err: str

    def succeeded(self):
        assert self.code == DONE, f"{self}\n{self.err}"
        return self

    def failed(self, code, *words):
        """Asserts the exit code and one clear line on stderr that holds the words."""
        assert self.code == code, f"{self}\n{self.err}"
        said = self.err.strip().splitlines()
        assert said and said[-1].startswith("gdal2qmesh: error: "), self.err
        for word in words:
            assert str(word).lower() in said[-1].lower(), f"no {word!r} in: {said[-1]}"
        if code != USAGE:
            assert len([line for line in said if "error" in line.lower()]) == 1, self.err
        assert "Traceback" not in self.err and "terminate called" not in self.err
        return self

    def __str__(self):
        return f"exit code {self.code} from {' '.join(self.command)}"


def gdal2qmesh(*args, cwd=None, preexec=None, env=None):
    """Runs the command to its end."""
    command = [str(BIN), *map(str, args)]
    done = subprocess.run(
        command,
        cwd=cwd,
        preexec_fn=preexec,
        env={**os.environ, **(env or {})},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        timeout=TIMEOUT,
        check=False,
    )
    return Run(command, done.returncode, done.stdout.decode(), done.stderr.decode())


def start(*args, cwd=None):
    """Starts the command and returns at once."""
    return subprocess.Popen(
        [str(BIN), *map(str, args)],
        cwd=cwd,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )


def tree(folder):
    """Relative path -> sha256 of every file below a folder; folders map to None."""
    folder = pathlib.Path(folder)
    return {
        path.relative_to(folder).as_posix(): None
        if path.is_dir()
        else hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
    }


def hidden_files(folder):
    """What a run leaves beside its results: nothing, it is hoped."""
    return [p for p in pathlib.Path(folder).rglob("*") if p.name.startswith(".") or p.suffix == ".tmp"]
