# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""DEMs and sets that the tests of a session share: each is made once, when it is first asked for."""

import dems as dem_table
import harness
import pytest


def shared_dems(folder, missing=None):
    """A function name -> path of that DEM; skips where a real DEM is not there and adds its name to `missing`."""
    makers = {**dem_table.DEMS, **dem_table.SMALL}
    made = {}

    def get(name):
        if name not in made:
            made[name] = makers[name](folder / f"{name}.tif")
        if made[name] is None:
            if missing is not None:
                missing.append(name)
            pytest.skip(f"no real DEM {name} in {harness.DATA}: set QMESH_TEST_DATA to the folder that holds it")
        return made[name]

    return get


def shared_sets(folder, dem, opened):
    """A function (DEM name, options...) -> opened(folder of the set)."""
    built = {}

    def get(name, *options):
        key = (name, *map(str, options))
        if key not in built:
            output = folder / f"{len(built)}-{name}"
            harness.gdal2qmesh(*options, dem(name), output).succeeded()
            built[key] = opened(output)
        return built[key]

    return get
