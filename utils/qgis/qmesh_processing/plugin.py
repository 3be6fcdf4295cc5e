# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""What QGIS's plugin manager calls."""

from qgis.core import QgsApplication

from .provider import QmeshProvider


class QmeshPlugin:
    def __init__(self, iface):
        self.iface = iface
        self.provider = None

    def initProcessing(self):
        """All that is needed without a window: qgis_process calls this alone."""
        self.provider = QmeshProvider()
        QgsApplication.processingRegistry().addProvider(self.provider)

    def initGui(self):
        self.initProcessing()

    def unload(self):
        if self.provider is not None:
            QgsApplication.processingRegistry().removeProvider(self.provider)
            self.provider = None
