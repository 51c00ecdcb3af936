"""Regions as a container: views, equality, rows, pickling, pictures."""

from __future__ import annotations

import pickle
from xml.dom import minidom

import numpy as np
import pytest

import oblast
from shapes import square, squares, with_hole


def address(array: np.ndarray) -> int:
    return array.__array_interface__["data"][0]


def test_arrays_are_viewed_and_not_copied() -> None:
    points = np.array([[0.0, 0], [1, 0], [1, 1]])
    offsets = np.array([0, 3], dtype=np.int32)
    regions = oblast.from_ragged(points, offsets)
    assert address(regions.points) == address(points)
    assert address(regions.ring_offsets) == address(offsets)


def test_results_are_viewed_and_read_only() -> None:
    r = oblast.union(square(), square(5))
    assert address(r.points) == address(r.points)
    assert r.points.shape == (8, 2) and r.points.dtype == np.float64
    for array in (r.points, r.ring_offsets, r.polygon_offsets, r.row_offsets):
        assert not array.flags.writeable
    with pytest.raises(AttributeError, match="immutable"):
        r.points = 1


def test_views_outlive_their_regions() -> None:
    points = oblast.union(square(), square(5)).points
    oblast.union(square(1), square(7))
    assert points.tolist()[0] == [0.0, 0.0] and len(points) == 8


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([[0, 0, 0]], [0, 1]), "shape"),
        (([[0, 0]], [0, 2]), "ring_offsets must end with 1"),
        (([[0, 0]], [1, 1]), "ring_offsets must begin with 0"),
        (([[0, 0]] * 4, [0, 3, 2, 4]), "ring_offsets decrease at index 2"),
        (([[0, 0]], [0, 1], [0, 2]), "polygon_offsets must end with 1"),
        (([[0, 0]], [0, 1], [0, 1], [0, 3]), "row_offsets must end with 1"),
        (([[0, 0]], [0.5, 1]), "whole numbers"),
        (([[0, 0]], [0, 2**40]), "2\\^31"),
    ],
)
def test_arrays_that_do_not_fit_are_errors(arguments: tuple, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        oblast.from_ragged(*arguments)


def test_equality_and_hash_are_of_values() -> None:
    assert square() == square() and hash(square()) == hash(square())
    assert square() != square(1) and square() != 1
    negative = oblast.from_ragged([[-0.0, 0], [1, 0], [1, 1], [0, 1]], [0, 4])
    assert negative == square() and hash(negative) == hash(square())
    assert len({square(), square(), square(2)}) == 2


def test_rows() -> None:
    rows = with_hole()
    assert len(rows) == 3 and [len(r.polygon_offsets) - 1 for r in rows] == [1, 0, 2]
    assert rows[-1] == rows[2] and rows[-1].area == 1.0
    assert rows[1:] == rows[[1, 2]] == rows[np.array([False, True, True])]
    assert rows[[2, 0]].points.tolist()[0] == [5.0, 5.0]
    assert not rows[1] and rows[0]
    with pytest.raises(IndexError, match="row 3 of 3"):
        rows[3]
    assert len(rows.explode()) == 3 and address(rows.explode().points) == address(rows.points)


def test_pickle() -> None:
    assert pickle.loads(pickle.dumps(with_hole())) == with_hole()
    error = pickle.loads(pickle.dumps(oblast.OblastError("what", "bad_option", row=3)))
    assert (str(error), error.code, error.row) == ("what", "bad_option", 3)


def test_repr_and_picture() -> None:
    assert repr(with_hole()) == "<Regions: 3 rows, 3 polygons, 4 rings, 14 points>"
    picture = minidom.parseString(with_hole()._repr_svg_())
    assert [p.getAttribute("d").count("M") for p in picture.getElementsByTagName("path")] == [2, 1, 1]
    assert "<svg" in square()[:0]._repr_svg_()


def test_measures() -> None:
    assert squares((0, 0), (5, 5)).area == 8.0
    assert squares((0, 0), (5, 5)).bounds == (0.0, 0.0, 7.0, 7.0)
    assert square()[:0].bounds is None and square()[:0].area == 0.0
