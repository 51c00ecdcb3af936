"""Laws that hold for any polygons, by hypothesis; every result is proved valid by exact arithmetic."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

import oblast

SOME = settings(max_examples=150, deadline=None)
COORDINATES = st.one_of(st.integers(0, 6).map(float), st.floats(-10, 10, width=32))
POINTS = st.tuples(COORDINATES, COORDINATES)
RINGS = st.lists(POINTS, min_size=3, max_size=7)


@st.composite
def layers(draw: st.DrawFn) -> oblast.Regions:
    """Rows of one ring each, of any form."""
    rings = draw(st.lists(RINGS, min_size=1, max_size=4))
    points = [point for ring in rings for point in ring]
    return oblast.from_ragged(points, np.cumsum([0, *map(len, rings)]))


def near(a: float, b: float) -> bool:
    return a == pytest.approx(b, abs=1e-9, rel=1e-9)


@SOME
@given(layers(), layers())
def test_results_are_valid_and_areas_add_up(a: oblast.Regions, b: oblast.Regions) -> None:
    parts = {how: oblast.overlay(a, b, how) for how in ("intersection", "union", "difference", "symmetric_difference")}
    for part in parts.values():
        assert oblast.check(part, canonical=True)
        assert oblast.union_all(part) == part
    area = {how: part.area for how, part in parts.items()}
    whole = oblast.union_all(a).area + oblast.union_all(b).area
    assert near(whole, area["union"] + area["intersection"])
    assert near(area["union"], area["intersection"] + area["symmetric_difference"])
    assert near(oblast.union_all(a).area, area["difference"] + area["intersection"])


@SOME
@given(layers(), st.randoms())
def test_the_order_of_rows_does_not_matter(a: oblast.Regions, random) -> None:
    order = list(range(len(a)))
    random.shuffle(order)
    assert oblast.union_all(a[order]) == oblast.union_all(a)


@SOME
@given(layers(), layers())
def test_rows_are_the_overlays_of_rows(a: oblast.Regions, b: oblast.Regions) -> None:
    rows = oblast.overlay_features(a, b, "intersection")
    found = {(int(i), int(j)): row.area for row, i, j in zip(*rows, strict=True)}
    for i in range(len(a)):
        for j in range(len(b)):
            assert near(found.get((i, j), 0.0), oblast.intersection(a[i], b[j]).area)


@SOME
@given(layers())
def test_formats_keep_every_bit(a: oblast.Regions) -> None:
    united = oblast.union_all(a)
    assert oblast.from_wkb(united.to_wkb()) == united
    assert oblast.union_all(united.to_arrow("multipolygon", "separate")) == united
    if united:
        assert oblast.union_all(united.to_shapely()) == united


@SOME
@given(layers(), layers())
def test_areas_are_those_of_geos(a: oblast.Regions, b: oblast.Regions) -> None:
    ours = oblast.intersection(a, b)
    try:
        theirs = shapely.intersection(*(shapely.union_all(oblast.repair(x).to_shapely()) for x in (a, b)))
    except shapely.errors.GEOSException:
        return
    assert ours.area == pytest.approx(theirs.area, abs=1e-6)


@SOME
@given(layers(), st.lists(POINTS, min_size=1, max_size=20))
def test_points_are_located_as_geos_does(a: oblast.Regions, points: list[tuple[float, float]]) -> None:
    united = oblast.union_all(a)
    expected = shapely.contains_xy(united.to_shapely()[0], np.array(points))
    assert oblast.Locator(united).contains(points).tolist() == expected.tolist()


@SOME
@given(layers())
def test_depth_counts_every_row_once(a: oblast.Regions) -> None:
    counted = oblast.depth(a)
    assert oblast.check(oblast.union_all(counted.regions))
    areas = np.array([row.area for row in counted.regions])
    assert near(float((areas * counted.depth).sum()), sum(oblast.union_all(row).area for row in a))
    for row, depth in zip(counted.regions, counted.depth, strict=True):
        assert oblast.check(row) and near(row.area, oblast.union_all(row).area)
        assert near(oblast.intersection(row, oblast.union_all(a)).area, row.area)
        assert depth <= len(a)


@SOME
@given(layers(), st.data())
def test_dissolving_groups_is_uniting_each(a: oblast.Regions, data: st.DataObject) -> None:
    groups = np.array(data.draw(st.lists(st.integers(0, 2), min_size=len(a), max_size=len(a))))
    united = oblast.union_all(a, by=groups)
    for row, group in zip(united, np.unique(groups), strict=True):
        assert near(row.area, oblast.union_all(a[groups == group]).area)
        assert oblast.symmetric_difference(row, a[groups == group]).area < 1e-9
    assert near(oblast.union_all(united).area, oblast.union_all(a).area)


@SOME
@given(layers(), layers())
def test_pairs_are_overlays(a: oblast.Regions, b: oblast.Regions) -> None:
    i, j = (side.ravel() for side in np.meshgrid(np.arange(len(a)), np.arange(len(b))))
    for how in ("intersection", "union", "difference", "symmetric_difference"):
        rows = oblast.overlay_pairs(a, b, i, j, how)
        assert list(rows) == [oblast.overlay(a[x], b[y], how) for x, y in zip(i, j, strict=True)]


@SOME
@given(layers(), layers())
def test_operands_change_places(a: oblast.Regions, b: oblast.Regions) -> None:
    for how in ("intersection", "union", "symmetric_difference"):
        assert oblast.overlay(a, b, how) == oblast.overlay(b, a, how)
        assert oblast.overlay(a, b, how, threads=1) == oblast.overlay(a, b, how)


@SOME
@given(layers())
def test_repair_is_done_once(a: oblast.Regions) -> None:
    repaired = oblast.repair(a)
    assert all(oblast.check(row, canonical=True) for row in repaired if row)
    assert oblast.repair(repaired) == repaired
    assert oblast.union_all(repaired) == oblast.union_all(a) or near(oblast.symmetric_difference(repaired, a).area, 0)


@SOME
@given(layers())
def test_a_copy_by_pickle_is_equal(a: oblast.Regions) -> None:
    united = oblast.union_all(a)
    copy = pickle.loads(pickle.dumps(united))
    assert copy == united and hash(copy) == hash(united)
    assert copy.points.tobytes() == united.points.tobytes()
