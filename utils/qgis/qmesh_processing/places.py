# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Where the commands and the GDAL driver are: by a setting, on PATH, or next to the plugin."""

import glob
import os
import shutil
import sys

from processing.core.ProcessingConfig import ProcessingConfig

HERE = os.path.dirname(os.path.abspath(__file__))
COMMANDS_SETTING = "QMESH_COMMANDS"
DRIVER_SETTING = "QMESH_DRIVER"
SETTINGS = {
    COMMANDS_SETTING: "Folder of gdal2qmesh and qmeshinfo (empty: on PATH or beside the plugin)",
    DRIVER_SETTING: "Folder of the GDAL plugin gdal_QMESH (empty: where GDAL looks, or beside the commands)",
}
_DRIVER_FILES = ("gdal_QMESH.so", "gdal_QMESH.dylib", "gdal_QMESH.dll")


def _setting(name):
    return ProcessingConfig.getSetting(name) or ""


def _prefix():
    """The prefix of an install that holds this plugin as PREFIX/share/qgis/python/plugins/NAME, else this folder."""
    above = os.path.join(HERE, *[os.pardir] * 5)
    return os.path.normpath(above) if HERE.replace(os.sep, "/").find("/share/qgis/python/plugins/") >= 0 else HERE


def find_command(name):
    """The path of a command, or None. A folder named by the setting is the only place that counts."""
    chosen = _setting(COMMANDS_SETTING)
    if chosen:
        return shutil.which(name, path=chosen)
    beside = [HERE, os.path.join(HERE, "bin"), os.path.join(_prefix(), "bin")]
    return shutil.which(name) or shutil.which(name, path=os.pathsep.join(beside))


def missing_command(name):
    """What to tell somebody whose command is not found."""
    chosen = _setting(COMMANDS_SETTING)
    where = f"in {chosen}" if chosen else "on PATH or beside the plugin"
    return (
        f"{name} was not found {where}. Install qmesh, or name the folder that holds {name} in Settings > Options > "
        "Processing > Providers > Quantized-mesh terrain."
    )


def driver_folders():
    """Folders that may hold the GDAL plugin, the likeliest first."""
    chosen = _setting(DRIVER_SETTING)
    if chosen:
        return [chosen]
    folders = [HERE, os.path.join(HERE, "gdalplugins")]
    command = find_command("gdal2qmesh")
    bases = [_prefix()]
    if command:
        bases.insert(0, os.path.dirname(os.path.dirname(os.path.realpath(command))))
    for base in bases:
        folders.append(os.path.join(base, "gdalplugins"))
        for pattern in ("lib*/gdalplugins", "lib*/*/gdalplugins"):
            folders += sorted(glob.glob(os.path.join(base, pattern)))
    return [f for f in folders if any(os.path.exists(os.path.join(f, file)) for file in _DRIVER_FILES)]


def python():
    """A Python interpreter for a process of its own, or None; sys.executable is QGIS itself on some systems."""
    if os.path.basename(sys.executable or "").lower().startswith("python"):
        return sys.executable
    inside = os.path.join(sys.exec_prefix, "python.exe")
    return inside if os.path.exists(inside) else shutil.which("python3") or shutil.which("python")
