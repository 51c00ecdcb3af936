"""Overlay and union of regions."""

from __future__ import annotations

from typing import Literal, TypedDict, Unpack

import numpy as np
import numpy.typing as npt

from oblast import _core
from oblast._convert import Operand, regions_of
from oblast._regions import Regions
from oblast._settings import FillRule, Progress, Workspace, settings_of

__all__ = [
    "How",
    "difference",
    "intersection",
    "overlay",
    "symmetric_difference",
    "union",
    "union_all",
]

How = Literal["intersection", "union", "difference", "symmetric_difference"]


class OverlayOptions(TypedDict, total=False):
    """What `overlay` may be told by name."""

    fill_a: FillRule
    fill_b: FillRule
    engine: str
    touching: bool
    minimal: bool
    threads: int | None
    progress: Progress
    workspace: Workspace | None
    most_bytes: int


_OPERATIONS = {"intersection": 0, "union": 1, "difference": 2, "symmetric_difference": 3}


def operation_of(how: str) -> int:
    """The number of an operation in C++."""
    try:
        return _OPERATIONS[how]
    except KeyError:
        raise ValueError(f"how={how!r}: expected one of {', '.join(_OPERATIONS)}") from None


def overlay(
    a: Operand,
    b: Operand,
    how: How = "intersection",
    *,
    fill_a: FillRule = "polygons",
    fill_b: FillRule = "polygons",
    engine: str = "leonov_nikitin",
    touching: bool = False,
    minimal: bool = False,
    threads: int | None = None,
    progress: Progress = False,
    workspace: Workspace | None = None,
    most_bytes: int = 0,
) -> Regions:
    """Overlay two operands, each the union of all its polygons.

    Parameters
    ----------
    a, b : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
        Any contours: they may cross themselves and each other, overlap, touch and repeat. Rows do not matter; see
        `overlay_features` for an overlay row by row.
    how : {"intersection", "union", "difference", "symmetric_difference"}
    fill_a, fill_b : {"polygons", "even_odd", "nonzero", "positive", "negative"} or ("at_least", k)
        What is inside an operand. "polygons": each polygon is filled by even-odd of its own rings, and the operand is
        their union. "at_least": what at least k polygons cover. The others use the winding number of all rings.
    engine : {"leonov_nikitin", "vatti", "skvortsov"}
        All give the same bytes.
    touching : bool
        Contours of the result may touch themselves at points. Without it every ring is simple, as OGC wants it.
    minimal : bool
        Leave out vertices that are exactly on the line between their neighbours.
    threads : int, optional
        1 to 1024; None: all cores. The result does not depend on it.
    progress : bool or callable
        True draws a bar by tqdm, if that is installed. A callable is told the fraction that is done, 0 to 1, at most 50
        times a second. What it raises ends the call.
    workspace : Workspace, optional
        Memory that calls keep for later calls.
    most_bytes : int
        The most bytes that the call may use. 0: no limit.

    Returns
    -------
    Regions
        One row: canonical, closed and valid. Input vertices keep their bits.

    Raises
    ------
    OblastError
        Coordinates that are not finite or not in the domain, bad options, more than 2^31 - 1 vertices, too little
        memory.
    KeyboardInterrupt
        Ctrl-C stops the call within 0.2 s.

    Notes
    -----
    Expected cost: O((n + k) log n) time and O(n + k) memory for n edges that meet at k points. The interpreter's lock
    is released. In a process that was forked, calls use one thread.

    Examples
    --------
    >>> import oblast
    >>> a = oblast.from_ragged([[0, 0], [2, 0], [2, 2], [0, 2]], [0, 4])
    >>> b = oblast.from_ragged([[1, 1], [3, 1], [3, 3], [1, 3]], [0, 4])
    >>> oblast.overlay(a, b, "intersection").points.tolist()
    [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]]
    """
    operation = operation_of(how)
    left, right = regions_of(a), regions_of(b)
    usual = fill_a == "polygons" and fill_b == "polygons"
    fill = () if usual else (fill_a, fill_b)
    with settings_of(threads, progress, workspace, most_bytes, fill, engine, touching, minimal) as settings:
        return Regions._of(_core.overlay(left._core, right._core, operation, settings))


def intersection(a: Operand, b: Operand, **options: Unpack[OverlayOptions]) -> Regions:
    """Return what both operands cover: `overlay` with "intersection" and the same options."""
    return overlay(a, b, "intersection", **options)


def union(a: Operand, b: Operand, **options: Unpack[OverlayOptions]) -> Regions:
    """Return what one of the operands covers: `overlay` with "union" and the same options."""
    return overlay(a, b, "union", **options)


def difference(a: Operand, b: Operand, **options: Unpack[OverlayOptions]) -> Regions:
    """Return what only the first operand covers: `overlay` with "difference" and the same options."""
    return overlay(a, b, "difference", **options)


def symmetric_difference(a: Operand, b: Operand, **options: Unpack[OverlayOptions]) -> Regions:
    """Return what exactly one operand covers: `overlay` with "symmetric_difference" and the same options."""
    return overlay(a, b, "symmetric_difference", **options)


def union_all(
    a: Operand,
    by: npt.ArrayLike | None = None,
    *,
    fill: FillRule = "polygons",
    touching: bool = False,
    minimal: bool = False,
    threads: int | None = None,
    progress: Progress = False,
    workspace: Workspace | None = None,
    most_bytes: int = 0,
) -> Regions:
    """Unite all polygons in one pass.

    Parameters
    ----------
    a : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
    by : array_like, shape (rows,), optional
        The group of each row, of any type that numpy can sort. Then the result has a row for each group, in the order
        of ``numpy.unique(by)``, and rows that share a border share its vertices. See `dissolve`, which returns the
        groups, too.
    fill : {"polygons", "even_odd", "nonzero", "positive", "negative"} or ("at_least", k)
        What is inside; with `by` "polygons" or "at_least".
    touching, minimal, threads, progress, workspace, most_bytes
        As for `overlay`; so are errors and cost.

    Returns
    -------
    Regions
        One row, or one a group. Uniting a result again changes no byte.

    Examples
    --------
    >>> import oblast
    >>> squares = oblast.from_ragged(
    ...     [[0, 0], [1, 0], [1, 1], [0, 1], [1, 0], [2, 0], [2, 1], [1, 1], [5, 5], [6, 5], [6, 6]],
    ...     [0, 4, 8, 11],
    ... )
    >>> oblast.union_all(squares)
    <Regions: 1 row, 2 polygons, 2 rings, 9 points>
    >>> oblast.union_all(squares, by=["x", "x", "y"])
    <Regions: 2 rows, 2 polygons, 2 rings, 9 points>
    """
    regions = regions_of(a)
    rules = () if fill == "polygons" else (fill,)
    with settings_of(threads, progress, workspace, most_bytes, rules, touching=touching, minimal=minimal) as settings:
        if by is None:
            return Regions._of(_core.unite(regions._core, settings))
        return Regions._of(_core.dissolve(regions._core, groups_of(by, len(regions))[1], settings))


def groups_of(by: npt.ArrayLike, rows: int) -> tuple[npt.NDArray[np.generic], npt.NDArray[np.uint32]]:
    """The different groups in order, and the number of that of each row."""
    array = np.asarray(by)
    if array.shape != (rows,):
        raise ValueError(f"by has the shape {array.shape}: expected one group for each of {rows} rows")
    groups, numbers = np.unique(array, return_inverse=True)
    return groups, numbers.astype(np.uint32)
