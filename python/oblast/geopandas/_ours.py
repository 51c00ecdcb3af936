"""Which calls are answered here, and which geopandas answers itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
import shapely

from oblast._fallbacks import passed_on
from oblast._regions import Regions
from oblast._shapely import from_shapely

POLYGON, MULTIPOLYGON, MISSING = 3, 6, -1


def not_ours(geometries: npt.NDArray[np.object_]) -> str | None:
    """Why a column is for geopandas, or None: it has polygons of the plane only."""
    types = shapely.get_type_id(geometries)
    polygons = np.isin(types, (POLYGON, MULTIPOLYGON))
    if not (polygons | (types == MISSING)).all():
        return "geometries other than polygons"
    if not polygons.any():
        return "no geometries"
    if shapely.has_z(geometries).any() or shapely.has_m(geometries).any():
        return "Z or M"
    return None


def pass_on(name: str, reason: str, function: Callable[..., Any], *args: Any, **kwargs: Any) -> Any:
    """Let geopandas answer. A call that it refuses is not counted."""
    result = function(*args, **kwargs)
    passed_on(name, reason)
    return result


def regions_of_column(geometries: npt.NDArray[np.object_]) -> Regions:
    """Rows of a column that `not_ours` let pass."""
    return from_shapely(geometries, "error")


def array_of(column: Any) -> npt.NDArray[np.object_]:
    """The shapely geometries of a GeoSeries."""
    return np.asarray(column.values)
