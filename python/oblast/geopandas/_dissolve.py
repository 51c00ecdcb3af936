"""`GeoDataFrame.dissolve` and `GeoSeries.union_all`, answered by oblast."""

from __future__ import annotations

from typing import Any

import geopandas
import numpy as np
import numpy.typing as npt
import pandas as pd
import shapely
from geopandas import GeoDataFrame

from oblast import _core
from oblast._overlay import union_all as unite
from oblast._regions import Regions
from oblast._settings import settings_of
from oblast.geopandas._originals import originals
from oblast.geopandas._ours import array_of, not_ours, pass_on, regions_of_column

_METHODS = ("unary", "disjoint_subset")


def union_all(series: Any, method: str = "unary", grid_size: float | None = None) -> Any:
    """Unite all geometries, as `GeoSeries.union_all` does.

    Passed on to geopandas, and counted: geometries other than polygons, Z and M, `grid_size`, ``method="coverage"``.

    Parameters
    ----------
    series : GeoSeries, GeoDataFrame or GeometryArray
    method : {"unary", "coverage", "disjoint_subset"}
    grid_size : float, optional

    Returns
    -------
    shapely geometry
    """
    array = series.geometry.values if hasattr(series, "geometry") else series
    geometries = np.asarray(array)
    reason = _reason(geometries, method, grid_size)
    if reason is not None:
        return pass_on("union_all", reason, originals().union_all, array, method, grid_size)
    return unite(regions_of_column(geometries)).to_shapely()[0]


def _reason(geometries: npt.NDArray[np.object_], method: str, grid_size: float | None) -> str | None:
    if method not in _METHODS:
        return f"method {method!r}"
    if grid_size is not None:
        return "grid_size"
    return not_ours(geometries)


def dissolve(
    df: GeoDataFrame,
    by: Any = None,
    aggfunc: Any = "first",
    as_index: bool = True,
    level: Any = None,
    sort: bool = True,
    observed: bool = False,
    dropna: bool = True,
    method: str = "unary",
    grid_size: float | None = None,
    **kwargs: Any,
) -> GeoDataFrame:
    """Unite rows by group, as `GeoDataFrame.dissolve` does; all groups in one pass.

    Passed on to geopandas, and counted: geometries other than polygons, Z and M, `grid_size`, ``method="coverage"``.

    Parameters
    ----------
    df : GeoDataFrame
    by, aggfunc, as_index, level, sort, observed, dropna, method, grid_size, **kwargs
        As in geopandas.

    Returns
    -------
    GeoDataFrame
        Rows that share a border share its vertices, bit for bit.
    """
    geometries = array_of(df.geometry)
    reason = _reason(geometries, method, grid_size)
    if reason is not None:
        return pass_on(
            "dissolve", reason, originals().dissolve, df, by=by, aggfunc=aggfunc, as_index=as_index, level=level,
            sort=sort, observed=observed, dropna=dropna, method=method, grid_size=grid_size, **kwargs,
        )  # fmt: skip
    if by is None and level is None:
        by = np.zeros(len(df), dtype="int64")
    grouping = {"by": by, "level": level, "sort": sort, "observed": observed, "dropna": dropna}
    name = df.geometry.name
    attributes = df.drop(columns=name).groupby(**grouping).agg(aggfunc, **kwargs)
    attributes.columns = attributes.columns.to_flat_index()
    shapes = _united(df, geometries, grouping)
    result = type(df)({name: shapes}, geometry=name, crs=df.crs).join(attributes)
    return result if as_index else result.reset_index()


def _united(df: GeoDataFrame, geometries: npt.NDArray[np.object_], grouping: dict[str, Any]) -> pd.Series:
    """The union of each group, by the index that pandas gives groups."""
    table = pd.DataFrame(df.drop(columns=df.geometry.name))
    place = "__oblast_row"
    table[place] = np.arange(len(df))
    grouped = table.groupby(**grouping)
    numbers = grouped.ngroup().fillna(-1).to_numpy().astype(np.int64)
    first = grouped[place].agg(lambda rows: rows.iloc[0] if len(rows) else -1)
    used = np.flatnonzero(numbers >= 0)
    shapes = np.full(len(first), shapely.GeometryCollection(), dtype=object)
    if len(used):
        with settings_of() as settings:
            regions = regions_of_column(geometries)._take(used)
            groups = numbers[used].astype(np.uint32)
            united = Regions._of(_core.dissolve(regions._core, groups, settings)).to_shapely()
        rows = first.to_numpy().astype(np.int64)
        present = rows >= 0
        shapes[present] = united[numbers[rows[present]]]
        shapes[shapely.is_empty(shapes)] = shapely.GeometryCollection()
    return pd.Series(geopandas.array.from_shapely(shapes, crs=df.crs), index=first.index)
