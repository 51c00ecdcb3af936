"""Buffer zones of regions, lines and points."""

from __future__ import annotations

from typing import Literal

import numpy as np
import numpy.typing as npt

from oblast import _core
from oblast._convert import Operand
from oblast._regions import Regions
from oblast._settings import FillRule, Progress, settings_of
from oblast._shapes import Shapes, shapes_of

__all__ = ["BufferMode", "Cap", "Join", "Side", "buffer", "shape_of", "zones_of"]

Join = Literal["round", "mitre", "bevel"]
Cap = Literal["round", "flat", "square"]
Side = Literal["both", "left", "right"]
BufferMode = Literal["nearest", "inside", "outside"]

_JOINS = ("round", "mitre", "bevel")
_CAPS = ("round", "flat", "square")
_SIDES = ("both", "left", "right")
_MODES = ("nearest", "inside", "outside")


def _number(name: str, word: str, words: tuple[str, ...]) -> int:
    if word not in words:
        raise ValueError(f"{name}={word!r}: expected one of {', '.join(words)}")
    return words.index(word)


def buffer(
    shapes: Operand,
    distance: float | npt.ArrayLike,
    *,
    join: Join = "round",
    cap: Cap = "round",
    side: Side = "both",
    mode: BufferMode = "nearest",
    tolerance: float = 0.01,
    absolute_tolerance: float = 0.0,
    mitre_limit: float = 5.0,
    by_row: bool = False,
    fill: FillRule = "polygons",
    threads: int | None = None,
    progress: Progress = False,
    most_bytes: int = 0,
) -> Regions:
    """All places within a distance of regions, lines and points.

    Parameters
    ----------
    shapes : Regions, shapely geometries, GeoSeries, WKB, Arrow or ragged arrays
        Of shapely, a GeoSeries and WKB: polygons, lines, points, and collections of these.
    distance : float, or array_like of float, shape (rows,)
        In units of the coordinates; one for all rows, or one for each. Of a negative one: the places of the polygons
        that are further than that from their outlines; lines and points then count as nothing.
    join : {"round", "mitre", "bevel"}
        The outline around corners.
    cap : {"round", "flat", "square"}
        The outline around the ends of lines. Of a point "square" makes a square, and "flat" makes nothing.
    side : {"both", "left", "right"}
        The sides of lines, as seen along them. One-sided zones have no caps.
    mode : {"nearest", "inside", "outside"}
        Where the outline may be: on both sides of the true one, nowhere beyond the distance ("inside"), or nowhere
        within it ("outside": no place that is within the distance is missed).
    tolerance : float
        How far the outline may be from the true one, as a share of the distance, 1e-9 to 0.5.
    absolute_tolerance : float
        The same in units of the coordinates, in place of `tolerance` if it is above 0.
    mitre_limit : float
        How far a mitred corner may reach, as a multiple of the distance, 1 or more.
    by_row : bool
        A row for each row of `shapes`, each by itself. Without it: one row, the zone of all.
    fill : {"polygons", "even_odd", "nonzero", "positive", "negative"} or ("at_least", k)
        What is inside the regions; see `overlay`.
    threads, progress, most_bytes
        As for `overlay`; so are errors, Ctrl-C and the interpreter's lock.

    Returns
    -------
    Regions
        Canonical and valid. With round joins and caps the outline is within the tolerance, and some units in the last
        place of the largest coordinate. A positive zone holds its shapes, and a negative one lies in them.

    Raises
    ------
    OblastError
        A distance that is not finite, options out of their ranges, and what `overlay` raises.
    ValueError
        A word that is none of the choices, or an array of distances of another length than the rows.

    Notes
    -----
    Expected cost: O((n + k) log n) time for n vertices whose pieces meet at k places.

    Examples
    --------
    >>> import oblast
    >>> square = oblast.from_ragged([[0, 0], [10, 0], [10, 10], [0, 10]], [0, 4])
    >>> oblast.buffer(square, 1, join="mitre").area
    144.0
    >>> oblast.buffer(square, -1).bounds
    (1.0, 1.0, 9.0, 9.0)
    >>> import shapely
    >>> road = shapely.LineString([(0, 0), (100, 0)])
    >>> oblast.buffer(road, 2, cap="flat").area
    400.0
    """
    shape = shape_of(join, cap, side, mode, mitre_limit, tolerance, absolute_tolerance)
    converted = shapes_of(shapes)
    rules = () if fill == "polygons" else (fill,)
    with settings_of(threads, progress, None, most_bytes, rules) as settings:
        return zones_of(converted, distance, shape, by_row, settings)


def shape_of(
    join: Join,
    cap: Cap,
    side: Side,
    mode: BufferMode,
    mitre_limit: float,
    tolerance: float,
    absolute_tolerance: float = 0.0,
) -> _core.BufferShape:
    """The options of zones as C++ has them."""
    return _core.BufferShape(
        _number("join", join, _JOINS),
        _number("cap", cap, _CAPS),
        _number("side", side, _SIDES),
        _number("mode", mode, _MODES),
        mitre_limit,
        tolerance,
        absolute_tolerance,
    )


def zones_of(
    shapes: Shapes,
    distance: float | npt.ArrayLike,
    shape: _core.BufferShape,
    by_row: bool,
    settings: _core.Settings,
) -> Regions:
    """The zone of all rows, or one a row."""
    regions, lines, points = (part._core for part in shapes)
    rows = len(shapes.regions)
    distances = np.asarray(distance, dtype=np.float64)
    if distances.ndim == 0:
        if not by_row:
            return Regions._of(_core.buffer(regions, lines, points, float(distances), shape, settings))
        distances = np.full(rows, distances)
    if distances.shape != (rows,):
        raise ValueError(f"distance has the shape {distances.shape}: expected a number, or one for each of {rows} rows")
    distances = np.ascontiguousarray(distances)
    return Regions._of(_core.buffer_rows(regions, lines, points, distances, shape, not by_row, settings))
