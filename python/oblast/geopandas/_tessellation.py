"""The tessellations of momepy, answered by oblast."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pandas as pd
import shapely
from geopandas import GeoDataFrame, GeoSeries

from oblast.geopandas._zones import RELATIVE, frame_of_crs, require_plane, zones_of_rows

__all__ = ["enclosed_tessellation", "morphological_tessellation"]

_UNUSED = ("grid_size", "radius")  # of libpysal's voronoi_frames


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
    require_plane(geometry)
    numbers, labels = pd.factorize(geometry.index, sort=True)
    lengths = tolerance, RELATIVE, math.inf
    made, error, rounding = zones_of_rows(geometry, numbers, len(labels), frame_of_crs(within, geometry), lengths)
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
