# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The provider `qmesh` of the Processing toolbox."""

import os

from processing.core.ProcessingConfig import ProcessingConfig, Setting
from qgis.core import QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from . import gdal_driver, places
from .algorithms import ALGORITHMS

ICON = os.path.join(places.HERE, "icon.svg")


class QmeshProvider(QgsProcessingProvider):
    def id(self):
        return "qmesh"

    def name(self):
        return "Quantized-mesh terrain"

    def longName(self):
        return "Quantized-mesh terrain (qmesh)"

    def icon(self):
        return QIcon(ICON)

    def svgIconPath(self):
        return ICON

    def load(self):
        ProcessingConfig.settingIcons[self.name()] = self.icon()
        for name, text in places.SETTINGS.items():
            ProcessingConfig.addSetting(Setting(self.name(), name, text, "", valuetype=Setting.FOLDER))
        ProcessingConfig.readSettings()
        gdal_driver.register()
        self.refreshAlgorithms()
        return True

    def unload(self):
        for name in places.SETTINGS:
            ProcessingConfig.removeSetting(name)

    def loadAlgorithms(self):
        for algorithm in ALGORITHMS:
            self.addAlgorithm(algorithm())
