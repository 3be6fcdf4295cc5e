# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""show_dialog.py ALGORITHM PICTURE.png [--advanced]: the dialog of an algorithm as QGIS shows it; needs a display."""

import os
import sys

os.environ["QT_QPA_PLATFORM"] = "xcb"
import conftest  # noqa: E402

os.environ["QT_QPA_PLATFORM"] = "xcb"


def dialog(algorithm):
    from processing.gui.AlgorithmDialog import AlgorithmDialog
    from qgis.core import QgsApplication, QgsProject, QgsRasterLayer

    # The dialog offers the layers of the project.
    QgsProject.instance().addMapLayer(QgsRasterLayer(str(conftest.DEM), "Jacksboro SRTM"))
    return AlgorithmDialog(QgsApplication.processingRegistry().createAlgorithmById(algorithm))


def main():
    from qgis.PyQt.QtTest import QTest

    application, _ = conftest.start_qgis(window=True)
    shown = dialog(sys.argv[1])
    shown.resize(960, 1180)
    shown.show()
    if "--advanced" in sys.argv:
        from qgis.PyQt.QtWidgets import QToolButton

        for button in shown.findChildren(QToolButton):
            if button.metaObject().className() == "QgsGroupBoxCollapseButton":
                button.click()
    QTest.qWait(1500)
    saved = shown.grab().save(sys.argv[2])
    sys.stdout.flush()
    os._exit(0 if saved else 1)


if __name__ == "__main__":
    main()
