# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""What all algorithms of the provider share."""

import os

from qgis.core import QgsProcessingAlgorithm
from qgis.PyQt.QtGui import QIcon

from .. import places


class Algorithm(QgsProcessingAlgorithm):
    """`NAME`, `TITLE`, `SENTENCE` and `TAGS` describe it; `COMMAND` is the program it cannot do without, or None."""

    NAME = ""
    TITLE = ""
    SENTENCE = ""
    TAGS = []
    COMMAND = None

    def createInstance(self):
        return type(self)()

    def name(self):
        return self.NAME

    def displayName(self):
        return self.TITLE

    def shortDescription(self):
        return self.SENTENCE

    def shortHelpString(self):
        return f"<p>{self.SENTENCE}</p>"

    def tags(self):
        return ["terrain", "cesium", "quantized mesh", "qmesh", "dem", "tiles", *self.TAGS]

    def icon(self):
        return QIcon(self.svgIconPath())

    def svgIconPath(self):
        return os.path.join(places.HERE, "icon.svg")

    def canExecute(self):
        if self.COMMAND and places.find_command(self.COMMAND) is None:
            return False, places.missing_command(self.COMMAND)
        return True, ""
