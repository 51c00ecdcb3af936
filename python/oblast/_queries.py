"""Hull, triangulation, proof of validity, points in regions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from oblast import _core
from oblast._convert import Operand, regions_of
from oblast._regions import Points, Regions
from oblast._settings import Progress, settings_of

__all__ = ["Locator", "Report", "Triangulation", "check", "hull", "triangulate"]


def hull(a: Operand, *, threads: int | None = None, progress: Progress = False, most_bytes: int = 0) -> Regions:
    """Return the convex hull of all regions, as one row.

    Its corners are points of the input, bit for bit; no three neighbours are on one line. It is empty if all points are
    on one line. Cost: O(n) for simple rings.

    Examples
    --------
    >>> import oblast
    >>> oblast.hull(([[0, 0], [2, 0], [1, 1], [2, 2], [0, 2]], [0, 5])).area
    4.0
    """
    regions = regions_of(a)
    with settings_of(threads, progress, None, most_bytes, counted=False) as settings:
        return Regions._of(_core.hull(regions._core, settings))


class Triangulation(NamedTuple):
    """Triangles of regions."""

    regions: Regions
    """What was triangulated."""
    points: Points
    """The vertices, shape (n, 2): each different point once."""
    triangles: npt.NDArray[np.uint32]
    """Shape (t, 3): indices into points, counter-clockwise."""
    neighbours: npt.NDArray[np.uint32]
    """Shape (t, 3): the triangle beyond the side from vertex i to the next one; 2^32 - 1: none."""
    is_side: npt.NDArray[np.bool_]
    """Shape (t, 3): whether that side is a side of a polygon."""
    polygon: npt.NDArray[np.uint32]
    """Shape (t,): the polygon of `regions` that contains the triangle; 2^32 - 1: none."""


def triangulate(
    a: Operand,
    extent: Literal["interior", "convex_hull"] = "interior",
    *,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Triangulation:
    """Return the constrained Delaunay triangulation of the union of all polygons.

    Parameters
    ----------
    a : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
    extent : {"interior", "convex_hull"}
        The triangles inside the polygons, or all up to the convex hull of the vertices.
    threads, progress, most_bytes
        As for `overlay`; so are errors. Cost: the union, then O(n log n).

    Returns
    -------
    Triangulation

    Examples
    --------
    >>> import oblast
    >>> square = oblast.from_ragged([[0, 0], [1, 0], [1, 1], [0, 1]], [0, 4])
    >>> oblast.triangulate(square).triangles.shape
    (2, 3)
    """
    if extent not in ("interior", "convex_hull"):
        raise ValueError(f"extent={extent!r}: expected 'interior' or 'convex_hull'")
    regions = regions_of(a)
    with settings_of(threads, progress, None, most_bytes, counted=False) as settings:
        t = _core.triangulate(regions._core, extent == "convex_hull", False, settings)
    return Triangulation(Regions._of(t[0]), *t[1:])


@dataclass(frozen=True)
class Report:
    """What `check` found: true if it found no fault."""

    kind: str | None = None
    """What is wrong, e.g. "edges_cross", "repeated_vertex", "wrong_side"; None: nothing."""
    message: str = "valid"
    """One sentence, with coordinates."""
    row: int | None = None
    polygon: int | None = None
    ring: int | None = None
    vertex: int | None = None
    """The place; where an edge is at fault, the vertex at which it begins. Indices count over all rows, `vertex` in
    its ring."""
    other: tuple[int | None, int | None, int | None, int | None] = (None, None, None, None)
    """Row, polygon, ring and vertex of the second edge or vertex, if two are concerned."""
    point: tuple[float, float] | None = None
    """Where it is."""

    def __bool__(self) -> bool:
        return self.kind is None


def check(
    a: Operand,
    *,
    canonical: bool = False,
    touching: bool = False,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Report:
    """Prove by exact arithmetic that all polygons together are valid and do not overlap, or find the first fault.

    Edges meet only at common ends; outer rings are counter-clockwise and come first, holes are clockwise; the
    interior of a polygon is connected. So the result of every overlay passes. Points that close rings are ignored.

    Parameters
    ----------
    a : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
    canonical : bool
        Also that rings start at their smallest vertices, and that holes and polygons are in order, as in results.
    touching : bool
        Rings may touch themselves.
    threads, progress, most_bytes
        As for `overlay`. Cost: O((n + k) log n) for n edges and k pairs of edges that meet.

    Returns
    -------
    Report
        True if there is no fault.

    Examples
    --------
    >>> import oblast
    >>> report = oblast.check(([[0, 0], [2, 2], [2, 0], [0, 2]], [0, 4]))
    >>> bool(report), report.kind, report.row, report.ring, report.point
    (False, 'edges_cross', 0, 0, (1.0, 1.0))
    """
    rows = regions_of(a)._core.opened()
    with settings_of(threads, progress, None, most_bytes, counted=False) as settings:
        fault = _core.check(rows, touching, canonical, settings)
    if fault is None:
        return Report()
    kind, message, place, other, point = fault
    row, polygon, ring, vertex = place
    return Report(kind, message, row, polygon, ring, vertex, other, point)


class Locator:
    """Regions that were prepared once, and answer any number of questions about points.

    Filled by even-odd of all rings together, which is right for results of overlays. Answers are exact.

    Parameters
    ----------
    a : Regions, ragged arrays, Arrow, WKB, shapely geometries or GeoSeries
        Cost: O(n log n) time, about 100 to 200 bytes an edge.

    Examples
    --------
    >>> import oblast
    >>> locator = oblast.Locator(([[0, 0], [2, 0], [2, 2], [0, 2]], [0, 4]))
    >>> locator.locate([[1, 1], [2, 1], [3, 1]]).tolist()
    [2, 1, 0]
    >>> locator.contains([[1, 1], [2, 1], [3, 1]]).tolist()
    [True, False, False]
    """

    OUTSIDE, BOUNDARY, INSIDE = 0, 1, 2

    __slots__ = ("_core",)

    def __init__(self, a: Operand, *, threads: int | None = None, progress: Progress = False) -> None:
        with settings_of(threads, progress, counted=False) as settings:
            self._core = _core.locator(regions_of(a)._core, settings)

    def locate(self, points: npt.ArrayLike, *, threads: int | None = None) -> npt.NDArray[np.int8]:
        """Return 0 (outside), 1 (on the boundary) or 2 (inside) for each point.

        Parameters
        ----------
        points : array_like of float64, shape (n, 2)
        threads : int, optional

        Raises
        ------
        OblastError
            With the index of the point as ``vertex``, if a coordinate is not finite.
        """
        array = np.ascontiguousarray(np.atleast_2d(np.asarray(points, dtype=np.float64)))
        with settings_of(threads, counted=False) as settings:
            return self._core.locate(array, settings)

    def contains(self, points: npt.ArrayLike, *, threads: int | None = None) -> npt.NDArray[np.bool_]:
        """Return for each point whether it is inside, not on the boundary."""
        return np.asarray(self.locate(points, threads=threads) == self.INSIDE)
