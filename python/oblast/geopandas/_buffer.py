"""`GeoSeries.buffer`, answered by oblast."""

from __future__ import annotations

import math
from typing import Any

import geopandas
import numpy as np
import numpy.typing as npt
import pandas as pd
import shapely

from oblast._buffer import Cap, Join, Side, shape_of, zones_of
from oblast._regions import Regions
from oblast._settings import settings_of
from oblast._shapely import to_shapely
from oblast._shapes import of_shapely
from oblast.geopandas._originals import originals
from oblast.geopandas._ours import pass_on

_CAPS: dict[str, Cap] = {"round": "round", "flat": "flat", "square": "square"}
_JOINS: dict[str, Join] = {"round": "round", "mitre": "mitre", "bevel": "bevel"}
_AREAS = (3, 6, 7)  # Polygon, MultiPolygon, GeometryCollection


def buffer(
    series: Any,
    distance: Any,
    resolution: int = 16,
    cap_style: str = "round",
    join_style: str = "round",
    mitre_limit: float = 5.0,
    single_sided: bool = False,
    **kwargs: Any,
) -> Any:
    """Zones of all geometries, each by itself, as `GeoSeries.buffer` makes them.

    Passed on to geopandas, and counted: distances that are not finite, polygons and collections with `single_sided`,
    and other arguments than these.

    Parameters
    ----------
    series : GeoSeries, GeoDataFrame or GeometryArray
        Polygons, lines, points and collections.
    distance : float, or sequence of float
        A Series must have the index of `series`. Of a negative one, polygons shrink, and lines and points give
        nothing.
    resolution : int
        Segments of a quarter circle (also ``quad_segs``). The outline is nowhere beyond the distance, and at least as
        near to it as so many segments would be: the tolerance is 1 - cos(pi / (4 resolution)). Directions are 8, 16, 32
        and so on, so there may be more segments than asked for: ``resolution=1`` makes an octagon of a point, where
        geopandas makes a square that stands on its corner. For a square of twice the distance: ``cap_style="square"``.
    cap_style : {"round", "flat", "square"}
    join_style : {"round", "mitre", "bevel"}
    mitre_limit : float
    single_sided : bool
        Of lines: only the left side; the right one if the distance is negative.

    Returns
    -------
    GeoSeries, or a GeometryArray of one
        With the index and the CRS of `series`; None stays None.
    """
    if not isinstance(series, geopandas.array.GeometryArray):
        return _of_series(series, distance, resolution, cap_style, join_style, mitre_limit, single_sided, kwargs)
    resolution = kwargs.pop("quad_segs", resolution)
    geometries = np.asarray(series)
    reason = _reason(geometries, distance, resolution, cap_style, join_style, mitre_limit, single_sided, kwargs)
    if reason is not None:
        return pass_on(
            "buffer", reason, originals().buffer, series, distance, resolution=resolution, cap_style=cap_style,
            join_style=join_style, mitre_limit=mitre_limit, single_sided=single_sided, **kwargs,
        )  # fmt: skip
    distances = np.broadcast_to(np.asarray(distance, dtype=np.float64), geometries.shape)
    if distances.any():
        series.check_geographic_crs(stacklevel=5)
    zones = _zones(geometries, distances, resolution, _CAPS[cap_style], _JOINS[join_style], mitre_limit, single_sided)
    zones[shapely.is_missing(geometries)] = None
    return geopandas.array.GeometryArray(zones, crs=series.crs)


def _of_series(
    series: Any,
    distance: Any,
    resolution: int,
    cap_style: str,
    join_style: str,
    mitre_limit: float,
    single_sided: bool,
    kwargs: dict[str, Any],
) -> Any:
    if isinstance(distance, pd.Series):
        if not series.index.equals(distance.index):
            raise ValueError("Index values of distance sequence does not match index values of the GeoSeries")
        distance = np.asarray(distance)
    array = buffer(
        series.geometry.values, distance, resolution, cap_style, join_style, mitre_limit, single_sided, **kwargs
    )
    return geopandas.GeoSeries(array, index=series.index, crs=series.crs)


def _reason(
    geometries: npt.NDArray[np.object_],
    distance: Any,
    resolution: Any,
    cap_style: Any,
    join_style: Any,
    mitre_limit: float,
    single_sided: bool,
    others: dict[str, Any],
) -> str | None:
    """Why geopandas answers, also with its errors; None if the call is ours."""
    if others:
        return f"argument {next(iter(others))}"
    if cap_style not in _CAPS or join_style not in _JOINS:
        return "cap_style or join_style"
    if not isinstance(resolution, int | np.integer) or resolution < 1 or mitre_limit < 1:
        return "resolution or mitre_limit"
    try:
        distances = np.asarray(distance, dtype=np.float64)
    except (TypeError, ValueError):
        return "distance"
    if distances.shape not in ((), geometries.shape) or not np.isfinite(distances).all():
        return "distance"
    if single_sided and np.isin(shapely.get_type_id(geometries), _AREAS).any():
        return "areas or collections with single_sided"
    return None


def tolerance_of(resolution: int) -> float:
    """How far a circle of so many segments a quarter is inside the true one, as a share of its radius."""
    least = 1e-9
    return max(least, 1 - math.cos(math.pi / (4 * resolution)))


def _zones(
    geometries: npt.NDArray[np.object_],
    distances: npt.NDArray[np.float64],
    resolution: int,
    cap: Cap,
    join: Join,
    mitre_limit: float,
    single_sided: bool,
) -> npt.NDArray[np.object_]:
    shapes = geometries.copy()
    flat = shapely.has_z(shapes) | shapely.has_m(shapes)
    shapes[flat] = shapely.force_2d(shapes[flat])

    def zones(some: npt.NDArray[np.bool_], by: npt.NDArray[np.float64], side: Side) -> npt.NDArray[np.object_]:
        return to_shapely(_rows(shapes[some], by[some], tolerance_of(resolution), cap, join, mitre_limit, side))

    made = np.empty(len(shapes), dtype=object)
    right = single_sided & (distances < 0)
    made[~right] = zones(~right, distances, "left" if single_sided else "both")
    if right.any():
        made[right] = zones(right, -distances, "right")
    return made


def _rows(
    geometries: npt.NDArray[np.object_],
    distances: npt.NDArray[np.float64],
    tolerance: float,
    cap: Cap,
    join: Join,
    mitre_limit: float,
    side: Side,
) -> Regions:
    shape = shape_of(join, cap, side, "inside", mitre_limit, tolerance)
    with settings_of() as settings:
        return zones_of(of_shapely(geometries, "error"), distances, shape, True, settings)
