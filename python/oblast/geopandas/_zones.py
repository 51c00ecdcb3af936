"""Zones of the rows of a GeoDataFrame."""

from __future__ import annotations

import math
from typing import Any

import geopandas
import numpy as np
import numpy.typing as npt
import pandas as pd
from geopandas import GeoDataFrame, GeoSeries

from oblast._regions import Regions
from oblast._settings import settings_of
from oblast._shapely import to_shapely
from oblast._shapes import of_shapely
from oblast._zones import frame_of, zones_of

__all__ = ["frame_of_crs", "require_plane", "zones", "zones_of_rows"]

RELATIVE = 1e-5


def zones(
    objects: GeoDataFrame | GeoSeries,
    within: Any = None,
    *,
    by: Any = None,
    tolerance: float = 0.0,
    relative_tolerance: float = RELATIVE,
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
    require_plane(objects)
    numbers = np.arange(len(objects))
    result = objects
    if by is not None:
        grouped = _attributes(objects).groupby(by, dropna=False)
        numbers, result = np.array(grouped.ngroup(), dtype=np.int64), grouped.first()
    lengths = tolerance, relative_tolerance, distance
    made, error, rounding = zones_of_rows(objects, numbers, len(result), frame_of_crs(within, objects), lengths)
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


def require_plane(objects: GeoDataFrame | GeoSeries) -> None:
    if objects.crs is not None and objects.crs.is_geographic:
        raise ValueError(
            f"the objects are in degrees ({objects.crs.name}), in which the nearest one cannot be found; "
            "project them first, as by objects.to_crs(objects.estimate_utm_crs())"
        )


def frame_of_crs(within: Any, objects: GeoDataFrame | GeoSeries) -> Regions:
    crs = getattr(within, "crs", None)
    if crs is not None and objects.crs is not None and crs != objects.crs:
        raise ValueError(f"within is in {crs.name}, and the objects are in {objects.crs.name}; use within.to_crs(...)")
    return frame_of(within)


def zones_of_rows(
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
