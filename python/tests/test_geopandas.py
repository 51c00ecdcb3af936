"""The drop-in beside geopandas. tools/python-geopandas runs geopandas' own tests against it."""

from __future__ import annotations

import warnings

import geopandas
import numpy as np
import pandas as pd
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

import oblast
import oblast.geopandas as og
from oblast.geopandas._touching import touches_outside
from shapes import squares

HOWS = ["intersection", "union", "identity", "symmetric_difference", "difference"]


def frame(corners: list[tuple[float, float]], name: str, **columns: object) -> geopandas.GeoDataFrame:
    geometry = squares(*corners).to_shapely()
    return geopandas.GeoDataFrame({name: range(len(corners)), **columns}, geometry=geometry, crs=3857)


A = frame([(0, 0), (2, 0), (0, 2), (8, 8)], "a", same=list("wxyz"))
B = frame([(1, 1), (4, 4), (1, 1)], "b", same=[1.5, 2.5, None])


@pytest.fixture(autouse=True)
def _no_counts() -> None:
    oblast.fallbacks(clear=True)


def same(ours: geopandas.GeoDataFrame, theirs: geopandas.GeoDataFrame) -> None:
    """The same rows, columns, types and regions; the order of vertices is free."""
    pd.testing.assert_frame_equal(
        pd.DataFrame(ours.drop(columns=ours.geometry.name)),
        pd.DataFrame(theirs.drop(columns=theirs.geometry.name)),
    )
    assert list(ours.columns) == list(theirs.columns)
    assert ours.geometry.name == theirs.geometry.name and ours.crs == theirs.crs
    assert (ours.geometry.isna() == theirs.geometry.isna()).all()
    apart = shapely.symmetric_difference(np.asarray(ours.geometry), np.asarray(theirs.geometry))
    assert (shapely.area(apart[ours.geometry.notna()]) < 1e-9).all()
    assert (ours.geometry.dropna().geom_type == theirs.geometry.dropna().geom_type).all()


@pytest.mark.parametrize("how", HOWS)
def test_overlay_is_that_of_geopandas(how: str) -> None:
    for left, right in ((A, B), (B, A), (A.set_index("same"), B), (A.iloc[3:], B)):
        same(og.overlay(left, right, how, True), geopandas.overlay(left, right, how, True))
    assert oblast.fallbacks() == {}


@pytest.mark.parametrize("how", HOWS)
def test_missing_geometries(how: str) -> None:
    left = A.copy()
    left.loc[1, "geometry"] = None
    same(og.overlay(left, B, how, True), geopandas.overlay(left, B, how, True))
    if how == "difference":
        same(og.overlay(left, B, how, False), geopandas.overlay(left, B, how, False))


def test_touching_rows_are_counted_or_passed_on() -> None:
    left, right = frame([(0, 0)], "a"), frame([(2, 0), (1, 1)], "b")
    with pytest.warns(UserWarning, match="resulted in 1 dropped"):
        assert len(og.overlay(left, right)) == 1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(og.overlay(left, right, keep_geom_type=True)) == 1
    assert oblast.fallbacks() == {}
    assert len(og.overlay(left, right, keep_geom_type=False)) == 2
    assert [(f.function, n) for f, n in oblast.fallbacks().items()] == [("overlay", 1)]


def test_errors_are_those_of_geopandas() -> None:
    with pytest.raises(ValueError, match="`how` was 'erase'"):
        og.overlay(A, B, "erase")
    with pytest.raises(NotImplementedError):
        og.overlay(A.geometry, B)
    bow_tie = A.copy()
    bow_tie.loc[0, "geometry"] = shapely.Polygon([(0, 0), (1, 1), (1, 0), (0, 1)])
    with pytest.raises(ValueError, match="make_valid=False"):
        og.overlay(bow_tie, B, make_valid=False)
    with pytest.warns(UserWarning, match="CRS mismatch"):
        og.overlay(A, B.set_crs(3035, allow_override=True), keep_geom_type=True)
    assert oblast.fallbacks() == {}


def test_other_geometries_are_passed_on() -> None:
    points = A.set_geometry(A.centroid)
    assert len(og.overlay(points, B, "intersection")) == len(geopandas.overlay(points, B, "intersection"))
    solid = A.set_geometry(shapely.force_3d(A.geometry.values, 1.0))
    og.union_all(solid.geometry)
    assert sorted(f.reason for f in oblast.fallbacks()) == ["Z or M", "geometries other than polygons"]
    assert oblast.fallbacks(clear=True) and not oblast.fallbacks()


@pytest.mark.parametrize(
    "arguments",
    [
        {},
        {"by": "g"},
        {"by": "g", "as_index": False, "aggfunc": "sum"},
        {"by": ["g", "h"], "aggfunc": {"n": "max"}},
        {"by": "g", "dropna": False},
        {"by": "g", "sort": False, "aggfunc": ["min", "max"]},
        {"by": "c", "observed": False},
        {"by": "c", "observed": True},
        {"level": 0},
        {"by": lambda row: row % 2},
    ],
)
def test_dissolve_is_that_of_geopandas(arguments: dict) -> None:
    rows = frame([(0, 0), (1, 1), (5, 5), (6, 5), (9, 9)], "n")
    rows["g"] = ["y", "x", "y", "x", None]
    rows["h"] = [1, 1, 1, 2, 2]
    rows["c"] = pd.Categorical(["k", "l", "k", "l", "k"], categories=["k", "m", "l"])
    if arguments.get("aggfunc") is not None or callable(arguments.get("by")):
        rows = rows.drop(columns="c")
    if arguments.get("aggfunc") == ["min", "max"]:
        rows = rows.drop(columns="h")
    ours, theirs = og.dissolve(rows, **arguments), rows.dissolve(**arguments)
    same(ours, theirs)
    assert oblast.fallbacks() == {}


def test_union_all() -> None:
    united = og.union_all(A.geometry)
    assert united.equals(A.union_all())
    assert og.union_all(A.geometry, grid_size=1.0).area == 16
    assert [f.reason for f in oblast.fallbacks()] == ["grid_size"]


@pytest.mark.parametrize("mask", [(0.5, 0.5, 3, 3), shapely.box(0.5, 0.5, 3, 3), B, B.geometry.iloc[0]])
@pytest.mark.parametrize("keep", [True, False])
def test_clip_is_that_of_geopandas(mask: object, keep: bool) -> None:
    same(og.clip(A, mask, keep).sort_index(), geopandas.clip(A, mask, keep).sort_index())
    series = og.clip(A.geometry, mask, keep)
    assert series.area.sum() == pytest.approx(geopandas.clip(A.geometry, mask, keep).area.sum())


@settings(max_examples=300, deadline=None)
@given(st.lists(st.lists(st.tuples(*[st.integers(0, 4)] * 2), min_size=3, max_size=4), min_size=1, max_size=5))
def test_rows_that_touch_the_mask_are_found_exactly(rings: list[list[tuple[int, int]]]) -> None:
    """Small whole numbers, where GEOS is exact enough to be asked."""
    polygons = [polygon for polygon in map(shapely.Polygon, rings) if polygon.is_valid and polygon.area > 0]
    polygons.append(shapely.box(1, 1, 3, 3))
    *rows, mask = (shapely.Polygon(shapely.get_coordinates(polygon)) for polygon in polygons)
    expected = [
        bool((shapely.get_dimensions(shapely.get_parts(shapely.intersection(row, mask))) < 2).any()) for row in rows
    ]
    found = touches_outside(oblast.from_shapely([*rows, shapely.Polygon()]), oblast.union_all(mask))
    assert found.tolist() == [*expected, True]


def test_clip_keeps_what_touches() -> None:
    rows, mask = frame([(0, 0), (2, 0), (1, 1)], "a"), shapely.box(2, 0, 4, 2)
    same(og.clip(rows, mask).sort_index(), geopandas.clip(rows, mask).sort_index())
    assert [f.reason for f in oblast.fallbacks()] == ["a row that touches the mask"]
    assert len(og.clip(rows, mask, keep_geom_type=True)) == 2


def test_install_and_uninstall() -> None:
    own = geopandas.overlay, geopandas.GeoDataFrame.dissolve
    with og.install():
        assert geopandas.overlay is og.overlay and geopandas.clip is og.clip
        assert A.overlay(B, "union", keep_geom_type=True).area.sum() > 0
        assert A.dissolve().area.sum() == A.union_all().area == 16
        A.clip((0, 0, 1, 1))
    assert (geopandas.overlay, geopandas.GeoDataFrame.dissolve) == own
    og.install()
    og.uninstall()
    assert geopandas.overlay is own[0]
