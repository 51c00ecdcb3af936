"""Proximity zones: the places to which an object is the nearest one."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from oblast import _core
from oblast._convert import Operand, regions_of
from oblast._overlay import groups_of
from oblast._regions import Regions
from oblast._rows import rectangle_of
from oblast._settings import Progress, settings_of
from oblast._shapes import Shapes, no_shapes, points_of, shapes_of

__all__ = ["Zones", "zones"]


class Zones(NamedTuple):
    """A zone for each object."""

    regions: Regions
    """The zones, a row for each object. They do not overlap, and share their borders, bit for bit."""
    groups: npt.NDArray[Any]
    """By row: the group of its object, or the number of its row."""
    error: float
    """How much nearer another object may be, in units of the coordinates; 0 for points alone."""
    rounding: float
    """The same for rounding: some units in the last place of the largest coordinate."""


def zones(
    objects: Operand,
    within: Operand | None = None,
    *,
    by: npt.ArrayLike | None = None,
    tolerance: float = 0.0,
    relative_tolerance: float = 1e-5,
    distance: float = math.inf,
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Zones:
    """Divide an area by the nearest object: the zone of an object is the places to which no other one is nearer.

    Parameters
    ----------
    objects : Regions, shapely geometries, GeoSeries, WKB, Arrow or ragged arrays, or array of float, shape (n, 2)
        Each row is an object. Of shapely, a GeoSeries and WKB: points, lines, polygons, and collections of these. An
        array of shape (n, 2) is n points, which are not converted.
    within : (x0, y0, x1, y1), or regions as `objects`, optional
        The area that is divided: a rectangle, or the union of all polygons. Without it the box of all objects, with a
        margin of a tenth of its larger side, or of one and a half times `distance` if that is finite.
    by : array_like, shape (rows,), optional
        The group of each row, of any type that numpy can sort. Rows of one group are one object.
    tolerance : float
        How much nearer another object may be at a place of a zone, in units of the coordinates. 0:
        `relative_tolerance` decides. Of points alone zones are exact, up to rounding.
    relative_tolerance : float
        The same as a share of the larger side of the box of all objects, 1e-12 to 0.1.
    distance : float
        How far a zone may reach from its object. Zones that end there hold every place up to it, and none that is
        further by more than the tolerance.
    threads, progress, most_bytes
        As for `overlay`; so are errors, Ctrl-C and the interpreter's lock.

    Returns
    -------
    Zones
        ``regions``, ``groups``, and the bounds ``error`` and ``rounding``. Without a `distance` zones leave no gap in
        the area. Each object lies in its own zone; where polygons overlap, the first one has the place. So the zone of
        an object that others cover is empty.

    Raises
    ------
    OblastError
        Options out of their ranges, and what `overlay` raises. Its ``operand`` is 0 for polygons, 1 for lines, 2 for
        points, 3 for `within`.
    ValueError
        If `within` has no polygons.

    Notes
    -----
    Expected cost: O((n + k + s) log (n + s)) time for n vertices, k places where they meet, and s samples of lines and
    outlines.

    Examples
    --------
    >>> import numpy as np, oblast
    >>> wells = np.array([[1.0, 1.0], [3.0, 1.0]])
    >>> field = oblast.from_ragged([[0, 0], [6, 0], [6, 2], [0, 2]], [0, 4])
    >>> [row.area for row in oblast.zones(wells, field).regions]
    [4.0, 8.0]
    >>> import shapely
    >>> road, house = shapely.LineString([(0, -9), (0, 9)]), shapely.box(4, 0, 6, 2)
    >>> found = oblast.zones([road, house], field, tolerance=0.001)
    >>> [round(row.area, 2) for row in found.regions], found.error <= 0.001
    ([4.0, 8.0], True)
    """
    shapes = points_of(objects) if _is_points(objects) else shapes_of(objects)
    frame = frame_of(within)
    rows = len(shapes.regions)
    each = np.arange(rows)
    groups, numbers = (each, each.astype(np.uint32)) if by is None else groups_of(by, rows)
    with settings_of(threads, progress, None, most_bytes) as settings:
        return zones_of(shapes, frame, groups, numbers, (tolerance, relative_tolerance, distance), settings)


def frame_of(within: Operand | None) -> Regions:
    """The polygons that zones fill; none if there is no frame."""
    if within is None:
        return no_shapes(0)
    frame = rectangle_of(within) or regions_of(within)
    if not frame:
        raise ValueError("within has no polygons, so there is no area to divide")
    return frame


def zones_of(
    shapes: Shapes,
    frame: Regions,
    groups: npt.NDArray[Any],
    numbers: npt.NDArray[np.uint32],
    lengths: tuple[float, float, float],
    settings: _core.Settings,
) -> Zones:
    """The zones of numbered objects; lengths are tolerance, relative tolerance and distance."""
    regions, lines, points = (part._core for part in shapes)
    tolerance, relative_tolerance, distance = map(float, lengths)
    objects = np.ascontiguousarray(numbers)
    found, error, rounding = _core.zones(
        regions, lines, points, frame._core, objects, len(groups), tolerance, relative_tolerance, distance, settings
    )
    return Zones(Regions._of(found), groups, error, rounding)


def _is_points(given: Any) -> bool:
    return isinstance(given, np.ndarray) and given.dtype.kind in "fiu" and given.ndim == 2 and given.shape[1] == 2
