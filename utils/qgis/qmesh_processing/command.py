# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Runs a command of qmesh for an algorithm: progress, warnings, cancel, errors as the command says them."""

import json
import os
import shlex
import subprocess

from qgis.core import QgsBlockingProcess, QgsProcessingException
from qgis.PyQt.QtCore import QProcess

from . import places
from .progress import LineReader

DONE, FINDINGS, INTERRUPTED = 0, 1, 3  # exit codes
_json_of = {}


def options_json(name):
    """What `NAME --options-json` prints, parsed; None where the command is missing or prints none. Asked again only
    when the program changed, because QGIS makes an algorithm anew for each dialog and run."""
    path = places.find_command(name)
    if path is None:
        return None
    key = (path, os.path.getmtime(path))
    if key not in _json_of:
        try:
            done = subprocess.run(
                [path, "--options-json"], stdin=subprocess.DEVNULL, capture_output=True, timeout=30, check=True
            )
            _json_of[key] = json.loads(done.stdout.decode("utf-8"))
        except (OSError, ValueError, subprocess.SubprocessError):
            return None
    return _json_of[key]


def described(name):
    """options_json(), or an exception that says what to do."""
    parsed = options_json(name)
    if parsed is None:
        path = places.find_command(name)
        raise QgsProcessingException(
            f"{path} does not describe its options: is it of an old version?" if path else places.missing_command(name)
        )
    return parsed


def run(name, words, feedback):
    """Runs a command to its end; False where the user cancelled. Raises QgsProcessingException with the command's own
    words on a failure."""
    # Bound methods in variables: QGIS does not keep what it is given here, and a lambda would be gone.
    output = LineReader(feedback.setProgress, feedback.pushWarning, feedback.pushConsoleInfo)
    read_output = output.feed
    code = _run(name, words, feedback, read_output, (DONE,))
    output.finish()
    return code != INTERRUPTED


def run_json(name, words, feedback, good=(DONE,)):
    """As run(), for a command that prints JSON: what it printed, parsed, or None where the user cancelled. Exit codes in
    `good` are no failure."""
    pieces = []

    def collect(data):
        pieces.append(bytes(data))

    if _run(name, words, feedback, collect, good) == INTERRUPTED:
        return None
    return json.loads(b"".join(pieces).decode("utf-8"))


def _run(name, words, feedback, read_output, good):
    path = places.find_command(name)
    if path is None:
        raise QgsProcessingException(places.missing_command(name))
    feedback.pushCommandInfo(shlex.join([name, *words]))
    errors = LineReader(feedback.setProgress, feedback.pushWarning, feedback.pushConsoleInfo)
    read_errors = errors.feed
    process = QgsBlockingProcess(path, words)
    process.setStdOutHandler(read_output)
    process.setStdErrHandler(read_errors)
    code = process.run(feedback)
    errors.finish()
    if process.processError() == QProcess.FailedToStart:
        raise QgsProcessingException(f"{path} cannot be started: is it a program for this system?")
    if feedback.isCanceled():
        return INTERRUPTED
    if process.exitStatus() == QProcess.CrashExit:
        raise QgsProcessingException(f"{name} was ended by the system. Is there enough memory?")
    if errors.errors or code not in good:
        raise QgsProcessingException("\n".join(errors.errors) or f"{name} ended with exit code {code}.")
    return code
