"""From whatever a caller has to Regions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from oblast import _core
from oblast._regions import Regions
from oblast._settings import settings_of
from oblast._z import ZRule, z_left_out

__all__ = [
    "Operand",
    "from_arrow",
    "from_ragged",
    "from_shapely",
    "from_wkb",
    "geometry_array",
    "is_sequence_of",
    "regions_of",
]


class _ArrowArray(Protocol):
    def __arrow_c_array__(self, requested_schema: object = None) -> Any: ...


class _ArrowStream(Protocol):
    def __arrow_c_stream__(self, requested_schema: object = None) -> Any: ...


Operand = Any
"""What functions take as regions: Regions; a tuple of ragged arrays (`from_ragged`); what speaks the Arrow PyCapsule
protocol (`from_arrow`); bytes or a sequence of them (`from_wkb`); a shapely geometry or a sequence of them, a GeoSeries
or a GeoDataFrame (`from_shapely`)."""


def _offsets(values: npt.ArrayLike, name: str) -> npt.NDArray[np.int32]:
    array = np.asarray(values)
    if array.ndim != 1 or (array.size and array.dtype.kind not in "iu"):
        raise ValueError(f"{name} must be an array of whole numbers with one dimension")
    if array.dtype == np.uint32:
        array = array.view(np.int32)
    elif array.dtype != np.int32:
        if array.size and not 0 <= array.min() <= array.max() < 2**31:
            raise ValueError(f"{name} must be numbers from 0 to 2^31 - 1")
        array = array.astype(np.int32)
    return np.ascontiguousarray(array)


def from_ragged(
    points: npt.ArrayLike,
    ring_offsets: npt.ArrayLike,
    polygon_offsets: npt.ArrayLike | None = None,
    row_offsets: npt.ArrayLike | None = None,
) -> Regions:
    """View arrays as Regions, without copying them.

    Parameters
    ----------
    points : array_like of float64, shape (n, 2)
        Not copied if it is a C-contiguous array of float64. Do not change it afterwards.
    ring_offsets : array_like of int32, shape (rings + 1,)
        Where each ring begins; the first is 0, the last is n. Not copied if it is an array of int32 or uint32; so are
        the others. A ring may repeat its first point at its end.
    polygon_offsets : array_like of int32, shape (polygons + 1,), optional
        Where each polygon begins in the rings. Without it each ring is a polygon.
    row_offsets : array_like of int32, shape (rows + 1,), optional
        Where each row begins in the polygons. Without it each polygon is a row.

    Returns
    -------
    Regions

    Raises
    ------
    ValueError
        If the arrays do not fit together. Coordinates are checked by the calls that use them. Cost: linear in the
        number of offsets.

    Examples
    --------
    A square with a square hole:

    >>> import oblast
    >>> points = [[0, 0], [3, 0], [3, 3], [0, 3], [1, 1], [1, 2], [2, 2], [2, 1]]
    >>> oblast.from_ragged(points, [0, 4, 8], [0, 2])
    <Regions: 1 row, 1 polygon, 2 rings, 8 points>
    """
    array = np.ascontiguousarray(np.asarray(points, dtype=np.float64))
    if array.size == 0:
        array = array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"points must have the shape (n, 2), not {array.shape}")
    rings = _offsets(ring_offsets, "ring_offsets")
    polygons = _each(rings) if polygon_offsets is None else _offsets(polygon_offsets, "polygon_offsets")
    rows = _each(polygons) if row_offsets is None else _offsets(row_offsets, "row_offsets")
    return Regions._of(_core.arrays(array, rings, polygons, rows))


def _each(offsets: npt.NDArray[np.int32]) -> npt.NDArray[np.int32]:
    return np.arange(max(len(offsets), 1), dtype=np.int32)


def from_wkb(geometries: bytes | Iterable[bytes | None], *, z: ZRule = "warn", threads: int | None = None) -> Regions:
    """Read geometries in Well-Known Binary, each as a row, on all cores.

    Parameters
    ----------
    geometries : bytes, or iterable of bytes or None
        Polygons, multipolygons, and collections of these; ISO WKB or EWKB. None is a row without polygons.
    z : {"warn", "drop", "error"}
        What to do about Z and M, which are left out.
    threads : int, optional
        The number of threads; None: all cores.

    Returns
    -------
    Regions

    Raises
    ------
    OblastError
        For anything else than such geometries, with the row and the byte. Cost: linear.
    """
    given: list[bytes | None] = [geometries] if isinstance(geometries, bytes) else list(geometries)
    with settings_of(threads, counted=False) as settings:
        arrays, has_z = _core.from_wkb(given, settings)
    z_left_out(has_z, z)
    return Regions._of(arrays)


def from_shapely(geometries: Any, *, z: ZRule = "warn") -> Regions:
    """Convert shapely geometries, each to a row.

    Parameters
    ----------
    geometries : geometry, sequence of geometries, GeoSeries or GeoDataFrame
        Polygons and multipolygons. None and empty geometries are rows without polygons.
    z : {"warn", "drop", "error"}
        What to do about Z and M, which are left out.

    Returns
    -------
    Regions

    Raises
    ------
    TypeError
        For other types of geometry.
    """
    from oblast._shapely import from_shapely as convert

    return convert(geometry_array(geometries), z)


def geometry_array(given: Any) -> Any:
    """The geometries of a GeoDataFrame, a GeoSeries or a GeometryArray; anything else as it is."""
    column = getattr(given, "geometry", None) if hasattr(given, "columns") else given
    return np.asarray(column) if hasattr(column, "crs") else column


def from_arrow(
    data: _ArrowArray | _ArrowStream, *, column: str = "", z: ZRule = "warn", threads: int | None = None
) -> Regions:
    """Read a column of polygons from Arrow memory, without pyarrow.

    Parameters
    ----------
    data : object with ``__arrow_c_array__`` or ``__arrow_c_stream__``
        An array, chunked array or table of pyarrow, polars, duckdb, pyogrio, lonboard and others. GeoArrow polygons
        and multipolygons, interleaved or separate, and WKB. Interleaved coordinates in one chunk are viewed, not
        copied.
    column : str, optional
        Of a table: the name of the column; needed if there are several geometry columns.
    z : {"warn", "drop", "error"}
        What to do about Z and M, which are left out.
    threads : int, optional
        For WKB: the number of threads; None: all cores.

    Returns
    -------
    Regions
        A row for each geometry; for a null one without polygons.

    Raises
    ------
    TypeError
        If the data has no such column.
    """
    with settings_of(threads, counted=False) as settings:
        if hasattr(data, "__arrow_c_array__"):
            schema, array = data.__arrow_c_array__()
            arrays, has_z = _core.from_arrow_array(schema, array, column, settings)
        elif hasattr(data, "__arrow_c_stream__"):
            arrays, has_z = _core.from_arrow_stream(data.__arrow_c_stream__(), column, settings)
        else:
            raise TypeError(f"{type(data).__name__} does not speak the Arrow PyCapsule protocol")
    z_left_out(has_z, z)
    return Regions._of(arrays)


def is_sequence_of(given: Any, kind: type) -> bool:
    """Whether the first item that is not None is of this kind."""
    first = next((item for item in given if item is not None), None)
    return isinstance(first, kind)


def regions_of(given: Operand) -> Regions:
    """Convert an operand; see `Operand`."""
    if isinstance(given, Regions):
        return given
    if isinstance(given, tuple) and 2 <= len(given) <= 4:
        return from_ragged(*given)
    if isinstance(given, bytes):
        return from_wkb(given)
    if hasattr(given, "crs") or hasattr(given, "geom_type"):
        return from_shapely(given)
    if hasattr(given, "__arrow_c_array__") or hasattr(given, "__arrow_c_stream__"):
        return from_arrow(given)
    if isinstance(given, list | np.ndarray):
        return from_wkb(given) if is_sequence_of(given, bytes) else from_shapely(given)
    raise TypeError(
        f"{type(given).__name__} is no operand: expected Regions, ragged arrays, Arrow, WKB, shapely geometries "
        "or a GeoSeries"
    )
