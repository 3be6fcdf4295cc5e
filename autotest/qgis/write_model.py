# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""write_model.py FILE.model3: a model with the algorithm Generate, saved as the model designer does."""

import os
import sys

import conftest


def model():
    from qgis.core import (
        QgsProcessingModelAlgorithm,
        QgsProcessingModelChildAlgorithm,
        QgsProcessingModelChildParameterSource as Source,
        QgsProcessingModelOutput,
        QgsProcessingModelParameter,
        QgsProcessingParameterRasterLayer,
        QgsProcessingParameterString,
    )

    made = QgsProcessingModelAlgorithm("terrain", "tests")
    made.addModelParameter(QgsProcessingParameterRasterLayer("dem", "DEM"), QgsProcessingModelParameter("dem"))
    made.addModelParameter(QgsProcessingParameterString("error", "Max error"), QgsProcessingModelParameter("error"))
    child = QgsProcessingModelChildAlgorithm("qmesh:generate")
    child.setChildId("generate")
    child.addParameterSources("INPUT", [Source.fromModelParameter("dem")])
    child.addParameterSources("MAX_ERROR", [Source.fromModelParameter("error")])
    child.addParameterSources("TILESIZE", [Source.fromStaticValue("64")])
    child.addParameterSources("MAX_ZOOM", [Source.fromStaticValue(8)])
    output = QgsProcessingModelOutput("terrain", "terrain")
    output.setChildId("generate")
    output.setChildOutputName("OUTPUT")
    child.setModelOutputs({"terrain": output})
    made.addChildAlgorithm(child)
    return made


if __name__ == "__main__":
    application = conftest.start_qgis()
    saved = model().toFile(sys.argv[1])
    sys.stdout.flush()
    os._exit(0 if saved else 1)
