"""Buffer zones beside shapely's, and the drop-in for GeoSeries.buffer."""

from __future__ import annotations

import math
import warnings
from typing import Any

import geopandas
import numpy as np
import pandas as pd
import pytest
import shapely

import oblast
import oblast.geopandas as og
from shapes import square, squares, tangle, with_hole

LINE = shapely.LineString([(0, 0), (100, 0), (100, 50), (30, 20)])
POINT = shapely.Point(200, 0)
AREA = shapely.Point(0, 200).buffer(30).difference(shapely.box(-5, 195, 5, 205))
ALL = shapely.GeometryCollection([AREA, shapely.GeometryCollection([LINE, POINT]), shapely.MultiPoint([(9, 90)])])
LINES = shapely.MultiLineString([LINE, [(5, -50), (6, -50)]])
SHAPES = [LINE, POINT, AREA, ALL, LINES, shapely.LinearRing(AREA.exterior)]
MODES: tuple[Any, ...] = ("nearest", "inside", "outside")


def ring_bounds(geometry: Any, distance: float, tolerance: float) -> tuple[float, float]:
    """The areas of the zones that are as small and as large as the tolerance allows."""
    return tuple(geometry.buffer(distance * factor, quad_segs=500).area for factor in (1 - tolerance, 1 + tolerance))


def ragged(regions: oblast.Regions) -> tuple[Any, ...]:
    """Ragged arrays."""
    return regions.points, regions.ring_offsets, regions.polygon_offsets, regions.row_offsets


@pytest.mark.parametrize("tolerance", [0.2, 0.01, 1e-5])
@pytest.mark.parametrize("geometry", SHAPES, ids=lambda g: g.geom_type)
def test_areas_are_within_the_tolerance(geometry: Any, tolerance: float) -> None:
    for distance in (0.5, 7.0, 300.0):
        smallest, largest = ring_bounds(geometry, distance, tolerance)
        exact = geometry.buffer(distance, quad_segs=500).area
        area = {mode: oblast.buffer(geometry, distance, tolerance=tolerance, mode=mode).area for mode in MODES}
        slack = 1e-5 * largest  # of shapely's circles of 500 segments
        assert smallest - slack <= area["inside"] <= exact + slack
        assert exact - slack <= area["outside"] <= largest + slack
        assert smallest - slack <= area["nearest"] <= largest + slack


def test_negative_distances() -> None:
    shrunk = oblast.buffer([AREA, LINE, POINT], -5, tolerance=1e-4)
    assert shrunk.area == pytest.approx(AREA.buffer(-5, quad_segs=200).area, rel=1e-3)
    assert len(oblast.buffer(AREA, -100).points) == 0


def test_joins_caps_sides() -> None:
    assert oblast.buffer(square(side=10), 1, join="mitre").area == 144
    assert oblast.buffer(square(side=10), 1, join="bevel").area == 142
    road = shapely.LineString([(0, 0), (100, 0)])
    assert oblast.buffer(road, 2, cap="flat").area == 400
    assert oblast.buffer(road, 2, cap="square").area == 416
    assert oblast.buffer(road, 2, side="left").bounds == (0, 0, 100, 2)
    assert oblast.buffer(road, 2, side="right").bounds == (0, -2, 100, 0)
    spike = oblast.from_ragged([[0, 0], [100, 0], [0, 1]], [0, 3])
    assert oblast.buffer(spike, 1, join="mitre", mitre_limit=50).area > oblast.buffer(spike, 1, join="mitre").area


def test_rows_are_each_by_itself() -> None:
    rows = oblast.buffer(squares((0, 0), (1, 1)), [1, 2], join="mitre", by_row=True)
    assert [row.area for row in rows] == [16, 36]
    mixed = oblast.buffer([POINT, None, AREA, LINE], 3, by_row=True)
    assert len(mixed) == 4 and not mixed[1]
    for row, geometry in zip(mixed, [POINT, None, AREA, LINE], strict=True):
        assert geometry is None or row == oblast.buffer(geometry, 3)


def test_united_rows_are_the_union() -> None:
    rows = oblast.buffer(squares((0, 0), (1, 1)), [1, 2], join="mitre", by_row=True)
    assert oblast.buffer(squares((0, 0), (1, 1)), [1, 2], join="mitre") == oblast.union_all(rows)


@pytest.mark.parametrize("given", [lambda g: g, geopandas.GeoSeries, shapely.to_wkb, lambda g: list(shapely.to_wkb(g))])
def test_operands(given: Any) -> None:
    geometries = np.array([AREA, LINE, POINT, ALL], dtype=object)
    assert oblast.buffer(given(geometries), 3) == oblast.buffer(list(geometries), 3)


def test_polygons_in_any_form() -> None:
    regions = with_hole()
    expected = oblast.buffer(regions, 0.25)
    for given in (regions.to_shapely(), regions.to_wkb(), regions.to_arrow(), ragged(regions)):
        assert oblast.buffer(given, 0.25) == expected
    assert oblast.buffer(shapely.to_wkb(AREA), 3) == oblast.buffer(AREA, 3)


def test_errors() -> None:
    with pytest.raises(ValueError, match="join='sharp': expected one of round, mitre, bevel"):
        oblast.buffer(square(), 1, join="sharp")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="one for each of 1 rows"):
        oblast.buffer(square(), [1, 2])
    with pytest.raises(oblast.OblastError, match="tolerance"):
        oblast.buffer(square(), 1, tolerance=3)
    with pytest.raises(oblast.OblastError, match="not a finite number"):
        oblast.buffer(square(), math.nan)
    with pytest.raises(oblast.OblastError) as raised:
        oblast.buffer([POINT, shapely.LineString([(0, 0), (1, math.inf)])], 1)
    assert (raised.value.operand, raised.value.row, raised.value.vertex) == (1, 1, 1)
    with pytest.raises(oblast.OblastError, match="limit"):
        oblast.buffer(tangle(200), 1, most_bytes=1000)
    with pytest.raises(TypeError, match="no operand"):
        oblast.buffer(7, 1)


def test_z_is_left_out_with_a_warning() -> None:
    with pytest.warns(UserWarning, match="Z"):
        zone = oblast.buffer(shapely.Point(1, 2, 3), 1)
    assert zone == oblast.buffer(shapely.Point(1, 2), 1)


def test_progress_ends_the_call_and_statistics_count() -> None:
    lines = [shapely.LineString(tangle(3000, seed).points) for seed in range(4)]

    def stop(fraction: float) -> None:
        raise TimeoutError

    with pytest.raises(TimeoutError):
        oblast.buffer(lines, 1e-4, progress=stop)
    with oblast.statistics() as counted:
        oblast.buffer(POINT, 1)
    assert counted.calls == 1 and counted.output_vertices > 8


SERIES = geopandas.GeoSeries(
    [AREA, LINE, POINT, None, shapely.Polygon(), ALL], index=list("uvwxyz"), crs=3857, name="shape"
)


def beside(ours: geopandas.GeoSeries, theirs: geopandas.GeoSeries, part: float) -> None:
    """The same index, CRS and missing rows; areas within this part of theirs."""
    assert ours.index.equals(theirs.index) and ours.crs == theirs.crs and type(ours) is type(theirs)
    assert ours.name == theirs.name
    assert (ours.isna() == theirs.isna()).all()
    assert (ours.is_empty == theirs.is_empty).all()
    np.testing.assert_allclose(ours.area, theirs.area, rtol=part)


@pytest.mark.parametrize("resolution", [1, 4, 16, 100])
def test_drop_in(resolution: int) -> None:
    oblast.fallbacks(clear=True)
    part = 2 * og._buffer.tolerance_of(resolution) + 1e-9
    for distance in (3, -2.0, 0, [1, 2, 3, 4, 5, 6], np.arange(6.0)):
        beside(og.buffer(SERIES, distance, resolution), SERIES.buffer(distance, resolution), part)
    by_index = pd.Series(range(6), index=list("uvwxyz"))
    beside(og.buffer(SERIES, by_index, quad_segs=resolution), SERIES.buffer(by_index, resolution), part)
    assert oblast.fallbacks() == {}


def test_the_least_resolution_is_an_octagon() -> None:
    point = geopandas.GeoSeries([POINT])
    octagon, diamond = og.buffer(point, 1, 1), point.buffer(1, 1)
    assert shapely.get_num_coordinates(octagon[0]) == 9 and shapely.get_num_coordinates(diamond[0]) == 5
    assert octagon.contains(diamond.buffer(-1e-9))[0] and octagon.area[0] == pytest.approx(2 * 2**0.5)
    assert og.buffer(point, 1, 1, cap_style="square").area[0] == pytest.approx(4)


@pytest.mark.parametrize("join", ["round", "mitre", "bevel"])
@pytest.mark.parametrize("cap", ["round", "flat", "square"])
def test_drop_in_styles(join: str, cap: str) -> None:
    series = geopandas.GeoSeries([shapely.box(0, 0, 9, 9), LINE, POINT])
    ours = og.buffer(series, 2, cap_style=cap, join_style=join)
    beside(ours, series.buffer(2, cap_style=cap, join_style=join), 0.005)


def test_drop_in_single_sided() -> None:
    series = geopandas.GeoSeries([LINE, LINES, LINE, POINT])
    distances = [2, 2, -2, 2]
    theirs = series.buffer(distances, single_sided=True)
    ours = og.buffer(series, distances, single_sided=True)
    beside(ours, theirs, 0.01)
    assert not ours.iloc[0].equals(ours.iloc[2])


def test_drop_in_passes_on() -> None:
    oblast.fallbacks(clear=True)
    series = geopandas.GeoSeries([ALL, POINT])
    og.buffer(series, 1, single_sided=True)
    og.buffer(series, [1, np.nan])
    assert {(f.function, f.reason) for f in oblast.fallbacks(clear=True)} == {
        ("buffer", "areas or collections with single_sided"),
        ("buffer", "distance"),
    }
    with pytest.raises(ValueError, match="Index values"):
        og.buffer(series, pd.Series([1, 2], index=[5, 6]))


def test_drop_in_warns_of_degrees_and_is_installed() -> None:
    series = geopandas.GeoSeries([POINT], crs=4326)
    with pytest.warns(UserWarning, match="geographic CRS"):
        og.buffer(series, 0.1)
    frame = geopandas.GeoDataFrame({"a": [1]}, geometry=[POINT], crs=3857)
    with og.install(), warnings.catch_warnings():
        warnings.simplefilter("error")
        assert frame.buffer(5).iloc[0].equals(og.buffer(frame, 5).iloc[0])
        assert SERIES.buffer(3, 4).equals(og.buffer(SERIES, 3, 4))
