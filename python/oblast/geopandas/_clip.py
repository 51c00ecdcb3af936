"""`geopandas.clip`, answered by oblast."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import shapely
from geopandas import GeoDataFrame, GeoSeries

from oblast._fallbacks import passed_on
from oblast._overlay import union_all
from oblast._rows import clip as clip_rows
from oblast.geopandas._originals import originals
from oblast.geopandas._ours import array_of, not_ours, pass_on, regions_of_column
from oblast.geopandas._overlay import _boxes_meet, _warn_of_crs
from oblast.geopandas._touching import touches_outside


def clip(gdf: Any, mask: Any, keep_geom_type: bool = False, sort: bool = False) -> GeoDataFrame | GeoSeries:
    """Clip each row by a mask, as `geopandas.clip` does.

    Passed on to geopandas, and counted by `oblast.fallbacks`: geometries other than polygons, Z and M. Rows that meet
    the mask in lines or points, too, are passed on one by one, unless `keep_geom_type` is true.

    Parameters
    ----------
    gdf : GeoDataFrame or GeoSeries
    mask : GeoDataFrame, GeoSeries, Polygon, MultiPolygon, or (minx, miny, maxx, maxy)
    keep_geom_type, sort : bool
        As in geopandas.

    Returns
    -------
    GeoDataFrame or GeoSeries
    """
    window = _window(mask)
    reason = _reason(gdf, window)
    if reason is not None or window is None:
        return pass_on("clip", reason or "wrong arguments", originals().clip, gdf, mask, keep_geom_type, sort)
    if isinstance(mask, GeoDataFrame | GeoSeries):
        _warn_of_crs(gdf, mask)
    rectangle = not isinstance(mask, GeoDataFrame | GeoSeries | shapely.Geometry)
    if not _boxes_meet(gdf.total_bounds, shapely.total_bounds(window)):
        return gdf.iloc[:0]
    geometries = array_of(gdf.geometry)
    clipped = clip_rows(regions_of_column(geometries), mask if rectangle else window).to_shapely()
    area = ~shapely.is_empty(clipped)
    if not (keep_geom_type or rectangle):
        area |= _remains(geometries, clipped, area, window)
    rows = np.flatnonzero(area)
    if not sort:
        rows = _in_order_of_geopandas(gdf, window, rows)
    return _with_geometry(gdf, rows, clipped[rows])


def _window(mask: Any) -> npt.NDArray[np.object_] | None:
    """The geometries of the mask, or None if it is no mask."""
    if isinstance(mask, GeoDataFrame | GeoSeries):
        return array_of(mask.geometry)
    if isinstance(mask, shapely.Geometry):
        return np.array([mask], dtype=object)
    try:
        return np.array([shapely.box(*map(float, mask))], dtype=object) if len(mask) == 4 else None
    except (TypeError, ValueError):
        return None


def _reason(gdf: Any, window: npt.NDArray[np.object_] | None) -> str | None:
    if not isinstance(gdf, GeoDataFrame | GeoSeries) or window is None:
        return "wrong arguments"
    return not_ours(array_of(gdf.geometry)) or not_ours(window)


def _remains(
    geometries: npt.NDArray[np.object_],
    clipped: npt.NDArray[np.object_],
    area: npt.NDArray[np.bool_],
    window: npt.NDArray[np.object_],
) -> npt.NDArray[np.bool_]:
    """Rows that meet the mask in lines or points, too: GEOS intersects them. Changes `clipped` there."""
    mask = shapely.union_all(window) if len(window) > 1 else window[0]
    shapely.prepare(mask)
    rows = np.flatnonzero(shapely.intersects(mask, geometries) & ~shapely.contains_properly(mask, geometries))
    touching = touches_outside(regions_of_column(geometries[rows]), union_all(regions_of_column(window)))
    rows = rows[touching]
    found = np.zeros(len(geometries), dtype=bool)
    if len(rows):
        clipped[rows] = shapely.intersection(geometries[rows], mask)
        found[rows] = ~shapely.is_empty(clipped[rows])
        for _ in rows:
            passed_on("clip", "a row that touches the mask")
    return found


def _in_order_of_geopandas(
    gdf: Any, window: npt.NDArray[np.object_], rows: npt.NDArray[np.int64]
) -> npt.NDArray[np.int64]:
    """Rows in the order in which the spatial index of geopandas finds them, which `sort=False` promises to nobody."""
    found = gdf.sindex.query(shapely.box(*shapely.total_bounds(window)))
    rank = np.full(len(gdf), len(gdf))
    rank[found] = np.arange(len(found))
    return rows[np.argsort(rank[rows], kind="stable")]


def _with_geometry(gdf: Any, rows: npt.NDArray[np.int64], shapes: npt.NDArray[np.object_]) -> GeoDataFrame | GeoSeries:
    taken = gdf.iloc[rows].copy()
    if isinstance(gdf, GeoSeries):
        return GeoSeries(shapes, index=taken.index, crs=gdf.crs, name=gdf.name)
    taken[gdf.geometry.name] = GeoSeries(shapes, index=taken.index, crs=gdf.crs)
    return taken
