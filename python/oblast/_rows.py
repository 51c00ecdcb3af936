"""Layers: overlay row by row, dissolve, depth, partition, clip."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from oblast import _core
from oblast._convert import Operand, from_ragged, regions_of
from oblast._overlay import groups_of, union_all
from oblast._pairs import overlay_pairs
from oblast._regions import Regions
from oblast._settings import Progress, settings_of

__all__ = [
    "Depth",
    "Dissolved",
    "OverlaidRows",
    "Partition",
    "clip",
    "depth",
    "dissolve",
    "overlay_features",
    "partition",
]

RowsHow = Literal["intersection", "identity", "union", "difference", "symmetric_difference"]

_OPERATIONS = ("intersection", "identity", "union", "difference", "symmetric_difference")


class OverlaidRows(NamedTuple):
    """Rows of an overlay of two layers, and where they come from."""

    regions: Regions
    """The rows, in the order of their sources."""
    a: npt.NDArray[np.int64]
    """By row: the row of the first layer, or -1."""
    b: npt.NDArray[np.int64]
    """By row: the row of the second layer, or -1."""


class Dissolved(NamedTuple):
    """A row for each group."""

    regions: Regions
    groups: npt.NDArray[Any]
    """By row: its group."""


class Depth(NamedTuple):
    """Rows that do not overlap, and how many rows cover each."""

    regions: Regions
    depth: npt.NDArray[np.int64]


class Partition(NamedTuple):
    """Rows that do not overlap, and all that cover each: entries source_offsets[r] to source_offsets[r + 1] - 1."""

    regions: Regions
    source_offsets: npt.NDArray[np.uint32]
    layer: npt.NDArray[np.uint32]
    row: npt.NDArray[np.uint32]


def overlay_features(
    a: Operand,
    b: Operand,
    how: RowsHow = "intersection",
    *,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> OverlaidRows:
    """Overlay two layers row by row.

    Parameters
    ----------
    a, b : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
        The region of a row is the union of its polygons. Rows of one layer may overlap, and stay rows that overlap.
    how : {"intersection", "identity", "union", "difference", "symmetric_difference"}
        "intersection" gives pairs of rows; "identity" also what of `a` is outside `b`; "union" also what of `b` is
        outside `a`.
    threads, progress, most_bytes
        As for `overlay`; so are errors and cost.

    Returns
    -------
    OverlaidRows
        ``regions``, and the rows of `a` and `b` that each comes from (-1: none). Rows that share a border share its
        vertices, bit for bit.

    Examples
    --------
    >>> import oblast
    >>> a = oblast.from_ragged([[0, 0], [2, 0], [2, 2], [0, 2]], [0, 4])
    >>> b = oblast.from_ragged([[1, 1], [3, 1], [3, 3], [1, 3]], [0, 4])
    >>> rows = oblast.overlay_features(a, b, "union")
    >>> [(int(i), int(j), row.area) for row, i, j in zip(*rows)]
    [(0, 0, 1.0), (0, -1, 3.0), (-1, 0, 3.0)]
    """
    if how not in _OPERATIONS:
        raise ValueError(f"how={how!r}: expected one of {', '.join(_OPERATIONS)}")
    left, right = regions_of(a), regions_of(b)
    with settings_of(threads, progress, None, most_bytes) as settings:
        rows, i, j = _core.overlay_features(left._core, right._core, _OPERATIONS.index(how), settings)
    return OverlaidRows(Regions._of(rows), i, j)


def dissolve(
    a: Operand,
    by: npt.ArrayLike,
    *,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Dissolved:
    """Unite rows by group, all groups in one pass.

    Parameters
    ----------
    a : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
    by : array_like, shape (rows,)
        The group of each row, of any type that numpy can sort.
    threads, progress, most_bytes
        As for `overlay`; so are errors and cost.

    Returns
    -------
    Dissolved
        ``regions``, a row for each group, and ``groups``, in order.

    Examples
    --------
    >>> import oblast
    >>> squares = oblast.from_ragged([[0, 0], [1, 0], [1, 1], [0, 1], [1, 0], [2, 0], [2, 1], [1, 1]], [0, 4, 8])
    >>> oblast.dissolve(squares, [7, 7]).regions.area
    2.0
    """
    regions = regions_of(a)
    groups, numbers = groups_of(by, len(regions))
    with settings_of(threads, progress, None, most_bytes) as settings:
        return Dissolved(Regions._of(_core.dissolve(regions._core, numbers, settings)), groups)


def depth(
    a: Operand,
    by: npt.ArrayLike | None = None,
    *,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Depth:
    """Count how many rows cover each place.

    Parameters
    ----------
    a : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
    by : array_like, shape (rows,), optional
        A group for each row; then different groups are counted. If rows are fires and groups are days: on how many
        days a place burnt.
    threads, progress, most_bytes
        As for `overlay`; so are errors and cost.

    Returns
    -------
    Depth
        ``regions``, and the ``depth`` of each row, from 1 on. Rows do not overlap.

    Examples
    --------
    >>> import oblast
    >>> squares = oblast.from_ragged([[0, 0], [2, 0], [2, 2], [0, 2], [1, 1], [3, 1], [3, 3], [1, 3]], [0, 4, 8])
    >>> [(int(d), row.area) for row, d in zip(*oblast.depth(squares))]
    [(1, 6.0), (2, 1.0)]
    """
    regions = regions_of(a)
    groups = np.arange(len(regions), dtype=np.uint32) if by is None else groups_of(by, len(regions))[1]
    with settings_of(threads, progress, None, most_bytes) as settings:
        rows, depths = _core.depth(regions._core, groups, settings)
    return Depth(Regions._of(rows), depths)


def partition(
    *layers: Operand,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Partition:
    """Cut the plane by all layers at once: a row for every set of rows that cover a place.

    Parameters
    ----------
    *layers : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
    threads, progress, most_bytes
        As for `overlay`; so are errors and cost.

    Returns
    -------
    Partition
        ``regions``; and for row r the entries ``source_offsets[r]`` to ``source_offsets[r + 1] - 1`` of ``layer`` and
        ``row``, which say what covers it.

    Examples
    --------
    >>> import oblast
    >>> squares = oblast.from_ragged([[0, 0], [2, 0], [2, 2], [0, 2], [1, 1], [3, 1], [3, 3], [1, 3]], [0, 4, 8])
    >>> parts = oblast.partition(squares)
    >>> parts.source_offsets.tolist(), parts.row.tolist()
    ([0, 1, 3, 4], [0, 0, 1, 1])
    """
    converted = [regions_of(layer)._core for layer in layers]
    with settings_of(threads, progress, None, most_bytes) as settings:
        rows, offsets, layer, row = _core.partition(converted, settings)
    return Partition(Regions._of(rows), offsets, layer, row)


def rectangle_of(window: Any) -> Regions | None:
    """The rectangle of four numbers, or None if it is something else."""
    if not isinstance(window, Sequence | np.ndarray) or isinstance(window, bytes) or len(window) != 4:
        return None
    if not all(isinstance(number, int | float | np.number) for number in window):
        return None
    x0, y0, x1, y1 = map(float, window)
    return from_ragged([[x0, y0], [x1, y0], [x1, y1], [x0, y1]], [0, 4])


def clip(
    a: Operand,
    window: Operand,
    *,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Regions:
    """Clip each row by a window.

    Parameters
    ----------
    a : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
    window : (x0, y0, x1, y1), or regions as `a`
        A rectangle, or the union of all polygons of the regions.
    threads, progress, most_bytes
        As for `overlay`; so are errors and cost.

    Returns
    -------
    Regions
        As many rows as `a` has; those outside the window have no polygons.

    Examples
    --------
    >>> import oblast
    >>> a = oblast.from_ragged([[0, 0], [2, 0], [2, 2], [0, 2]], [0, 4])
    >>> oblast.clip(a, (1, -1, 5, 5)).bounds
    (1.0, 0.0, 2.0, 2.0)
    """
    regions, rectangle = regions_of(a), rectangle_of(window)
    if rectangle is not None:
        rows = np.arange(len(regions))
        return overlay_pairs(
            regions, rectangle, rows, rows * 0, threads=threads, progress=progress, most_bytes=most_bytes
        )
    whole = union_all(window, threads=threads, most_bytes=most_bytes)
    clipped = overlay_features(regions, whole, threads=threads, progress=progress, most_bytes=most_bytes)
    return spread(clipped.regions, clipped.a, len(regions))


def spread(regions: Regions, places: npt.NDArray[np.int64], count: int) -> Regions:
    """Put row r at the place places[r] of `count` rows; the others have no polygons. Nothing is copied.

    Places ascend.
    """
    polygons = np.zeros(count + 1, dtype=np.int32)
    polygons[places + 1] = np.diff(regions.row_offsets)
    rows = np.cumsum(polygons, dtype=np.int32)
    return Regions._of(_core.arrays(regions.points, regions.ring_offsets, regions.polygon_offsets, rows))
