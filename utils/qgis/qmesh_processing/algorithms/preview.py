# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Open preview: the terrain on a globe, in the web browser."""

import os
import subprocess
import sys
import webbrowser

from qgis.core import (
    QgsProcessingException,
    QgsProcessingOutputString,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFile,
    QgsProcessingParameterNumber,
)

from .. import places, serve
from .base import Algorithm

_SCRIPT = os.path.join(places.HERE, "serve.py")
_DETACHED = {"start_new_session": True} if os.name == "posix" else {"creationflags": 0x00000208}


class Preview(Algorithm):
    NAME = "preview"
    TITLE = "Open preview"
    SENTENCE = (
        "Shows a terrain folder on a globe in the web browser. A small web server of its own hands out the folder to this "
        "machine only, with the headers CesiumJS needs, and ends when nobody looks any more. A folder without a preview page "
        "is shown with one all the same; nothing is written into it."
    )
    TAGS = ["globe", "browser", "server", "3d"]

    def initAlgorithm(self, configuration=None):
        self.addParameter(QgsProcessingParameterFile("INPUT", "Terrain folder", QgsProcessingParameterFile.Folder))
        self.addParameter(QgsProcessingParameterBoolean("BROWSER", "Open the web browser", defaultValue=True))
        cesium = QgsProcessingParameterFile(
            "CESIUM", "Folder of a CesiumJS build", QgsProcessingParameterFile.Folder, optional=True
        )
        cesium.setHelp("Used instead of Cesium's download site where the folder has no page of its own.")
        minutes = QgsProcessingParameterNumber(
            "MINUTES", "End the server after so many minutes without a visitor", defaultValue=30, minValue=1, maxValue=1440
        )
        for parameter in (cesium, minutes):
            parameter.setFlags(parameter.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
            self.addParameter(parameter)
        self.addOutput(QgsProcessingOutputString("URL", "Address of the preview"))

    def processAlgorithm(self, parameters, context, feedback):
        folder = os.path.abspath(self.parameterAsString(parameters, "INPUT", context))
        cesium = self.parameterAsString(parameters, "CESIUM", context)
        minutes = self.parameterAsInt(parameters, "MINUTES", context)
        if not os.path.isfile(os.path.join(folder, "layer.json")):
            raise QgsProcessingException(f"{folder} is no terrain: it has no layer.json.")
        if cesium and not os.path.isfile(os.path.join(cesium, "Cesium.js")):
            raise QgsProcessingException(f"{cesium} is no CesiumJS build: it has no Cesium.js.")
        if not serve.has_page(folder):
            feedback.pushInfo("The folder has no preview page (gdal2qmesh -w cesium): the server adds one.")
        url = start_server(folder, ["--idle", str(60 * minutes), *(["--cesium", cesium] if cesium else [])])
        feedback.pushInfo(f"The terrain is at {url}")
        if self.parameterAsBool(parameters, "BROWSER", context) and not _open_browser(url):
            feedback.pushWarning(f"No web browser could be opened; open {url} yourself.")
        return {"URL": url}


def start_server(folder, words):
    """Starts the server in a process of its own, which outlives this one: qgis_process ends when an algorithm does.
    Returns its address."""
    python = places.python()
    if python is None:
        raise QgsProcessingException("No Python interpreter was found to run the web server with.")
    process = subprocess.Popen(
        [python, _SCRIPT, folder, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        cwd=os.path.dirname(_SCRIPT), **_DETACHED,
    )
    with process.stdout:
        url = process.stdout.readline().decode("utf-8").strip()
    if not url:
        raise QgsProcessingException(f"The web server did not start: {python} {_SCRIPT}")
    return url


def _open_browser(url):
    """False where there is none. Without a screen a text browser would wait for its user."""
    if sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        return False
    return webbrowser.open(url)
