"""WKB, shapely and Arrow, in and out."""

from __future__ import annotations

import numpy as np
import pyarrow as pa
import pytest
import shapely

import oblast
from shapes import square, squares, with_hole

INTERLEAVED = pa.list_(pa.field("xy", pa.float64()), 2)
SEPARATE = pa.struct([("x", pa.float64()), ("y", pa.float64())])
RINGS = [[[0, 0], [3, 0], [3, 3], [0, 3], [0, 0]], [[1, 1], [1, 2], [2, 2], [2, 1], [1, 1]]]
TRIANGLE = [[[5, 5], [6, 5], [6, 6], [5, 5]]]


def separate(rows: list) -> list:
    """The same rows with a dictionary a point."""
    if isinstance(rows[0], int):
        return {"x": rows[0], "y": rows[1]}
    return [None if row is None else separate(row) if row else [] for row in rows]


def address(array: np.ndarray) -> int:
    return array.__array_interface__["data"][0]


def test_wkb_both_ways() -> None:
    rows = with_hole()
    assert oblast.from_wkb(rows.to_wkb()) == rows
    assert shapely.from_wkb(rows.to_wkb())[0].equals_exact(rows.to_shapely()[0])
    assert oblast.from_wkb([None, rows.to_wkb()[0]])[1] == rows[0]


def test_wkb_of_many_rows_on_any_number_of_threads() -> None:
    rows = squares(*((3.0 * i, 0.0) for i in range(5000)))
    for threads in (None, 1, 3):
        assert oblast.from_wkb(rows.to_wkb(threads=threads), threads=threads) == rows


def test_wkb_errors_name_the_row_and_the_byte() -> None:
    good = square().to_wkb()[0]
    with pytest.raises(oblast.OblastError) as caught:
        oblast.from_wkb([good] * 700 + [good[:30]])
    assert (caught.value.code, caught.value.row) == ("bad_wkb", 700)
    assert caught.value.byte is not None
    with pytest.raises(TypeError, match="geometry 1 is neither bytes nor None"):
        oblast.from_wkb([good, "text"])


def test_shapely_both_ways() -> None:
    geometries = with_hole().to_shapely()
    assert [g.geom_type for g in geometries] == ["Polygon", "Polygon", "MultiPolygon"]
    assert geometries[1].is_empty and geometries[0].area == 8
    again = oblast.from_shapely(geometries)
    assert len(again) == 3 and again.area == with_hole().area
    assert oblast.from_shapely([None, shapely.box(0, 0, 1, 1)]).row_offsets.tolist() == [0, 0, 1]
    assert len(oblast.from_shapely([])) == 0 and len(oblast.from_shapely([shapely.Polygon()])) == 1
    with pytest.raises(TypeError, match="row 1 is a Point"):
        oblast.from_shapely([shapely.box(0, 0, 1, 1), shapely.Point(0, 0)])


def test_what_happens_to_z() -> None:
    solid = shapely.Polygon([(0, 0, 5), (1, 0, 5), (1, 1, 5)])
    for convert, given in ((oblast.from_shapely, solid), (oblast.from_wkb, shapely.to_wkb(solid, output_dimension=3))):
        with pytest.warns(UserWarning, match="left out"):
            convert(given)
        with pytest.raises(ValueError, match="Z or M"):
            convert(given, z="error")
        assert convert(given, z="drop").area == 0.5
    with pytest.raises(ValueError, match="z='no'"):
        oblast.from_shapely(solid, z="no")


@pytest.mark.parametrize("large", [False, True])
@pytest.mark.parametrize("points", [INTERLEAVED, SEPARATE])
def test_arrow_encodings(points: pa.DataType, large: bool) -> None:
    listed = pa.large_list if large else pa.list_
    adapt = separate if points is SEPARATE else list
    polygons = pa.array(adapt([RINGS, None, TRIANGLE, []]), listed(listed(points)))
    rows = oblast.from_arrow(polygons)
    assert rows.row_offsets.tolist() == [0, 1, 1, 2, 2] and rows.area == 8.5
    multi = pa.array(adapt([[RINGS, TRIANGLE], None, []]), listed(listed(listed(points))))
    rows = oblast.from_arrow(multi)
    assert rows.row_offsets.tolist() == [0, 2, 2, 2] and rows.area == 8.5


@pytest.mark.parametrize("points", [INTERLEAVED, SEPARATE])
def test_arrow_slices_and_chunks(points: pa.DataType) -> None:
    adapt = separate if points is SEPARATE else list
    column = pa.array(adapt([RINGS, None, TRIANGLE, TRIANGLE]), pa.list_(pa.list_(points)))
    assert oblast.from_arrow(column.slice(2)).area == 1.0
    assert oblast.from_arrow(column.slice(1, 2)).row_offsets.tolist() == [0, 0, 1]
    chunks = pa.chunked_array([column.slice(2, 1), column, column.slice(1, 1)])
    assert len(oblast.from_arrow(chunks)) == 6 and oblast.from_arrow(chunks).area == 9.5
    assert len(oblast.from_arrow(column.slice(0, 0))) == 0
    assert len(oblast.from_arrow(pa.chunked_array([], column.type))) == 0


def test_interleaved_arrow_is_viewed() -> None:
    column = pa.array([RINGS, TRIANGLE], pa.list_(pa.list_(INTERLEAVED)))
    numbers = column.flatten().flatten().flatten()
    assert address(oblast.from_arrow(column).points) == numbers.buffers()[1].address
    sliced = oblast.from_arrow(column.slice(1))
    assert address(sliced.points) == numbers.buffers()[1].address + 10 * 16
    del column, numbers
    assert sliced.area == 0.5


def test_a_null_with_items_has_none() -> None:
    rings = pa.array([TRIANGLE[0], TRIANGLE[0]], pa.list_(INTERLEAVED))
    hidden = pa.ListArray.from_arrays(pa.array([0, 1, 2], pa.int32()), rings, mask=pa.array([True, False]))
    rows = oblast.from_arrow(hidden)
    assert rows.row_offsets.tolist() == [0, 0, 1] and rows.area == 0.5


def test_arrow_with_z() -> None:
    column = pa.array([[[[0, 0, 9], [1, 0, 9], [1, 1, 9]]]], pa.list_(pa.list_(pa.list_(pa.float64(), 3))))
    assert oblast.from_arrow(column, z="drop").area == 0.5
    with pytest.warns(UserWarning, match="left out"):
        oblast.from_arrow(column)


def test_tables_and_wkb_columns() -> None:
    wkb = pa.field("shape", pa.binary(), metadata={"ARROW:extension:name": "geoarrow.wkb"})
    column = pa.array([*square().to_wkb(), None, *square(2).to_wkb()])
    table = pa.table([pa.array([1, 2, 3]), column], schema=pa.schema([("id", pa.int64()), wkb]))
    for data in (table, table.to_batches()[0], table.slice(0)):
        assert oblast.from_arrow(data).row_offsets.tolist() == [0, 1, 1, 2]
    assert oblast.from_arrow(table.slice(1)).row_offsets.tolist() == [0, 0, 1]
    assert oblast.from_arrow(table.to_batches()[0].slice(2)) == square(2)
    assert oblast.from_arrow(table, column="shape").area == 2.0
    with pytest.raises(TypeError, match="not a column of polygons"):
        oblast.from_arrow(table, column="id")
    with pytest.raises(TypeError, match="no column name"):
        oblast.from_arrow(table, column="name")
    twice = table.append_column(wkb.with_name("other"), column)
    with pytest.raises(TypeError, match="several geometry columns"):
        oblast.from_arrow(twice)


@pytest.mark.parametrize("coordinates", ["interleaved", "separate"])
def test_arrow_out(coordinates: str) -> None:
    rows = with_hole()
    column = rows.to_arrow("multipolygon", coordinates)
    array = pa.array(column)
    array.validate(full=True)
    field = pa.field(column)
    assert field.metadata[b"ARROW:extension:name"] == b"geoarrow.multipolygon"
    assert oblast.union_all(array) == oblast.union_all(rows)
    assert oblast.from_arrow(column).row_offsets.tolist() == rows.row_offsets.tolist()
    assert pa.chunked_array(column).chunk(0).equals(array)
    single = pa.array(rows[:2].to_arrow("polygon", coordinates))
    single.validate(full=True)
    assert [len(row) for row in single.to_pylist()] == [2, 0]
    with pytest.raises(ValueError, match="row 2 has several polygons"):
        rows.to_arrow("polygon")


def test_regions_speak_arrow() -> None:
    rows = with_hole()
    assert len(pa.array(rows)) == len(pa.chunked_array(rows)) == 3
    ring = pa.array(rows).to_pylist()[0][0][0]
    assert ring[0] == ring[-1] and len(ring) == 5


def test_capsules_are_read_once() -> None:
    schema, array = pa.array([RINGS], pa.list_(pa.list_(INTERLEAVED))).__arrow_c_array__()

    class Given:
        def __arrow_c_array__(self, requested_schema: object = None) -> tuple:
            return schema, array

    oblast.from_arrow(Given())
    with pytest.raises(ValueError, match="used before"):
        oblast.from_arrow(Given())


def test_operands_of_any_kind() -> None:
    rows = squares((0, 0), (1, 1))
    kinds = [
        rows,
        (rows.points, rows.ring_offsets),
        rows.to_shapely(),
        list(rows.to_shapely()),
        rows.to_wkb(),
        list(rows.to_wkb()),
        pa.array(rows),
        rows.to_arrow(),
    ]
    for kind in kinds:
        assert oblast.union_all(kind) == oblast.union_all(rows)
    with pytest.raises(TypeError, match="int is no operand"):
        oblast.union_all(3)
