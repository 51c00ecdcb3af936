"""Proximity zones, and the drop-ins for momepy's tessellations."""

from __future__ import annotations

import inspect
import math
import os
from pathlib import Path
from typing import Any

import geopandas
import momepy
import numpy as np
import pandas as pd
import pytest
import shapely

import oblast
import oblast.geopandas as og
from shapes import square, squares, tangle

FIELD = (0, 0, 20, 10)
LINE = shapely.LineString([(0, 0), (100, 0), (100, 50), (30, 20)])
POINT = shapely.Point(200, 0)
AREA = shapely.Point(0, 200).buffer(30).difference(shapely.box(-5, 195, 5, 205))
MIXED = [
    LINE,
    None,
    AREA,
    shapely.MultiPoint([(200, 0), (180, 90)]),
    shapely.GeometryCollection([POINT, AREA.buffer(-9)]),
]


def areas(found: oblast.Zones) -> list[float]:
    """Of each zone."""
    return [row.area for row in found.regions]


def is_coverage(regions: oblast.Regions, area: float) -> bool:
    """Rows do not overlap, and have this area together, up to the rounding of new vertices on the outline."""
    return bool(oblast.depth(regions).depth.max() == 1) and regions.area == pytest.approx(area, rel=1e-10)


def test_points_share_the_frame() -> None:
    points = np.array([[5.0, 5.0], [9.0, 5.0], [100.0, 100.0]])
    found = oblast.zones(points, FIELD)
    assert areas(found) == [70, 130, 0]
    assert found.error == 0 and 0 < found.rounding < 1e-10
    assert found.groups.tolist() == [0, 1, 2]
    as_shapes = oblast.zones(shapely.points(points), shapely.box(*FIELD))
    assert as_shapes.regions == found.regions


def test_points_are_those_of_scipy() -> None:
    points = np.random.default_rng(5).random((500, 2))
    found = oblast.zones(points, (0, 0, 1, 1))
    cells = shapely.get_parts(
        shapely.voronoi_polygons(shapely.multipoints(points), extend_to=shapely.box(0, 0, 1, 1), ordered=True)
    )
    theirs = shapely.area(shapely.intersection(cells, shapely.box(0, 0, 1, 1)))
    np.testing.assert_allclose(areas(found), theirs, rtol=1e-9)
    assert is_coverage(found.regions, 1)


@pytest.mark.parametrize("tolerance", [10, 0.1, 0.001])
def test_mixed_objects(tolerance: float) -> None:
    found = oblast.zones(MIXED, tolerance=tolerance)
    assert len(found.regions) == 5 and not found.regions[1]
    assert 0 < found.error <= tolerance
    bounds = found.regions.bounds
    assert bounds is not None
    assert is_coverage(found.regions, shapely.box(*bounds).area)
    judge_nearness(MIXED, found, np.random.default_rng(1))
    polygons = shapely.from_wkb(found.regions.to_wkb())
    assert polygons[2].covers(AREA)


def judge_nearness(objects: Any, found: oblast.Zones, random: np.random.Generator) -> None:
    """At random places of zones no object is nearer by more than the bounds. A little more for GEOS' distances."""
    geometries = np.array([shapely.Point() if g is None else g for g in objects], dtype=object)
    x0, y0, x1, y1 = found.regions.bounds or (0, 0, 0, 0)
    places = shapely.points(random.uniform((x0, y0), (x1, y1), (2000, 2)))
    tree = shapely.STRtree(found.regions.to_shapely())
    place, row = tree.query(places, predicate="within")
    distances = np.array([np.nan_to_num(shapely.distance(g, places[place]), nan=math.inf) for g in geometries])
    own = distances[row, np.arange(len(row))]
    assert len(row) >= 1900
    assert (own - distances.min(axis=0)).max() <= found.error + found.rounding + 1e-9


def test_by_makes_several_rows_one_object() -> None:
    found = oblast.zones(np.array([[2.0, 5], [10, 5], [18, 5]]), FIELD, by=["b", "a", "b"])
    assert found.groups.tolist() == ["a", "b"] and areas(found) == [80, 120]
    with pytest.raises(ValueError, match="one group for each of 1 rows"):
        oblast.zones(square(), by=[1, 2])


def test_distance_ends_the_zones() -> None:
    found = oblast.zones(np.array([[0.0, 0], [10, 0]]), distance=2, tolerance=0.001)
    for area in areas(found):
        assert area == pytest.approx(4 * math.pi, abs=0.02) and area >= 4 * math.pi - 1e-6


def test_overlaps_go_to_the_first() -> None:
    found = oblast.zones(squares((0, 0), (1, 0), (0.5, 0)), (0, 0, 10, 2))
    assert areas(found)[0] == pytest.approx(4, abs=1e-3) and areas(found)[2] == pytest.approx(0, abs=1e-3)


@pytest.mark.parametrize("given", [lambda g: g, geopandas.GeoSeries, shapely.to_wkb, lambda g: list(shapely.to_wkb(g))])
def test_operands(given: Any) -> None:
    geometries = np.array([AREA, LINE, POINT], dtype=object)
    assert oblast.zones(given(geometries)).regions == oblast.zones(list(geometries)).regions


def test_errors() -> None:
    with pytest.raises(ValueError, match="within has no polygons"):
        oblast.zones(square(), shapely.Polygon())
    with pytest.raises(oblast.OblastError, match="relative_tolerance"):
        oblast.zones(square(), relative_tolerance=3)
    with pytest.raises(oblast.OblastError, match="distance"):
        oblast.zones(square(), distance=-1)
    with pytest.raises(oblast.OblastError) as raised:
        oblast.zones([POINT, shapely.LineString([(0, 0), (1, math.inf)])])
    assert (raised.value.operand, raised.value.row, raised.value.vertex) == (1, 1, 1)
    with pytest.raises(oblast.OblastError, match="limit"):
        oblast.zones(tangle(200), most_bytes=1000)


def test_progress_ends_the_call_and_statistics_count() -> None:
    points = np.random.default_rng(2).random((50_000, 2))

    def stop(fraction: float) -> None:
        raise TimeoutError

    with pytest.raises(TimeoutError):
        oblast.zones(points, progress=stop)
    with oblast.statistics() as counted:
        oblast.zones(points[:10])
    assert counted.calls == 1 and counted.output_vertices > 10


def test_threads_change_nothing() -> None:
    one, two = (oblast.zones(MIXED, tolerance=0.1, threads=n) for n in (1, 2))
    assert one.regions == two.regions


FRAME = geopandas.GeoDataFrame(
    {"kind": ["x", "y", "x"], "n": [1, 2, 3]},
    index=[7, 5, 5],
    geometry=geopandas.points_from_xy([2, 10, 18], [5, 5, 5]),
    crs=3857,
)


def test_frames_keep_index_and_attributes() -> None:
    found = og.zones(FRAME, shapely.box(*FIELD))
    assert found.index.equals(FRAME.index) and found.crs == FRAME.crs and list(found.columns) == list(FRAME.columns)
    assert found.area.tolist() == [60, 80, 60] and found["n"].tolist() == [1, 2, 3]
    assert found.attrs["error"] == 0 and found.attrs["rounding"] < 1e-9
    renamed = og.zones(FRAME.rename_geometry("where"), FIELD)
    assert renamed.geometry.name == "where" and renamed.area.tolist() == [60, 80, 60]
    series = og.zones(FRAME.geometry.rename("shape"), geopandas.GeoSeries([shapely.box(*FIELD)], crs=3857))
    assert isinstance(series, geopandas.GeoSeries) and series.name == "shape" and series.index.equals(FRAME.index)
    assert FRAME.geometry.geom_type.eq("Point").all(), "the operand is not changed"


def test_frames_with_groups() -> None:
    found = og.zones(FRAME, FIELD, by="kind")
    assert found.index.tolist() == ["x", "y"] and found.index.name == "kind"
    assert found.area.tolist() == [120, 80] and found["n"].tolist() == [1, 2] and found.crs == FRAME.crs
    of_series = og.zones(FRAME.geometry, FIELD, by=np.array([4, 4, None]))
    assert of_series.area.tolist() == [140, 60]


def test_frames_are_refused_in_degrees_and_with_another_crs() -> None:
    with pytest.raises(ValueError, match="in degrees"):
        og.zones(FRAME.to_crs(4326))
    with pytest.raises(ValueError, match="within is in WGS 84"):
        og.zones(FRAME, FRAME.to_crs(4326))


# momepy's own example.
SHARED = Path(os.environ.get("OBLAST_SHARED", Path(__file__).parents[3] / "shared"))
BUBENEC = SHARED / "realworld" / "bubenec.gpkg"
needs_bubenec = pytest.mark.skipif(not BUBENEC.exists(), reason="OBLAST_SHARED has no bubenec.gpkg")


@pytest.fixture(scope="module")
def buildings() -> geopandas.GeoDataFrame:
    return geopandas.read_file(BUBENEC, layer="buildings")


@pytest.fixture(scope="module")
def blocks() -> geopandas.GeoDataFrame:
    return momepy.enclosures(geopandas.read_file(BUBENEC, layer="streets"))


def signature(function: Any) -> list[tuple[str, Any]]:
    """Names and defaults of the arguments that are given by place."""
    return [
        (p.name, p.default)
        for p in inspect.signature(function).parameters.values()
        if p.kind is p.POSITIONAL_OR_KEYWORD
    ]


@pytest.mark.parametrize("name", ["morphological_tessellation", "enclosed_tessellation"])
def test_signatures_are_those_of_momepy(name: str) -> None:
    assert signature(getattr(og, name)) == signature(getattr(momepy, name))


def alike(ours: geopandas.GeoDataFrame, theirs: geopandas.GeoDataFrame, buildings: geopandas.GeoDataFrame) -> None:
    """The same columns and index; cells that hold their buildings, and differ from momepy's by about its steps."""
    assert list(ours.columns) == list(theirs.columns) and ours.index.equals(theirs.index) and ours.crs == theirs.crs
    difference = ours.geometry.symmetric_difference(theirs.geometry, align=False)
    step = 0.5 * ours.length.to_numpy()
    assert (difference.area.to_numpy() <= step).all()
    assert ours.index.name == theirs.index.name


@needs_bubenec
@pytest.mark.filterwarnings("ignore:Numba")
def test_morphological_tessellation(buildings: geopandas.GeoDataFrame) -> None:
    clip = shapely.box(*buildings.total_bounds)
    ours = og.morphological_tessellation(buildings, clip)
    alike(ours, momepy.morphological_tessellation(buildings, clip), buildings)
    assert is_coverage(oblast.from_shapely(ours), clip.area)
    assert all(cell.covers(building) for cell, building in zip(ours.geometry, buildings.geometry, strict=True))
    assert ours.attrs["error"] <= 1e-5 * 700
    for word in ("bounding_box", "convex_hull", "alpha_shape"):
        other = og.morphological_tessellation(buildings, word, tolerance=0.1)
        assert other.area.sum() <= clip.area * (1 + 1e-10) and len(other) == len(buildings)
    assert og.morphological_tessellation(buildings, None, tolerance=0.1).area.sum() > clip.area
    assert og.morphological_tessellation(buildings, grid_size=1e-5, tolerance=0.1).index.equals(buildings.index)


@needs_bubenec
def test_enclosed_tessellation(buildings: geopandas.GeoDataFrame, blocks: geopandas.GeoDataFrame) -> None:
    ours = og.enclosed_tessellation(buildings, blocks, tolerance=0.05)
    theirs = momepy.enclosed_tessellation(buildings, blocks, n_jobs=1)
    alike(ours, theirs, buildings)
    assert ours["enclosure_index"].tolist() == theirs["enclosure_index"].tolist()
    for number, block in blocks.geometry.items():
        cells = ours[ours["enclosure_index"] == number]
        assert is_coverage(oblast.from_shapely(cells), block.area)


@needs_bubenec
def test_enclosed_tessellation_thresholds(buildings: geopandas.GeoDataFrame, blocks: geopandas.GeoDataFrame) -> None:
    named = blocks.set_index(pd.Index([f"b{i}" for i in range(len(blocks))], name="block"))
    for threshold in (None, 0.05, 0.6, 1.5):
        ours = og.enclosed_tessellation(buildings.geometry, named, threshold=threshold, tolerance=0.5)
        theirs = momepy.enclosed_tessellation(buildings.geometry, named, threshold=threshold, n_jobs=1, simplify=False)
        assert ours.index.tolist() == theirs.index.tolist(), threshold
        assert ours["block"].tolist() == theirs["block"].tolist()


def test_tessellations_share_an_index_and_refuse_what_momepy_refuses() -> None:
    rows = geopandas.GeoSeries(
        [shapely.box(0, 0, 2, 2), shapely.box(4, 0, 6, 2), shapely.box(8, 0, 10, 2)], index=[1, 0, 1]
    )
    cells = og.morphological_tessellation(rows)
    assert cells.index.tolist() == [0, 1]
    np.testing.assert_allclose(cells.area, [8, 12], atol=1e-3)
    covered = geopandas.GeoSeries([shapely.box(0, 0, 9, 9), shapely.box(2, 2, 4, 4)])
    assert og.morphological_tessellation(covered).index.tolist() == [0]
    with pytest.raises(ValueError, match="MultiIndex"):
        og.morphological_tessellation(rows.set_axis(pd.MultiIndex.from_arrays([[1, 2, 3], [1, 2, 3]])))
    with pytest.raises(ValueError, match="expected bounding_box"):
        og.morphological_tessellation(rows, "sphere")
    with pytest.raises(TypeError, match="unexpected keyword argument 'shrinkage'"):
        og.morphological_tessellation(rows, shrinkage=1)
    with pytest.raises(ValueError, match="in degrees"):
        og.morphological_tessellation(rows.set_crs(4326))
    assert og.enclosed_tessellation(rows[:0], rows[:0]).empty
