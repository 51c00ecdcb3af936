"""Zones of the rows of a GeoDataFrame, and momepy's tessellations, answered by oblast."""

from __future__ import annotations

import math
from typing import Any

import geopandas
import numpy as np
import numpy.typing as npt
import pandas as pd
import shapely
from geopandas import GeoDataFrame, GeoSeries

from oblast._regions import Regions
from oblast._settings import settings_of
from oblast._shapely import to_shapely
from oblast._shapes import of_shapely
from oblast._zones import frame_of, zones_of

__all__ = ["enclosed_tessellation", "morphological_tessellation", "zones"]

_RELATIVE = 1e-5
_UNUSED = ("grid_size", "radius")  # of libpysal's voronoi_frames


def zones(
    objects: GeoDataFrame | GeoSeries,
    within: Any = None,
    *,
    by: Any = None,
    tolerance: float = 0.0,
    relative_tolerance: float = _RELATIVE,
    distance: float = math.inf,
) -> Any:
    """Divide an area by the nearest object, row by row.

    Parameters
    ----------
    objects : GeoDataFrame or GeoSeries
        Points, lines, polygons, and collections of these. Each row is an object.
    within : GeoDataFrame, GeoSeries, geometry or (x0, y0, x1, y1), optional
        The area that is divided. Without it the box of all objects, with a margin.
    by : label, list of labels, or array_like, optional
        As in `GeoDataFrame.dissolve`: rows with the same values are one object.
    tolerance, relative_tolerance, distance : float
        As for `oblast.zones`, in units of the coordinates.

    Returns
    -------
    GeoDataFrame or GeoSeries
        With the index, the attributes and the CRS of `objects`; each geometry is a zone. With `by` a GeoDataFrame whose
        index has the groups, and whose columns have their first values. ``attrs["error"]`` and ``attrs["rounding"]``
        are the bounds of `oblast.zones`. An object without a zone has an empty polygon.

    Raises
    ------
    ValueError
        If the CRS is geographic: the nearest object cannot be found in degrees. If `within` has another CRS, or no
        polygons.

    Examples
    --------
    >>> from oblast import geopandas as og
    >>> import geopandas, shapely
    >>> wells = geopandas.GeoDataFrame({"name": ["a", "b"]}, geometry=geopandas.points_from_xy([1, 3], [1, 1]))
    >>> og.zones(wells, shapely.box(0, 0, 6, 2)).assign(area=lambda f: f.area)[["name", "area"]].values.tolist()
    [['a', 4.0], ['b', 8.0]]
    """
    _require_plane(objects)
    numbers = np.arange(len(objects))
    result = objects
    if by is not None:
        grouped = _attributes(objects).groupby(by, dropna=False)
        numbers, result = np.array(grouped.ngroup(), dtype=np.int64), grouped.first()
    lengths = tolerance, relative_tolerance, distance
    made, error, rounding = _zones(objects, numbers, len(result), _frame(within, objects), lengths)
    if isinstance(result, GeoSeries):
        result = GeoSeries(made, index=objects.index, crs=objects.crs, name=objects.name)
    else:
        name = objects.geometry.name if isinstance(objects, GeoDataFrame) else "geometry"
        columns = result.assign(**{name: geopandas.array.from_shapely(made, crs=objects.crs)})
        result = GeoDataFrame(columns, geometry=name)
    result.attrs.update(error=error, rounding=rounding)
    return result


def _attributes(objects: GeoDataFrame | GeoSeries) -> pd.DataFrame:
    if isinstance(objects, GeoDataFrame):
        return pd.DataFrame(objects.drop(columns=objects.geometry.name))
    return pd.DataFrame(index=objects.index)


def _require_plane(objects: GeoDataFrame | GeoSeries) -> None:
    if objects.crs is not None and objects.crs.is_geographic:
        raise ValueError(
            f"the objects are in degrees ({objects.crs.name}), in which the nearest one cannot be found; "
            "project them first, as by objects.to_crs(objects.estimate_utm_crs())"
        )


def _frame(within: Any, objects: GeoDataFrame | GeoSeries) -> Regions:
    crs = getattr(within, "crs", None)
    if crs is not None and objects.crs is not None and crs != objects.crs:
        raise ValueError(f"within is in {crs.name}, and the objects are in {objects.crs.name}; use within.to_crs(...)")
    return frame_of(within)


def _zones(
    objects: GeoDataFrame | GeoSeries,
    numbers: npt.NDArray[Any],
    count: int,
    frame: Regions,
    lengths: tuple[float, float, float],
) -> tuple[npt.NDArray[np.object_], float, float]:
    """Of each object the zone as a geometry; the bounds."""
    shapes = of_shapely(np.asarray(objects.geometry.values), "drop")
    with settings_of() as settings:
        found = zones_of(shapes, frame, np.arange(count), numbers.astype(np.uint32), lengths, settings)
    return to_shapely(found.regions), found.error, found.rounding


def morphological_tessellation(
    geometry: GeoSeries | GeoDataFrame,
    clip: Any = "bounding_box",
    shrink: float = 0.4,
    segment: float = 0.5,
    simplify: bool = True,
    *,
    tolerance: float = 0.0,
    **kwargs: Any,
) -> GeoDataFrame:
    """Tessellate the space around buildings, with the signature of `momepy.morphological_tessellation`.

    The cells are those of `zones`: they leave no gap, do not overlap, and hold their buildings. Buildings may touch,
    and none collapses.

    Parameters
    ----------
    geometry : GeoSeries or GeoDataFrame
        Buildings. Those with the same index are one building.
    clip : {"bounding_box", "convex_hull", "alpha_shape"}, geometry, GeoSeries, GeoDataFrame or None
        What the cells fill. The box and the hulls are those of the buildings as they are; momepy shrinks them first.
        None: a box with a margin. "alpha_shape" needs the package libpysal.
    shrink, segment, simplify
        Not used: buildings need not shrink, and nothing is sampled by a fixed step.
    tolerance : float
        As for `oblast.zones`; 0: a hundred-thousandth of the larger side of the box of all buildings.
    **kwargs
        ``grid_size``, which is not used.

    Returns
    -------
    GeoDataFrame
        With the column ``geometry``, and the index of the buildings, sorted. A building that others cover has no cell.

    Examples
    --------
    >>> from oblast import geopandas as og
    >>> import geopandas, shapely
    >>> buildings = geopandas.GeoSeries([shapely.box(0, 0, 4, 4), shapely.box(6, 0, 10, 4)])
    >>> og.morphological_tessellation(buildings).area.round(3).tolist()
    [20.0, 20.0]
    """
    _refuse_others("morphological_tessellation", geometry, kwargs)
    return _cells(geometry, _limit(clip, geometry), tolerance)


def enclosed_tessellation(
    geometry: GeoSeries | GeoDataFrame,
    enclosures: GeoSeries | GeoDataFrame,
    shrink: float = 0.4,
    segment: float = 0.5,
    threshold: float | None = 0.05,
    simplify: bool = True,
    n_jobs: int = -1,
    *,
    tolerance: float = 0.0,
    **kwargs: Any,
) -> GeoDataFrame:
    """Tessellate each enclosure by its buildings, with the signature of `momepy.enclosed_tessellation`.

    Parameters
    ----------
    geometry : GeoSeries or GeoDataFrame
        Buildings, with a unique index of numbers from 0 on.
    enclosures : GeoSeries or GeoDataFrame
        Polygons, such as the blocks between streets.
    shrink, segment, simplify, n_jobs
        Not used; see `morphological_tessellation`. All cores work on each enclosure.
    threshold : float or None
        A building counts in an enclosure if more than this share of its area is there. An enclosure that only one
        building meets is its cell, however little of it is there.
    tolerance : float
        As for `oblast.zones`; 0: a hundred-thousandth of the larger side of the box of the buildings of an enclosure.
    **kwargs
        ``grid_size``, which is not used.

    Returns
    -------
    GeoDataFrame
        With the columns ``geometry`` and ``enclosure_index`` (or the name of the index of `enclosures`), and the index
        of the buildings; enclosures without buildings have negative numbers. Cells of an enclosure fill it.

    Examples
    --------
    >>> from oblast import geopandas as og
    >>> import geopandas, shapely
    >>> buildings = geopandas.GeoSeries([shapely.box(0, 0, 4, 4), shapely.box(6, 0, 10, 4)])
    >>> blocks = geopandas.GeoSeries([shapely.box(-1, -1, 11, 5), shapely.box(11, -1, 13, 5)])
    >>> cells = og.enclosed_tessellation(buildings, blocks)
    >>> cells.assign(area=cells.area.round(3))[["enclosure_index", "area"]].reset_index().values.tolist()
    [[0.0, 0.0, 36.0], [1.0, 0.0, 36.0], [-1.0, 1.0, 12.0]]
    """
    _refuse_others("enclosed_tessellation", geometry, kwargs)
    blocks = enclosures.geometry
    column = enclosures.index.name or "enclosure_index"
    block_of, building_of = geometry.sindex.query(blocks, predicate="intersects")
    building_of = building_of[np.argsort(block_of, kind="stable")]
    bounds = np.concatenate(([0], np.cumsum(np.bincount(block_of, minlength=len(blocks)))))
    inside: list[GeoDataFrame] = []
    single: list[tuple[Any, Any, Any]] = []  # index of the building, block, its index
    empty: list[tuple[Any, Any]] = []  # in the order of momepy: those that no building meets, then the others
    unmet: list[tuple[Any, Any]] = []
    for place, (label, block) in enumerate(blocks.items()):
        buildings = geometry.geometry.iloc[building_of[bounds[place] : bounds[place + 1]]]
        if len(buildings) == 0:
            empty.append((block, label))
        elif len(buildings) == 1:
            single.append((buildings.index[0], block, label))
        else:
            part = _of_block(buildings, block, threshold, tolerance)
            inside.extend([part.assign(**{column: label})] if part is not None else [])
            unmet.extend([(block, label)] if part is None else [])
    empty += unmet
    frames = [*inside]
    for rows, index in (
        ([(block, label) for _, block, label in single], [building for building, _, _ in single]),
        (empty, list(range(-len(empty), 0))),
    ):
        if rows:
            shapes, labels = zip(*rows, strict=True)
            frames.append(GeoDataFrame({"geometry": list(shapes), column: list(labels)}, index=index, crs=blocks.crs))
    if not frames:
        return GeoDataFrame({"geometry": [], column: []}, crs=blocks.crs)
    return pd.concat(frames)


def _of_block(buildings: GeoSeries, block: Any, threshold: float | None, tolerance: float) -> GeoDataFrame | None:
    """The cells of one enclosure; None if no building has enough of its area there."""
    if threshold:
        inside = shapely.area(shapely.intersection(np.asarray(buildings.values), block))
        buildings = buildings[inside > buildings.area.to_numpy() * threshold]
    if len(buildings) == 0:
        return None
    if len(buildings) == 1:
        return GeoDataFrame(geometry=[block], index=buildings.index, crs=buildings.crs)
    return _cells(buildings, block, tolerance)


def _cells(geometry: GeoSeries | GeoDataFrame, within: Any, tolerance: float) -> GeoDataFrame:
    """The zones of buildings by their index; those without a zone are left out."""
    _require_plane(geometry)
    numbers, labels = pd.factorize(geometry.index, sort=True)
    lengths = tolerance, _RELATIVE, math.inf
    made, error, rounding = _zones(geometry, numbers, len(labels), _frame(within, geometry), lengths)
    cells = GeoDataFrame(geometry=made, index=labels, crs=geometry.crs)
    cells = cells[~cells.is_empty]
    cells.attrs.update(error=error, rounding=rounding)
    return cells


def _limit(clip: Any, geometry: GeoSeries | GeoDataFrame) -> Any:
    """What momepy's argument `clip` means."""
    if clip is None or clip is False or not isinstance(clip, str):
        return None if clip is False else clip
    if clip == "bounding_box":
        return shapely.box(*geometry.total_bounds)
    if clip == "convex_hull":
        return shapely.convex_hull(shapely.GeometryCollection(list(geometry.geometry)))
    if clip == "alpha_shape":
        from libpysal.cg.alpha_shapes import alpha_shape_auto

        return alpha_shape_auto(shapely.get_coordinates(np.asarray(geometry.geometry.values)))
    raise ValueError(f"clip={clip!r}: expected bounding_box, convex_hull, alpha_shape, polygons or None")


def _refuse_others(name: str, geometry: GeoSeries | GeoDataFrame, others: dict[str, Any]) -> None:
    if isinstance(geometry.index, pd.MultiIndex):
        raise ValueError(f"MultiIndex is not supported in `{name}`")
    for argument in others:
        if argument not in _UNUSED:
            raise TypeError(f"{name}() got an unexpected keyword argument {argument!r}")
