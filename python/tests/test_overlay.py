"""The functions on small inputs whose answers are known."""

from __future__ import annotations

import numpy as np
import pytest

import oblast
from shapes import square, squares, tangle, with_hole

A, B = square(0, 0, 2), square(1, 1, 2)
ADJACENT = (
    [
        (-295.25030351249666, 4.236074061427525),
        (-295.08711234218333, -2.301948231163383),
        (-314.64218025800653, -2.7900491087570383),
        (-314.80537142831986, 3.7479731838338695),
    ],
    [
        (-275.69523559667346, 4.7241749390211805),
        (-275.53204442636013, -1.8138473535697273),
        (-295.08711234218333, -2.3019482311633825),
        (-295.25030351249666, 4.236074061427525),
    ],
)


@pytest.mark.parametrize(
    ("how", "area"),
    [("intersection", 1), ("union", 7), ("difference", 3), ("symmetric_difference", 6)],
)
def test_four_operations(how: str, area: float) -> None:
    r = oblast.overlay(A, B, how)
    assert r.area == area and len(r) == 1 and r == getattr(oblast, how)(A, B)
    assert oblast.check(r, canonical=True)


def test_unknown_names_are_errors() -> None:
    with pytest.raises(ValueError, match="how='erase'"):
        oblast.overlay(A, B, "erase")
    with pytest.raises(ValueError, match="engine 'best'"):
        oblast.overlay(A, B, engine="best")
    with pytest.raises(ValueError, match="fill rule 'full'"):
        oblast.overlay(A, B, fill_a="full")
    with pytest.raises(oblast.OblastError) as caught:
        oblast.overlay(A, B, threads=2000)
    assert caught.value.code == "bad_option"


def test_two_adjacent_quadrilaterals() -> None:
    """shapely#2368: GEOS 3.14 says 127.9."""
    a, b = (oblast.from_ragged(points, [0, 4]) for points in ADJACENT)
    assert oblast.union(a, b).area == pytest.approx(255.8622474, abs=1e-6)
    assert oblast.intersection(a, b).area == 0


def test_engines_and_threads_give_the_same_bytes() -> None:
    a, b = tangle(120, 1), tangle(120, 2)
    expected = oblast.overlay(a, b, "union")
    for engine in ("vatti", "skvortsov"):
        assert oblast.overlay(a, b, "union", engine=engine) == expected
    for threads in (1, 2, 7):
        assert oblast.overlay(a, b, "union", threads=threads) == expected


def test_fill_rules() -> None:
    twice = squares((0, 0), (1, 1))
    areas = {
        rule: oblast.union_all(twice, fill=rule).area
        for rule in ("polygons", "even_odd", "nonzero", "negative", ("at_least", 2))
    }
    assert list(areas.values()) == [7, 6, 7, 0, 1]


def test_minimal_and_touching() -> None:
    row = squares((0, 0), (2, 0))
    assert len(oblast.union_all(row).points) == 6
    assert len(oblast.union_all(row, minimal=True).points) == 4
    corner = oblast.union_all(squares((0, 0), (2, 2)), touching=True)
    assert oblast.check(corner, touching=True)


def test_errors_name_the_place() -> None:
    points = with_hole().points.copy()
    points[12, 1] = np.inf
    bad = oblast.from_ragged(points, [0, 4, 8, 11, 14], [0, 2, 3, 4], [0, 1, 1, 3])
    with pytest.raises(oblast.OblastError) as caught:
        oblast.union(A, bad)
    error = caught.value
    assert (error.code, error.operand, error.row, error.ring, error.vertex) == ("not_finite", 1, 2, 3, 1)
    with pytest.raises(oblast.OblastError) as caught:
        oblast.union_all(tangle(2000), most_bytes=1000)
    assert caught.value.code == "memory_limit"


def test_union_by_group() -> None:
    rows = squares((0, 0), (1, 1), (9, 9))
    assert [r.area for r in oblast.union_all(rows, by=["b", "b", "a"])] == [4, 7]
    dissolved = oblast.dissolve(rows, ["b", "b", "a"])
    assert dissolved.groups.tolist() == ["a", "b"] and dissolved.regions.area == 11
    with pytest.raises(ValueError, match="one group for each of 3 rows"):
        oblast.dissolve(rows, [1, 2])


def test_overlay_of_rows() -> None:
    layer, other = squares((0, 0), (1, 1)), squares((1, 1))
    rows = oblast.overlay_features(layer, other, "identity")
    found = {(int(i), int(j)): row.area for row, i, j in zip(*rows, strict=True)}
    assert found == {(0, 0): 1, (0, -1): 3, (1, 0): 4}
    with pytest.raises(ValueError, match="how='erase'"):
        oblast.overlay_features(layer, other, "erase")


def test_depth_and_partition() -> None:
    layer = squares((0, 0), (1, 1), (1, 1))
    depth = oblast.depth(layer)
    assert dict(zip(depth.depth.tolist(), [r.area for r in depth.regions], strict=True)) == {1: 3, 2: 3, 3: 1}
    assert oblast.depth(layer, by=[0, 1, 1]).depth.tolist() == [1, 2]
    parts = oblast.partition(layer, squares((1, 1)))
    sources = [
        list(zip(parts.layer[i:j].tolist(), parts.row[i:j].tolist(), strict=True))
        for i, j in zip(parts.source_offsets[:-1], parts.source_offsets[1:], strict=True)
    ]
    assert sources == [
        [(0, 0)],
        [(0, 0), (0, 1), (0, 2), (1, 0)],
        [(0, 1), (0, 2), (1, 0)],
    ]


def test_pairs_are_overlays() -> None:
    b = np.random.default_rng(5)
    a = squares(*b.integers(0, 20, (300, 2)).tolist())
    other = squares(*b.integers(0, 20, (300, 2)).tolist(), side=3)
    i, j = b.integers(0, 300, 2000), b.integers(0, 300, 2000)
    for how in ("intersection", "difference"):
        rows = oblast.overlay_pairs(a, other, i, j, how)
        assert len(rows) == 2000
        for k in range(0, 2000, 97):
            one = oblast.overlay(a[int(i[k])], other[int(j[k])], how)
            assert rows[k].points.tolist() == one.points.tolist()
        assert rows == oblast.overlay_pairs(a, other, i, j, how, threads=1)


def test_pairs_by_row() -> None:
    rows = squares((0, 0), (1, 1), (9, 9))
    assert [r.area for r in oblast.overlay_pairs(rows, B)] == [1, 4, 0]
    assert [r.area for r in oblast.overlay_pairs(rows, rows)] == [4, 4, 4]
    assert len(oblast.overlay_pairs(rows, rows[:0], [], [])) == 0
    with pytest.raises(ValueError, match="a has 2 rows"):
        oblast.overlay_pairs(rows[:2], rows)
    with pytest.raises(IndexError, match=r"j\[1\] is 3, but there are 3 rows"):
        oblast.overlay_pairs(rows, rows, [0, 0], [0, 3])
    with pytest.raises(ValueError, match="both i and j"):
        oblast.overlay_pairs(rows, rows, [0])


def test_pairs_name_the_row_of_an_error() -> None:
    points = np.concatenate([square(3 * i).points for i in range(600)])
    points[4 * 500] = np.nan
    bad = oblast.from_ragged(points, np.arange(601) * 4)
    with pytest.raises(oblast.OblastError) as caught:
        oblast.overlay_pairs(A, bad, np.zeros(600, int), np.arange(600))
    assert (caught.value.code, caught.value.operand, caught.value.row) == ("not_finite", 1, 500)


def test_repair() -> None:
    bow_tie = oblast.from_ragged([[0, 0], [2, 2], [2, 0], [0, 2], *square(7).points.tolist()], [0, 4, 8])
    rows = oblast.repair(bow_tie)
    assert [len(r.polygon_offsets) - 1 for r in rows] == [2, 1] and rows.area == 3
    assert oblast.check(rows)


def test_clip() -> None:
    rows = squares((0, 0), (1, 1), (9, 9))
    clipped = oblast.clip(rows, (0, 0, 1.5, 1.5))
    assert [r.area for r in clipped] == [2.25, 0.25, 0]
    assert [r.area for r in oblast.clip(rows, squares((0, 0), (0.5, 0)))] == [4, 1.5, 0]


def test_hull_and_triangles() -> None:
    assert oblast.hull(squares((0, 0), (3, 3))).area == 25 - 2 * 4.5
    t = oblast.triangulate(with_hole())
    corners = t.points[t.triangles]
    (ax, ay), (bx, by), (cx, cy) = (corners[:, k].T for k in range(3))
    areas = ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
    assert (areas > 0).all() and areas.sum() == pytest.approx(9.0)
    assert t.is_side.dtype == bool and len(t.polygon) == len(t.triangles)
    wide = oblast.triangulate(with_hole(), "convex_hull")
    assert len(wide.triangles) > len(t.triangles)


def test_check_finds_the_first_fault() -> None:
    assert oblast.check(with_hole().to_shapely()[0])
    report = oblast.check(squares((0, 0), (1, 1)))
    assert not report and report.kind == "edges_cross" and report.row == 0 and report.other[0] == 1
    clockwise = oblast.from_ragged(square().points[::-1], [0, 4])
    assert oblast.check(clockwise).kind == "wrong_side"
    turned = oblast.from_ragged(np.roll(square().points, 1, axis=0), [0, 4])
    assert oblast.check(turned) and not oblast.check(turned, canonical=True)


def test_locator() -> None:
    locator = oblast.Locator(with_hole())
    points = [[0.5, 0.5], [1.5, 1.5], [1, 1.5], [5.7, 5.2]]
    assert locator.locate(points).tolist() == [2, 0, 1, 2]
    assert locator.contains(points).tolist() == [True, False, False, True]
    with pytest.raises(oblast.OblastError) as caught:
        locator.locate([[0, 0], [np.nan, 0]])
    assert caught.value.vertex == 1


def test_statistics() -> None:
    with oblast.statistics() as s:
        oblast.intersection(A, B)
        oblast.union_all(tangle(100))
    oblast.intersection(A, B)
    assert s.calls == 2 and s.input_vertices == 108 and s.intersections >= 2
    assert s.resolved_polygons == 1 and s.rounds >= 1 and sum(s.seconds.values()) > 0 and "2 calls" in repr(s)


def test_workspace() -> None:
    workspace = oblast.Workspace()
    for _ in range(3):
        assert oblast.union(tangle(200), B, workspace=workspace) == oblast.union(tangle(200), B)
    assert workspace.kept_bytes > 0
    workspace.clear()
    assert workspace.kept_bytes == 0
