# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""What every node of every level must be: the definition of a node, written once more in numpy.

At the finest level a node is the bilinear value of the source at its position: valid where a valid
pixel's closed square holds it, the weighted mean of the valid ones of the four pixels around it.
Each coarser level is [1 2 1] x [1 2 1] over the valid nodes, valid where their weight is at least
half of the whole. Positions come from an exact transformation (no approximation of the product's).

Beside each value stands a tolerance: what moving the position by the product's allowance (a fraction
of a pixel, for sources that need a projection) may change, and where it may change the validity.

The tolerance: positions may be off by ALLOWANCE along x and along y. Along either the bilinear
surface has no jumps, and per pixel it rises by no more than the span of the pixels around (all that
a position within the allowance reads): a height may be off by 2 ALLOWANCE span. Where some of four
pixels are void the weights of the others are divided by their sum, at least 1/2 where the valid ones
are not in line (else it makes no difference): twice that."""

from dataclasses import dataclass

import numpy as np
from osgeo import gdal, osr
from scipy.interpolate import RectBivariateSpline

gdal.UseExceptions()
osr.UseExceptions()

_CONTROL = 8  # nodes between two exact transformations
ALLOWANCE = 1.0 / 1024.0  # pixels: see autotest/cpp/source/test_node_positions.cpp


@dataclass
class Level:
    """Nodes of a window of the lattice: arrays [row, column], row 0 = lattice row j0."""

    i0: int
    j0: int
    height: np.ndarray  # metres, NaN: void
    tolerance: np.ndarray  # metres
    doubtful: np.ndarray  # validity may differ


class Source:
    """The pixels of a band: heights as float64, NaN where void."""

    def __init__(self, path, srs=None, band=1, nodata=None, pixels=None):
        """`pixels`: a function applied to the array of heights (units, depths)."""
        dataset = gdal.Open(str(path))
        self.transform = np.array(dataset.GetGeoTransform())
        raster = dataset.GetRasterBand(band)
        values = raster.ReadAsArray().astype(float)
        nodata = raster.GetNoDataValue() if nodata is None else nodata
        void = ~np.isfinite(values)
        if nodata is not None:
            void |= values == nodata
        values = values * (raster.GetScale() or 1.0) + (raster.GetOffset() or 0.0)
        self.values = np.where(void, np.nan, values if pixels is None else pixels(values))
        self.srs = osr.SpatialReference()
        self.srs.SetFromUserInput(srs or dataset.GetProjection())
        self.srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        self.wgs84 = osr.SpatialReference()
        self.wgs84.ImportFromEPSG(4326)
        self.wgs84.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        self.affine = bool(self.srs.IsGeographic() and self.srs.IsSameGeogCS(self.wgs84))
        self._forward = osr.CoordinateTransformation(self.wgs84, self.srs)
        self._backward = osr.CoordinateTransformation(self.srs, self.wgs84)
        t = self.transform
        self._inverse = np.linalg.inv(np.array([[t[1], t[2]], [t[4], t[5]]]))
        rows, columns = self.values.shape
        self.periodic = self.affine and abs(abs(t[1]) * columns - 360.0) < 1e-6 and t[2] == 0

    def outline(self):
        """(lon, lat) of a fine grid over the raster, edges included."""
        rows, columns = self.values.shape
        px, py = np.meshgrid(np.linspace(0, columns, 65), np.linspace(0, rows, 65))
        x = self.transform[0] + px * self.transform[1] + py * self.transform[2]
        y = self.transform[3] + px * self.transform[4] + py * self.transform[5]
        if self.affine:
            return x.ravel(), y.ravel()
        points = self._backward.TransformPoints(np.column_stack([x.ravel(), y.ravel()]).tolist())
        return np.array(points)[:, 0], np.array(points)[:, 1]

    def holds(self, lon, lat):
        """True where the position lies on the raster."""
        try:
            px, py = self.pixel_of(lon, lat)
        except RuntimeError:
            return False
        rows, columns = self.values.shape
        return 0 <= px <= columns and 0 <= py <= rows

    def pixel_of(self, lon, lat):
        """Exact position on the raster of one point; pixel centres at + 0.5."""
        x, y = (lon, lat) if self.affine else self._forward.TransformPoint(lon, lat)[:2]
        return self._inverse @ (x - self.transform[0], y - self.transform[3])

    def pixel_grid(self, lon, lat):
        """A function of two row numbers first, last: (px, py), each [row, column], of the rows
        first..last-1 of the lattice of these longitudes and latitudes."""
        if self.affine:
            return lambda first, last: self._affine_grid(lon, lat[first:last])
        control_lon = np.interp(_control_positions(len(lon)), np.arange(len(lon)), lon)
        control_lat = np.interp(_control_positions(len(lat)), np.arange(len(lat)), lat)
        exact = np.array([[self.pixel_of(a, b) for a in control_lon] for b in control_lat])
        splines = [
            RectBivariateSpline(control_lat, control_lon, exact[:, :, k], s=0) for k in (0, 1)
        ]
        return lambda first, last: tuple(spline(lat[first:last], lon) for spline in splines)

    def _affine_grid(self, lon, lat):
        t = self.transform
        middle = t[0] + t[1] * self.values.shape[1] / 2 + t[2] * self.values.shape[0] / 2
        shifted = lon - 360.0 * np.round((lon - middle) / 360.0)
        dx = (shifted - t[0])[None, :]
        dy = (lat - t[3])[:, None]
        inverse = self._inverse
        return (inverse[0, 0] * dx + inverse[0, 1] * dy, inverse[1, 0] * dx + inverse[1, 1] * dy)

    def _pixels(self, column, row):
        """Heights of pixels, NaN off the raster."""
        rows, columns = self.values.shape
        inside = (row >= 0) & (row < rows)
        if self.periodic:
            column = column % columns
        else:
            inside = inside & (column >= 0) & (column < columns)
        got = self.values[np.clip(row, 0, rows - 1), np.clip(column, 0, columns - 1)]
        return np.where(inside, got, np.nan)

    def _touched(self, px, py, margin):
        """(any, all) of the pixels within `margin` of the position valid."""
        some = np.zeros(px.shape, bool)
        every = np.ones(px.shape, bool)
        for dx in (-margin, margin):
            for dy in (-margin, margin):
                column = np.floor(px + dx).astype(np.int64)
                row = np.floor(py + dy).astype(np.int64)
                valid = ~np.isnan(self._pixels(column, row))
                some |= valid
                every &= valid
        return some, every

    def sample(self, px, py):
        """(height, tolerance, doubtful) at positions on the raster."""
        allowance = 0.0 if self.affine else ALLOWANCE
        valid, _ = self._touched(px, py, 1e-6)
        column = np.floor(px - 0.5).astype(np.int64)
        row = np.floor(py - 0.5).astype(np.int64)
        fx, fy = px - 0.5 - column, py - 0.5 - row
        taps, weights = [], []
        for dy, wy in ((0, 1 - fy), (1, fy)):
            for dx, wx in ((0, 1 - fx), (1, fx)):
                taps.append(self._pixels(column + dx, row + dy))
                weights.append(wx * wy)
        taps, weights = np.stack(taps), np.stack(weights)
        known = ~np.isnan(taps)
        total = (weights * known).sum(axis=0)
        with np.errstate(invalid="ignore", divide="ignore"):
            height = (weights * np.where(known, taps, 0.0)).sum(axis=0) / total
        height = np.where(valid & (total > 0), height, np.nan)
        if not allowance:
            return height, np.zeros(px.shape), np.zeros(px.shape, bool)
        some, every = self._touched(px, py, allowance)
        return height, 2.0 * allowance * self._rise(px, py, allowance), some & ~every

    def _rise(self, px, py, margin):
        """What the surface at positions within `margin` rises per pixel at most."""
        low, high = np.full(px.shape, np.inf), np.full(px.shape, -np.inf)
        void = np.zeros(px.shape, bool)
        for dy in (-0.5 - margin, 0.0, 0.5 + margin):
            for dx in (-0.5 - margin, 0.0, 0.5 + margin):
                column, row = (np.floor(at).astype(np.int64) for at in (px + dx, py + dy))
                pixel = self._pixels(column, row)
                low, high = np.fmin(low, pixel), np.fmax(high, pixel)
                void |= np.isnan(pixel)
        return np.where(low <= high, high - low, 0.0) * np.where(void, 2.0, 1.0)


def _control_positions(count):
    last = count - 1
    steps = max(4, -(-last // _CONTROL))
    return np.linspace(0, last, steps + 1)


class Nodes:
    """The nodes of all levels 0..max_zoom of a source."""

    def __init__(self, source, scheme, cells, max_zoom, void_fill=0.0, box=None, node_heights=None):
        """`box`: (west, south, east, north) in degrees, void outside. `node_heights`: a function
        applied to the sampled heights (scales, clips)."""
        self.source, self.scheme, self.cells = source, scheme, cells
        self.void_fill = void_fill
        self.box = box
        self.node_heights = node_heights
        self.poles = {True: self._pole_height(90.0), False: self._pole_height(-90.0)}
        self.levels = {max_zoom: self._finest(max_zoom)}
        for z in range(max_zoom, 0, -1):
            self.levels[z - 1] = self._reduced(self.levels[z], z)

    def columns(self, z):
        return self.scheme.tiles_x(z) * self.cells

    def last_row(self, z):
        return self.scheme.tiles_y(z) * self.cells

    def tile(self, z, x, y):
        """(heights with voids filled, tolerance, doubtful, void) of a tile's nodes, [row, column]."""
        level, n = self.levels[z], self.cells
        i = (x * n + np.arange(n + 1) - level.i0) % self.columns(z)
        j = y * n + np.arange(n + 1) - level.j0
        rows, columns = level.height.shape
        inside = ((j >= 0) & (j < rows))[:, None] & (i < columns)[None, :]
        at = np.ix_(np.clip(j, 0, rows - 1), np.clip(i, 0, columns - 1))
        height = np.where(inside, level.height[at], np.nan)
        tolerance = np.where(inside, level.tolerance[at], 0.0)
        doubtful = inside & level.doubtful[at]
        if self.scheme.profile == "geodetic":
            for north, row in ((False, 0), (True, self.last_row(z))):
                if y * n <= row <= y * n + n:
                    height[row - y * n, :] = self.poles[north]
                    doubtful[row - y * n, :] = False
        void = np.isnan(height)
        return np.where(void, self.void_fill, height), tolerance, doubtful, void

    def _window(self, z):
        """(i0, columns, j0, rows) of the lattice that holds all nodes on the source."""
        lon, lat = self.source.outline()
        south, north = lat.min(), lat.max()
        whole = self.source.periodic
        for pole in (90.0, -90.0):
            if not self.source.affine and self.source.holds(0.0, pole):
                whole = True
                south, north = min(south, pole), max(north, pole)
        columns, last = self.columns(z), self.last_row(z)
        j0 = int(np.floor(self.scheme.fraction_y(np.clip(south, -89.9999, 89.9999)) * last)) - 2
        j1 = int(np.ceil(self.scheme.fraction_y(np.clip(north, -89.9999, 89.9999)) * last)) + 2
        j0, j1 = max(0, j0), min(last, j1)
        if whole:
            return 0, columns, j0, j1 - j0 + 1
        west, width = _narrowest(lon)
        margin = 2 + int(0.02 * width / 360.0 * columns * (not self.source.affine))
        i0 = int(np.floor((west + 180.0) / 360.0 * columns)) - margin
        i1 = int(np.ceil((west + width + 180.0) / 360.0 * columns)) + margin
        if i1 - i0 + 1 >= columns:
            i0, i1 = 0, columns - 1
        return i0, i1 - i0 + 1, j0, j1 - j0 + 1

    def _finest(self, z):
        i0, width, j0, height = self._window(z)
        lon = self.scheme.longitude(i0 + np.arange(width), self.columns(z))
        lat = self.scheme.latitude(j0 + np.arange(height), self.last_row(z))
        pixels = self.source.pixel_grid(lon, lat)
        parts = [self.source.sample(*pixels(a, min(a + 256, height))) for a in range(0, height, 256)]
        values, tolerance, doubtful = (np.concatenate(part) for part in zip(*parts))
        if self.box is not None:
            west, south, east, north = self.box
            inside = ((lat >= south) & (lat <= north))[:, None] & ((lon >= west) & (lon <= east))
            values = np.where(inside, values, np.nan)
        if self.node_heights is not None:
            values = self.node_heights(values)
        return Level(i0, j0, values, tolerance, doubtful)

    def _reduced(self, fine, z):
        """The level z - 1 from the level z."""
        rows, columns = fine.height.shape
        whole = columns == self.columns(z)
        j0 = fine.j0 // 2
        j1 = -(-(fine.j0 + rows - 1) // 2)
        i0 = 0 if whole else fine.i0 // 2
        width = columns // 2 if whole else -(-(fine.i0 + columns - 1) // 2) - i0 + 1
        j = 2 * np.arange(j0, j1 + 1) - fine.j0
        i = 2 * np.arange(i0, i0 + width) - fine.i0
        total = np.zeros((len(j), width))
        weight, doubt = np.zeros_like(total), np.zeros_like(total)
        tolerance = np.zeros_like(total)
        low, high = np.full_like(total, np.inf), np.full_like(total, -np.inf)
        for dj, wj in ((-1, 1), (0, 2), (1, 1)):
            for di, wi in ((-1, 1), (0, 2), (1, 1)):
                column = (i + di) % columns if whole else i + di
                inside = ((j + dj >= 0) & (j + dj < rows))[:, None] & (
                    (column >= 0) & (column < columns)
                )[None, :]
                at = np.ix_(np.clip(j + dj, 0, rows - 1), np.clip(column, 0, columns - 1))
                value = np.where(inside, fine.height[at], np.nan)
                valid = ~np.isnan(value)
                w = wi * wj / 16.0 * valid
                total += w * np.where(valid, value, 0.0)
                weight += w
                tolerance += w * fine.tolerance[at]
                doubt += wi * wj / 16.0 * (inside & fine.doubtful[at])
                low = np.where(valid, np.minimum(low, value), low)
                high = np.where(valid, np.maximum(high, value), high)
        valid = weight >= 0.5
        some = np.maximum(weight, 1e-9)
        height = np.where(valid, total / some, np.nan)
        # A node whose validity is in doubt may add to or be missing from the mean.
        span = np.where(weight > 0, high - low, 0.0)
        tolerance = tolerance / some + 2.0 * doubt / some * span
        doubtful = (doubt > 0) & (weight - doubt < 0.5) & (weight + doubt >= 0.5)
        # Where the doubtful nodes are void here, their heights are unknown: leave such nodes out.
        unknown = (doubt > 0) & ~valid
        return Level(i0, j0, height, tolerance, doubtful | unknown)

    def _pole_height(self, latitude):
        """Mean of the valid values at 1024 longitudes at a pole; NaN where there are none."""
        outside = self.box is not None and not self.box[1] <= latitude <= self.box[3]
        if self.scheme.profile != "geodetic" or outside:
            return np.nan
        lon = -180.0 + 360.0 * np.arange(1024) / 1024
        if self.source.affine:
            px, py = self.source.pixel_grid(lon, np.array([latitude]))(0, 1)
        elif self.source.holds(0.0, latitude):
            px, py = np.array([self.source.pixel_of(a, latitude) for a in lon]).T
        else:
            return np.nan
        values = self.source.sample(px.ravel(), py.ravel())[0]
        values = values[~np.isnan(values)]
        if not len(values):
            return np.nan
        mean = values.mean()
        return float(mean if self.node_heights is None else self.node_heights(mean))


def _narrowest(lon):
    """(west, width) of the narrowest arc that holds all longitudes; west may be below -180."""
    turned = np.sort(np.mod(lon, 360.0))
    gaps = np.diff(np.append(turned, turned[0] + 360.0))
    k = int(gaps.argmax())
    west = turned[(k + 1) % len(turned)]
    west = west - 360.0 if west >= 180.0 else west
    return west, 360.0 - gaps[k]
