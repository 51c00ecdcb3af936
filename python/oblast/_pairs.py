"""Many small calls: overlays of pairs of rows, and each row by itself."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from oblast import _core
from oblast._convert import Operand, regions_of
from oblast._overlay import How, operation_of
from oblast._regions import Regions
from oblast._settings import Progress, settings_of

__all__ = ["overlay_pairs", "repair"]


def overlay_pairs(
    a: Operand,
    b: Operand,
    i: npt.ArrayLike | None = None,
    j: npt.ArrayLike | None = None,
    how: How = "intersection",
    *,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Regions:
    """Overlay pairs of rows, each pair by itself, on all cores: for many small calls.

    Parameters
    ----------
    a, b : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
    i, j : array_like of int, shape (pairs,), optional
        Pair k is row ``i[k]`` of `a` with row ``j[k]`` of `b`. Without them rows are paired in order; an operand of
        one row is then paired with all rows of the other one.
    how : {"intersection", "union", "difference", "symmetric_difference"}
    threads, progress, most_bytes
        As for `overlay`; `most_bytes` is the limit of each pair.

    Returns
    -------
    Regions
        A row a pair, without polygons if there is nothing left.

    Raises
    ------
    IndexError
        If there is no such row.
    OblastError
        As `overlay`, with the row of the operand.

    Examples
    --------
    >>> import oblast
    >>> a = oblast.from_ragged([[0, 0], [2, 0], [2, 2], [0, 2], [8, 8], [9, 8], [9, 9]], [0, 4, 7])
    >>> b = oblast.from_ragged([[1, 1], [3, 1], [3, 3], [1, 3]], [0, 4])
    >>> [row.area for row in oblast.overlay_pairs(a, b, [0, 1], [0, 0], "difference")]
    [3.0, 0.5]
    """
    operation = operation_of(how)
    left, right = regions_of(a), regions_of(b)
    first, second = _pairs(left, right, i, j)
    with settings_of(threads, progress, None, most_bytes, counted=False) as settings:
        return Regions._of(_core.overlay_pairs(left._core, right._core, first, second, operation, settings))


def _pairs(
    a: Regions, b: Regions, i: npt.ArrayLike | None, j: npt.ArrayLike | None
) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
    if (i is None) != (j is None):
        raise ValueError("give both i and j, or neither")
    if i is not None and j is not None:
        return _indices(i, "i"), _indices(j, "j")
    count = max(len(a), len(b)) if len(a) and len(b) else 0
    for name, given in (("a", len(a)), ("b", len(b))):
        if given not in (1, count):
            raise ValueError(f"{name} has {given} rows: expected 1 or {count}; or give i and j")
    rows = np.arange(count, dtype=np.int64)
    return (rows if len(a) == count else rows * 0), (rows if len(b) == count else rows * 0)


def _indices(values: npt.ArrayLike, name: str) -> npt.NDArray[np.int64]:
    array = np.asarray(values)
    if array.ndim != 1 or (array.size and array.dtype.kind not in "iu"):
        raise ValueError(f"{name} must be an array of whole numbers with one dimension")
    return np.ascontiguousarray(array, dtype=np.int64)


def repair(
    a: Operand,
    *,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Regions:
    """Resolve each row by itself: what crosses itself or overlaps becomes valid polygons.

    A polygon is filled by even-odd of its own rings, and a row is the union of its polygons. So a bow tie becomes two
    triangles. Valid rows keep their points and get canonical order.

    Parameters
    ----------
    a : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
    threads, progress, most_bytes
        As for `overlay_pairs`.

    Returns
    -------
    Regions
        As many rows as `a` has.

    Examples
    --------
    >>> import oblast
    >>> bow_tie = oblast.from_ragged([[0, 0], [2, 2], [2, 0], [0, 2]], [0, 4])
    >>> oblast.repair(bow_tie)
    <Regions: 1 row, 2 polygons, 2 rings, 6 points>
    """
    regions = regions_of(a)
    nothing = Regions._of(_core.arrays(np.empty((0, 2)), *[np.zeros(n, np.int32) for n in (1, 1, 2)]))
    rows = np.arange(len(regions))
    return overlay_pairs(
        regions, nothing, rows, rows * 0, "union",
        threads=threads, progress=progress, most_bytes=most_bytes,
    )  # fmt: skip
