"""`geopandas.overlay`, answered by oblast."""

from __future__ import annotations

import warnings
from typing import Any, Literal

import geopandas
import numpy as np
import numpy.typing as npt
import pandas as pd
import shapely
from geopandas import GeoDataFrame

from oblast._rows import overlay_features
from oblast.geopandas._originals import originals
from oblast.geopandas._ours import array_of, not_ours, pass_on, regions_of_column

Indices = npt.NDArray[np.int64]
HOWS = ("intersection", "union", "identity", "symmetric_difference", "difference")


def overlay(
    df1: GeoDataFrame,
    df2: GeoDataFrame,
    how: Literal["intersection", "union", "identity", "symmetric_difference", "difference"] = "intersection",
    keep_geom_type: bool | None = None,
    make_valid: bool = True,
) -> GeoDataFrame:
    """Overlay two layers row by row, as `geopandas.overlay` does.

    Answered by oblast for polygons of the plane. Passed on to geopandas, and counted by `oblast.fallbacks`: lines and
    points, Z and M, and ``keep_geom_type=False`` where touching rows leave lines and points.

    Parameters
    ----------
    df1, df2 : GeoDataFrame
    how : {"intersection", "union", "identity", "symmetric_difference", "difference"}
    keep_geom_type : bool, optional
        As in geopandas. None is True with a warning that counts the pairs of rows that only touch. Lines and points
        that a pair leaves beside an area are not counted.
    make_valid : bool
        With False, invalid polygons are a ValueError. With True they are resolved exactly: a polygon is filled by
        even-odd of its rings, and a multipolygon is the union of its polygons.

    Returns
    -------
    GeoDataFrame
        As from geopandas: rows in the same order, the same columns and suffixes, and a new index. Rows that share a
        border share its vertices, bit for bit.
    """
    arguments = (df1, df2, how, keep_geom_type, make_valid)
    reason = _reason(df1, df2, how, keep_geom_type, make_valid)
    if reason is not None:
        return pass_on("overlay", reason, originals().overlay, *arguments)
    _warn_of_crs(df1, df2)
    geometries = array_of(df1.geometry), array_of(df2.geometry)
    if how == "intersection" and not _boxes_meet(df1.total_bounds, df2.total_bounds):
        return _nothing(df1, df2)
    left, right = map(regions_of_column, geometries)
    rows = overlay_features(left, right, how)
    order = _order(rows.a, rows.b)
    i, j = rows.a[order], rows.b[order]
    shapes = rows.regions.to_shapely()[order]
    if how == "difference":
        return _difference(df1, i, shapes, keep_geom_type)
    touching = _touching(geometries, i, j) if how != "symmetric_difference" else 0
    if touching and keep_geom_type is None:
        _warn_of_dropped(touching)
    if how == "intersection" and len(i) == 0 and not touching:
        return _nothing(df1, df2)
    return _joined(df1, df2, i, j, shapes)


def _reason(df1: Any, df2: Any, how: str, keep_geom_type: bool | None, make_valid: bool) -> str | None:
    """Why geopandas answers: it also has the errors of wrong arguments."""
    if how not in HOWS or not (isinstance(df1, GeoDataFrame) and isinstance(df2, GeoDataFrame)):
        return "wrong arguments"
    columns = array_of(df1.geometry), array_of(df2.geometry)
    reason = not_ours(columns[0]) or not_ours(columns[1])
    if reason is not None:
        return reason
    if columns[0][0] is None:
        return "the first geometry is missing"
    if not make_valid and not all(shapely.is_valid(c[c != None]).all() for c in columns):  # noqa: E711
        return "wrong arguments"
    lower = keep_geom_type is False and how not in ("difference", "symmetric_difference")
    if lower and _boxes_meet(df1.total_bounds, df2.total_bounds):
        return "keep_geom_type=False: touching rows may leave lines and points"
    return None


def _warn_of_crs(df1: GeoDataFrame, df2: GeoDataFrame) -> None:
    if df1.crs == df2.crs:
        return
    warnings.warn(
        "CRS mismatch between the CRS of left geometries and the CRS of right geometries.\n"
        "Use `to_crs()` to reproject one of the input geometries to match the CRS of the other.\n\n"
        f"Left CRS: {df1.crs and df1.crs.to_string()}\nRight CRS: {df2.crs and df2.crs.to_string()}\n",
        UserWarning,
        stacklevel=3,
    )


def _boxes_meet(a: Any, b: Any) -> bool:
    return bool(a[0] <= b[2] and b[0] <= a[2] and a[1] <= b[3] and b[1] <= a[3])


def _order(i: Indices, j: Indices) -> Indices:
    """Pairs come first, then what only the first layer covers, then what only the second one does."""
    kind = np.where(i < 0, 2, np.where(j < 0, 1, 0))
    return np.argsort(kind, kind="stable")


def _touching(geometries: tuple[Any, Any], i: Indices, j: Indices) -> int:
    """The number of pairs of rows that meet without an area in common."""
    left, right = shapely.STRtree(geometries[1]).query(geometries[0])
    count = len(geometries[1])
    paired = np.isin(left * count + right, (i * count + j)[(i >= 0) & (j >= 0)])
    left, right = left[~paired], right[~paired]
    return int(shapely.intersects(geometries[0][left], geometries[1][right]).sum())


def _warn_of_dropped(count: int) -> None:
    warnings.warn(
        f"`keep_geom_type=True` in overlay resulted in {count} dropped geometries of different "
        "geometry types than df1 has. Set `keep_geom_type=False` to retain all geometries",
        UserWarning,
        stacklevel=3,
    )


def _attributes(frame: GeoDataFrame, rows: Indices) -> pd.DataFrame:
    """The columns without the geometry, by row; missing values where the row is -1."""
    plain = pd.DataFrame(frame.drop(columns=frame.geometry.name)).reset_index(drop=True)
    taken: pd.DataFrame = plain.reindex(rows) if (rows < 0).any() else plain.take(rows)
    return taken.reset_index(drop=True)


def _suffixed(left: pd.DataFrame, right: pd.DataFrame) -> pd.DataFrame:
    both = set(left.columns) & set(right.columns)
    left.columns = [f"{c}_1" if c in both else c for c in left.columns]
    right.columns = [f"{c}_2" if c in both else c for c in right.columns]
    return pd.concat([left, right], axis=1)


def _joined(df1: Any, df2: Any, i: Indices, j: Indices, shapes: npt.NDArray[np.object_]) -> GeoDataFrame:
    table = _suffixed(_attributes(df1, i), _attributes(df2, j))
    table = table.drop(columns="geometry", errors="ignore")
    return GeoDataFrame(table, geometry=geopandas.GeoSeries(shapes, crs=df1.crs), crs=df1.crs)


def _nothing(df1: GeoDataFrame, df2: GeoDataFrame) -> GeoDataFrame:
    """No rows, and the name of the geometry of the first layer, as geopandas has it."""
    none = np.empty(0, dtype=np.int64)
    table = _suffixed(_attributes(df1, none), _attributes(df2, none))
    name = df1.geometry.name
    table[name] = geopandas.GeoSeries([], crs=df1.crs)
    return GeoDataFrame(table, geometry=name, crs=df1.crs)


def _difference(
    df1: GeoDataFrame, i: Indices, shapes: npt.NDArray[np.object_], keep_geom_type: bool | None
) -> GeoDataFrame:
    if keep_geom_type is False:  # missing geometries are kept
        missing = np.flatnonzero(df1.geometry.isna())
        i = np.concatenate((i, missing))
        shapes = np.concatenate((shapes, np.full(len(missing), None)))
        order = np.argsort(i, kind="stable")
        i, shapes = i[order], shapes[order]
    rows = df1.take(i).reset_index(drop=True)
    rows[df1.geometry.name] = geopandas.GeoSeries(shapes, crs=df1.crs)
    return rows
