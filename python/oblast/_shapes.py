"""Regions, lines and points: what `buffer` and `zones` take."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from oblast import _core
from oblast._convert import Operand, geometry_array, is_sequence_of, regions_of
from oblast._regions import Regions
from oblast._z import ZRule, z_left_out

__all__ = ["Shapes", "no_shapes", "points_of", "shapes_of"]

_POINT, _LINE, _RING, _POLYGON = 0, 1, 2, 3
_FIRST_OF_SEVERAL = 4
_POLYGONAL = (3, 6)  # of the OGC's codes: Polygon, MultiPolygon


class Shapes(NamedTuple):
    """The same number of rows three times: a line is a ring of `lines`, a point is one of `points`."""

    regions: Regions
    lines: Regions
    points: Regions


def shapes_of(given: Operand, z: ZRule = "warn") -> Shapes:
    """Convert an operand that may have lines and points."""
    if isinstance(given, bytes):
        given = [given]
    column = geometry_array(given)
    if isinstance(column, list | np.ndarray) and is_sequence_of(column, bytes) and not _are_polygons(column):
        import shapely

        column = shapely.from_wkb(np.array(column, dtype=object))
    if _has_geometries(column):
        return of_shapely(np.atleast_1d(np.asarray(column, dtype=object)).ravel(), z)
    regions = regions_of(given)
    nothing = no_shapes(len(regions))
    return Shapes(regions, nothing, nothing)


def no_shapes(rows: int) -> Regions:
    """Rows without shapes."""
    return _rows_of_parts(np.empty((0, 2)), np.zeros(0, np.int64), np.zeros(0, np.int64), rows)


def points_of(coordinates: npt.NDArray[Any]) -> Shapes:
    """Points, each a row; an array of float64 is viewed."""
    points = np.ascontiguousarray(coordinates, dtype=np.float64)
    nothing, each = no_shapes(len(points)), np.arange(len(points) + 1, dtype=np.int32)
    return Shapes(nothing, nothing, Regions._of(_core.arrays(points, each, each, each)))


def _has_geometries(column: Any) -> bool:
    if hasattr(column, "geom_type"):
        return True
    if not isinstance(column, list | np.ndarray):
        return False
    return not is_sequence_of(column, bytes)


def _are_polygons(column: Any) -> bool:
    """Whether all of some WKB is polygons, which needs no shapely."""

    def kind(wkb: bytes) -> int:
        code = int.from_bytes(wkb[1:5], "little" if wkb[:1] == b"\x01" else "big")
        return (code & 0x0FFFFFFF) % 1000

    return all(wkb is None or kind(wkb) in _POLYGONAL for wkb in column)


def of_shapely(geometries: npt.NDArray[np.object_], z: ZRule) -> Shapes:
    """Take geometries apart, also collections of collections. A missing geometry is a row without shapes."""
    import shapely

    has_z = bool(shapely.has_z(geometries).any() or shapely.has_m(geometries).any())
    z_left_out(has_z, z, stacklevel=4)
    rows = len(geometries)
    parts, numbers = shapely.get_parts(geometries, return_index=True)
    types = shapely.get_type_id(parts)
    while (types >= _FIRST_OF_SEVERAL).any():
        parts, inner = shapely.get_parts(parts, return_index=True)
        numbers, types = numbers[inner], shapely.get_type_id(parts)
    used = ~shapely.is_empty(parts)
    parts, numbers, types = parts[used], numbers[used], types[used]

    polygons = types == _POLYGON
    regions = _regions(parts[polygons], numbers[polygons], rows)
    is_line = (types == _LINE) | (types == _RING)
    lines = _vertices(parts[is_line], numbers[is_line], rows)
    return Shapes(regions, lines, _vertices(parts[types == _POINT], numbers[types == _POINT], rows))


def _row_offsets(numbers: npt.NDArray[np.int64], rows: int) -> npt.NDArray[np.int32]:
    return np.concatenate(([0], np.cumsum(np.bincount(numbers, minlength=rows)))).astype(np.int32)


def _rows_of_parts(
    points: npt.NDArray[np.float64], sizes: npt.NDArray[np.int64], numbers: npt.NDArray[np.int64], rows: int
) -> Regions:
    rings = np.concatenate(([0], np.cumsum(sizes))).astype(np.int32)
    each = np.arange(len(rings), dtype=np.int32)
    return Regions._of(_core.arrays(np.ascontiguousarray(points), rings, each, _row_offsets(numbers, rows)))


def _vertices(parts: npt.NDArray[np.object_], numbers: npt.NDArray[np.int64], rows: int) -> Regions:
    import shapely

    points, index = shapely.get_coordinates(parts, return_index=True)
    return _rows_of_parts(points, np.bincount(index, minlength=len(parts)), numbers, rows)


def _regions(parts: npt.NDArray[np.object_], numbers: npt.NDArray[np.int64], rows: int) -> Regions:
    import shapely

    if len(parts) == 0:
        return _vertices(parts, numbers, rows)
    _, points, (rings, polygons) = shapely.to_ragged_array(parts, include_z=False, include_m=False)
    offsets = _row_offsets(numbers, rows)
    arrays = (np.ascontiguousarray(points), rings.astype(np.int32), polygons.astype(np.int32), offsets)
    return Regions._of(_core.arrays(*arrays))
