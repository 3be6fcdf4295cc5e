# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""WGS 84: positions, directions, spheres and horizons. Arrays of shape (n, 3), metres (ECEF)."""

import numpy as np

RADII = np.array([6378137.0, 6378137.0, 6356752.3142451793])
_E2 = 1.0 - (RADII[2] / RADII[0]) ** 2


def surface_normal(lon, lat):
    """Outward unit normals of the ellipsoid; degrees."""
    lon, lat = np.radians(lon), np.radians(lat)
    return np.stack([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)], axis=-1)


def ecef(lon, lat, height):
    """Earth-centred positions; degrees and metres above the ellipsoid."""
    normal = surface_normal(lon, lat)
    prime = RADII[0] / np.sqrt(1.0 - _E2 * normal[..., 2] ** 2)
    scale = np.stack([prime + height, prime + height, prime * (1.0 - _E2) + height], axis=-1)
    return normal * scale


def metres_per_degree(lat):
    """(east, north) metres that a degree spans at a latitude."""
    s = np.sin(np.radians(lat))
    w2 = 1.0 - _E2 * s * s
    east = RADII[0] / np.sqrt(w2) * np.cos(np.radians(lat))
    north = RADII[0] * (1.0 - _E2) / w2**1.5
    return np.radians(east), np.radians(north)


def gradient_normal(lon, lat, slope_east, slope_north):
    """Unit normals (ECEF) of a surface that rises by these slopes (metres per metre)."""
    up = surface_normal(lon, lat)
    lo, la = np.radians(lon), np.radians(lat)
    east = np.stack([-np.sin(lo), np.cos(lo), np.zeros_like(lo)], axis=-1)
    north = np.stack([-np.sin(la) * np.cos(lo), -np.sin(la) * np.sin(lo), np.cos(la)], axis=-1)
    n = up - east * np.asarray(slope_east)[..., None] - north * np.asarray(slope_north)[..., None]
    return n / np.linalg.norm(n, axis=-1, keepdims=True)


def oct_decode(pairs):
    """Unit vectors of octvertexnormals; `pairs` is (n, 2) uint8."""
    p = pairs.astype(float) / 255.0 * 2.0 - 1.0
    z = 1.0 - np.abs(p).sum(axis=1)
    folded = (1.0 - np.abs(p[:, ::-1])) * np.where(p < 0.0, -1.0, 1.0)
    xy = np.where((z < 0.0)[:, None], folded, p)
    n = np.column_stack([xy, z])
    return n / np.linalg.norm(n, axis=1, keepdims=True)


def small_sphere_radius(points, rounds=60):
    """Radius of a nearly smallest sphere around the points: Badoiu and Clarkson's walk."""
    centre = (points.min(axis=0) + points.max(axis=0)) / 2.0
    best = np.inf
    for k in range(rounds):
        distance = np.linalg.norm(points - centre, axis=1)
        far = int(distance.argmax())
        best = min(best, float(distance[far]))
        centre = centre + (points[far] - centre) / (k + 2.0)
    return best


def below_horizon(viewer, points, margin):
    """Which points the ellipsoid hides from a viewer outside it, all in scaled space (positions
    divided by the radii). A point counts as hidden unless it clears the horizon by `margin`."""
    reach = viewer @ viewer - 1.0
    to_point = points - viewer
    along = -(to_point @ viewer)
    behind_plane = along > reach - margin
    in_cone = along * along > (reach - margin) * (to_point * to_point).sum(axis=1)
    return behind_plane & in_cone


def horizon_magnitude(direction, points):
    """How far out (scaled space) on the unit `direction` the horizon point of `points` must lie;
    None where there is none. A point under the ellipsoid counts as on it."""
    length = np.maximum(np.linalg.norm(points, axis=1), 1e-12)
    cos_alpha = (points @ direction) / length
    sin_alpha = np.linalg.norm(np.cross(points / length[:, None], direction), axis=1)
    length = np.maximum(length, 1.0)
    cos_beta = 1.0 / length
    sin_beta = np.sqrt(np.maximum(length * length - 1.0, 0.0)) * cos_beta
    denominator = cos_alpha * cos_beta - sin_alpha * sin_beta
    if (denominator <= 1e-6).any():
        return None
    return float((1.0 / denominator).max())
