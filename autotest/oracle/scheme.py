# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The two tiling schemes, their node lattices and what a level promises. Rows count from the south."""

import math

import numpy as np

EARTH_RADIUS = 6378137.0
QUANTIZED_MAX = 32767


class Scheme:
    """The tile matrix set of a profile: "geodetic" (2 x 1 roots) or "mercator" (1 x 1)."""

    def __init__(self, profile):
        if profile not in ("geodetic", "mercator"):
            raise ValueError(f"no such profile: {profile}")
        self.profile = profile
        self.roots = 2 if profile == "geodetic" else 1

    def tiles_x(self, zoom):
        return self.roots << zoom

    def tiles_y(self, zoom):
        return 1 << zoom

    def longitude(self, numerator, denominator):
        """Degrees of the fraction numerator / denominator of the matrix's width."""
        return np.asarray(numerator, dtype=float) * (360.0 / denominator) - 180.0

    def latitude(self, numerator, denominator):
        """Degrees of a fraction of the matrix's height, from its south edge."""
        fraction = np.asarray(numerator, dtype=float) / denominator
        if self.profile == "geodetic":
            return fraction * 180.0 - 90.0
        return np.degrees(np.arctan(np.sinh(math.pi * (2.0 * fraction - 1.0))))

    def fraction_y(self, latitude):
        """The inverse of latitude()."""
        if self.profile == "geodetic":
            return (latitude + 90.0) / 180.0
        return 0.5 + np.arcsinh(np.tan(np.radians(latitude))) / (2.0 * math.pi)

    def box(self, z, x, y):
        """(west, south, east, north) of a tile, degrees."""
        nx, ny = self.tiles_x(z), self.tiles_y(z)
        return (
            float(self.longitude(x, nx)),
            float(self.latitude(y, ny)),
            float(self.longitude(x + 1, nx)),
            float(self.latitude(y + 1, ny)),
        )

    def geometric_error(self, z):
        """The error CesiumJS takes level z for, metres."""
        return EARTH_RADIUS * 2.0 * math.pi * 0.25 / (65.0 * self.roots) / 2.0**z

    def tile_metres(self, z):
        """North-south size of a tile at the equator, metres."""
        extent = math.pi if self.profile == "geodetic" else 2.0 * math.pi
        return EARTH_RADIUS * extent / 2.0**z

    def node_v(self, z, y, cells):
        """Where the cells + 1 node rows of a tile lie in its quantized v (linear in latitude)."""
        latitude = self.latitude(y * cells + np.arange(cells + 1), cells * self.tiles_y(z))
        v = QUANTIZED_MAX * (latitude - latitude[0]) / (latitude[-1] - latitude[0])
        v[0], v[-1] = 0.0, QUANTIZED_MAX
        return v

    def default_max_error(self, z, max_zoom, screen_error=0.5):
        """The level's max error where --max-error is not given, metres."""
        error = screen_error / 2.0 * self.geometric_error(z)
        return error / 2.0 if z == max_zoom else error

    def lattice_step(self, z, max_error):
        """The step S of the level's height lattice, metres: no larger than half the max error unless
        real relief would not fit then."""

        def step_for(metres):
            return max(2.0 ** math.ceil(math.log2(metres / QUANTIZED_MAX)), 2.0**-10)

        size = self.tile_metres(z)
        step = step_for(min(32767.0, 4.0 * size))
        wanted = 2.0 ** math.floor(math.log2(max_error / 2.0)) if max_error > 0 else 0.0
        return min(step, max(wanted, step_for(min(16000.0, size))))


def coarse_step(step, low, high):
    """Step of a tile whose heights low..high are too far apart for 32767 steps S of its level: S
    doubled until they fit; 0 where S does. A border height may be rounded up by half a step."""
    tile_step = step
    while np.floor(low / tile_step) * tile_step + QUANTIZED_MAX * tile_step < high + tile_step / 2:
        tile_step *= 2.0
    return tile_step if tile_step > step else 0.0


def node_u(cells):
    """Where the cells + 1 node columns of a tile lie in its quantized u."""
    return QUANTIZED_MAX * np.arange(cells + 1) / cells


def native_zoom(scheme, cells, cell_degrees):
    """First zoom whose node spacing in degrees of latitude is <= cell_degrees (geodetic only)."""
    zoom = 0
    while 180.0 / (cells * 2.0**zoom) > cell_degrees * (1 + 1e-9):
        zoom += 1
    return zoom
