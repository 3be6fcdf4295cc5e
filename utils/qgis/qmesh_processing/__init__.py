# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""QGIS plugin: quantized-mesh terrain in the Processing toolbox. Needs QGIS 3.22 or newer."""


def classFactory(iface):
    """Called by QGIS; `iface` is None in qgis_process."""
    from .plugin import QmeshPlugin

    return QmeshPlugin(iface)
