"""Shapely geometries, through ragged arrays: no WKB, and no Python object a ring of ours."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import shapely

from oblast import _core
from oblast._regions import Regions
from oblast._z import ZRule, z_left_out

_POLYGON, _MULTIPOLYGON, _MISSING, _COLLECTION = 3, 6, -1, 7


def _flat(geometries: npt.NDArray[np.object_]) -> npt.NDArray[np.object_]:
    """Polygons and multipolygons only; a missing geometry becomes an empty one, others are a TypeError."""
    types = shapely.get_type_id(geometries)
    odd = ~np.isin(types, (_POLYGON, _MULTIPOLYGON))
    if not odd.any():
        return geometries
    empty = (types == _MISSING) | shapely.is_empty(geometries)
    wrong = np.flatnonzero(odd & ~empty)
    if len(wrong):
        raise TypeError(f"row {wrong[0]} is a {geometries[wrong[0]].geom_type}; expected Polygon, MultiPolygon or None")
    geometries = geometries.copy()
    geometries[odd] = shapely.Polygon()
    return geometries


def from_shapely(geometries: Any, z: ZRule = "warn") -> Regions:
    """See `oblast.from_shapely`."""
    array = _flat(np.atleast_1d(np.asarray(geometries, dtype=object)).ravel())
    if len(array) == 0:
        zero = np.zeros(1, dtype=np.int32)
        return Regions._of(_core.arrays(np.empty((0, 2)), zero, zero, zero))
    has_z = bool(shapely.has_z(array).any() or shapely.has_m(array).any())
    z_left_out(has_z, z, stacklevel=4)
    _, points, offsets = shapely.to_ragged_array(array, include_z=False, include_m=False)
    rings, polygons, *rows = (np.asarray(part, dtype=np.int32) for part in offsets)
    parts = rows[0] if rows else np.arange(len(polygons), dtype=np.int32)
    return without_empty_polygons(np.ascontiguousarray(points), rings, polygons, parts)


def without_empty_polygons(
    points: npt.NDArray[np.float64],
    rings: npt.NDArray[np.int32],
    polygons: npt.NDArray[np.int32],
    rows: npt.NDArray[np.int32],
) -> Regions:
    """An empty polygon has no rings; the row keeps its place, without a polygon."""
    full = np.diff(polygons) > 0
    if not full.all():
        kept = np.concatenate(([0], np.cumsum(full))).astype(np.int32)
        rows = kept[rows]
        polygons = np.concatenate((polygons[:1], polygons[1:][full]))
    return Regions._of(_core.arrays(points, rings, polygons, rows))


def to_shapely(regions: Regions) -> npt.NDArray[np.object_]:
    """See `Regions.to_shapely`."""
    rows = regions.row_offsets
    counts = np.diff(rows)
    made = np.empty(len(regions), dtype=object)
    made[counts == 0] = shapely.Polygon()
    offsets = (regions.ring_offsets, regions.polygon_offsets)
    if len(regions.points) == 0:
        return made
    polygons = shapely.from_ragged_array(shapely.GeometryType.POLYGON, regions.points, offsets)
    single = counts == 1
    made[single] = polygons[rows[:-1][single]]
    several = np.flatnonzero(counts > 1)
    if len(several):
        places = np.repeat(counts > 1, counts)
        numbers = np.repeat(np.arange(len(several)), counts[several])
        made[several] = shapely.multipolygons(polygons[places], indices=numbers)
    return made
