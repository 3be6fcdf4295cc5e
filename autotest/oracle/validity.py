# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Promise P6: what every tile must be. Each function returns a list of faults, empty when valid."""

import math

import numpy as np

from . import earth
from .scheme import QUANTIZED_MAX


def _side_masks(tile):
    return {
        "west": tile.u == 0,
        "south": tile.v == 0,
        "east": tile.u == QUANTIZED_MAX,
        "north": tile.v == QUANTIZED_MAX,
    }


def _vertex_faults(tile):
    faults = []
    if len(tile.u) == 65536:
        faults.append("exactly 65536 vertices")
    if len(np.unique(tile.u * 65536 + tile.v)) != len(tile.u):
        faults.append("two vertices at one place")
    if len(np.unique(tile.triangles)) != len(tile.u):
        faults.append("a vertex is not used")
    return faults


def _area_faults(tile):
    a, b, c = (np.stack([tile.u[i], tile.v[i]]) for i in tile.triangles.T)
    doubled = (b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]
    faults = []
    if (doubled <= 0).any():
        faults.append(f"{int((doubled <= 0).sum())} triangles are flipped or have no area")
    if int(doubled.sum()) != 2 * QUANTIZED_MAX**2:
        faults.append(f"the areas sum to {int(doubled.sum())}, not to {2 * QUANTIZED_MAX ** 2}")
    return faults


def _edge_faults(tile):
    """Every inner edge in two triangles, once in each direction; the others on the border."""
    t = tile.triangles
    start = np.concatenate([t[:, 0], t[:, 1], t[:, 2]])
    end = np.concatenate([t[:, 1], t[:, 2], t[:, 0]])
    count = len(tile.u)
    forward, backward = start * count + end, end * count + start
    faults = []
    if len(np.unique(forward)) != len(forward):
        faults.append("an edge is used twice in one direction")
    lone = ~np.isin(forward, backward)
    on_side = np.zeros(len(forward), bool)
    for name, mask in _side_masks(tile).items():
        along = tile.v if name in ("west", "east") else tile.u
        this = lone & mask[start] & mask[end]
        on_side |= this
        if int(np.abs(along[end[this]] - along[start[this]]).sum()) != QUANTIZED_MAX:
            faults.append(f"the border edges do not cover the {name} side once")
    if (lone & ~on_side).any():
        faults.append(f"{int((lone & ~on_side).sum())} lone edges inside the square")
    return faults


def _edge_list_faults(tile):
    faults = []
    for name, mask in _side_masks(tile).items():
        listed = tile.edges[name]
        if len(np.unique(listed)) != len(listed):
            faults.append(f"the {name} edge lists a vertex twice")
        if set(listed.tolist()) != set(np.flatnonzero(mask).tolist()):
            faults.append(f"the {name} edge list is not exactly the vertices on that edge")
    return faults


def mesh_faults(tile):
    """The triangulation and the edge lists."""
    return _vertex_faults(tile) + _area_faults(tile) + _edge_faults(tile) + _edge_list_faults(tile)


def header_faults(tile, box):
    """Heights, sphere and centre of the header against the decoded vertices."""
    numbers = np.concatenate(
        [tile.centre, tile.sphere_centre, tile.horizon]
        + [[tile.min_height, tile.max_height, tile.sphere_radius]]
    )
    if not np.isfinite(numbers).all():
        return ["the header holds a number that is not finite"]
    faults = []
    if not tile.min_height < tile.max_height:
        faults.append(f"min height {tile.min_height} is not below max height {tile.max_height}")
    points = tile.ecef(box)
    reach = float(np.linalg.norm(points - tile.sphere_centre, axis=1).max())
    if reach > tile.sphere_radius * (1 + 1e-12) + 1e-6:
        faults.append(f"a vertex is {reach - tile.sphere_radius:.3f} m outside the sphere")
    smallest = earth.small_sphere_radius(points)
    if tile.sphere_radius > 1.3 * smallest + 1e-3:
        faults.append(f"sphere radius {tile.sphere_radius:.1f} m where {smallest:.1f} m would do")
    if np.linalg.norm(tile.centre - tile.sphere_centre) > tile.sphere_radius:
        faults.append("the centre lies outside the bounding sphere")
    return faults


def horizon_faults(tile, box, seed=1, viewers=40):
    """The horizon point: whoever does not see it sees no vertex, and it is no farther out than
    that needs. Viewers are random, most of them near the tile's horizon, where it matters."""
    points = tile.ecef(box) / earth.RADII
    point = tile.horizon
    if not np.isfinite(point).all():
        return ["the horizon point is not finite"]
    magnitude = math.hypot(*point)
    if magnitude < 1 - 1e-12:
        return [f"the horizon point's distance is {magnitude}"]
    direction = tile.sphere_centre / earth.RADII
    if np.linalg.norm(direction) < 1e-6:
        return []
    direction = direction / np.linalg.norm(direction)
    faults = []
    if tile.min_height >= 0:
        needed = earth.horizon_magnitude(point / magnitude, points)
        if needed is not None and needed < 100:
            # A vertex on the ellipsoid is a rounding error above or below it: 1e-8 of the radius.
            if magnitude < needed * (1 - 1e-7):
                faults.append(f"the horizon point is at {magnitude:.9f}, {needed:.9f} is needed")
            if magnitude > max(needed * 1.001, 1 + (needed - 1) * 1.1 + 1e-9):
                faults.append(f"the horizon point is at {magnitude:.9f}, {needed:.9f} would do")
        for viewer in _viewers(direction, points, magnitude, np.random.default_rng(seed), viewers):
            hidden = earth.below_horizon(viewer, point[None, :], 0.0)[0]
            if hidden and not earth.below_horizon(viewer, points, 1e-9).all():
                faults.append(f"the viewer at {viewer} sees a vertex but not the horizon point")
                break
    return faults


def _viewers(direction, points, magnitude, random, count):
    """Positions in scaled space; none for a point so far out that nobody ever loses it. A viewer at
    distance d loses a point at distance m at the angle acos(1/d) + acos(1/m); most viewers stand
    within a little of it."""
    spread = np.arccos(np.clip(1.0 / max(magnitude, 1.0), 0, 1))
    for k in range(count if magnitude < 1e6 else 0):
        distance = 1.0 + 10.0 ** random.uniform(-6, 0.5)
        critical = np.arccos(1.0 / distance) + spread
        angle = critical * (1 + random.uniform(-0.05, 0.05)) if k % 4 else random.uniform(0, np.pi)
        angle = min(np.pi, angle)
        side = np.cross(direction, random.normal(size=3))
        side /= np.linalg.norm(side)
        yield distance * (np.cos(angle) * direction + np.sin(angle) * side)
