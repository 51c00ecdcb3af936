"""Regions: rows of polygons in four arrays."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from oblast import _core
from oblast._core import Arrays
from oblast._settings import settings_of
from oblast._svg import svg_of

__all__ = ["ArrowColumn", "Regions"]

Points = npt.NDArray[np.float64]
Offsets = npt.NDArray[np.int32]


class ArrowColumn:
    """A column in Arrow memory, for whatever reads the Arrow PyCapsule protocol; see `Regions.to_arrow`."""

    __slots__ = ("_core",)

    def __init__(self, column: _core.ArrowColumn) -> None:
        self._core = column

    def __arrow_c_schema__(self) -> object:
        return self._core.schema()

    def __arrow_c_array__(self, requested_schema: object = None) -> tuple[object, object]:
        return self._core.array()

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return self._core.stream()


class Regions:
    """Rows of polygons with holes, in four arrays. A row is any number of polygons, as a multipolygon is.

    Regions are immutable. `from_ragged`, `from_wkb`, `from_shapely` and `from_arrow` make them; functions return them.
    Row ``r`` has the polygons ``row_offsets[r]`` to ``row_offsets[r + 1] - 1``, a polygon has rings, and a ring has
    points. The first ring of a polygon of a result is its outer ring, counter-clockwise; the others are its holes,
    clockwise. A ring of a result does not repeat its first point at its end; rings of operands may.

    Attributes
    ----------
    points : ndarray of float64, shape (n, 2)
        A read-only view, as all four arrays: nothing is copied.
    ring_offsets, polygon_offsets, row_offsets : ndarray of int32
        Each begins with 0 and ends with the number of what it divides.

    Examples
    --------
    >>> import oblast
    >>> a = oblast.from_ragged([[0, 0], [4, 0], [4, 4], [0, 4]], [0, 4])
    >>> b = oblast.from_ragged([[2, 2], [6, 2], [6, 6], [2, 6]], [0, 4])
    >>> r = oblast.difference(a, b)
    >>> r
    <Regions: 1 row, 1 polygon, 1 ring, 6 points>
    >>> r.points.tolist()
    [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]]
    >>> r.area
    12.0
    """

    __slots__ = ("__weakref__", "_core", "_hash")

    _core: Arrays
    _hash: int | None

    def __init__(self) -> None:
        raise TypeError("make Regions by from_ragged, from_wkb, from_shapely or from_arrow")

    @classmethod
    def _of(cls, arrays: Arrays) -> Regions:
        made = object.__new__(cls)
        object.__setattr__(made, "_core", arrays)
        object.__setattr__(made, "_hash", None)
        return made

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("Regions are immutable")

    @property
    def points(self) -> Points:
        """The vertices, shape (n, 2). A view."""
        return self._core.points

    @property
    def ring_offsets(self) -> Offsets:
        """Where each ring begins in `points`. A view."""
        return self._core.ring_offsets

    @property
    def polygon_offsets(self) -> Offsets:
        """Where each polygon begins in the rings. A view."""
        return self._core.polygon_offsets

    @property
    def row_offsets(self) -> Offsets:
        """Where each row begins in the polygons. A view."""
        return self._core.row_offsets

    @property
    def area(self) -> float:
        """The sum of the areas of all polygons, in squared units of the coordinates.

        A place that two polygons cover counts twice: unite operands first. Cost: linear.
        """
        with settings_of(counted=False) as settings:
            return _core.area(self._core, settings)

    @property
    def bounds(self) -> tuple[float, float, float, float] | None:
        """``(x0, y0, x1, y1)``, or None if there are no points. Cost: linear."""
        with settings_of(counted=False) as settings:
            return _core.bounds(self._core, settings)

    def __len__(self) -> int:
        """Return the number of rows."""
        return self._core.row_count()

    def __bool__(self) -> bool:
        """Return whether there are points: regions of rows without polygons are false."""
        return len(self.points) > 0

    def __getitem__(self, rows: int | slice | Sequence[int] | npt.NDArray[Any]) -> Regions:
        """Return the row of an index, or the rows of a slice, of indices or of a mask; copied."""
        if isinstance(rows, int | np.integer):
            if not -len(self) <= rows < len(self):
                raise IndexError(f"row {rows} of {len(self)}")
            return self._take(np.array([rows % len(self)], dtype=np.int64))
        chosen = np.arange(len(self), dtype=np.int64)[rows]
        return self._take(chosen)

    def _take(self, rows: npt.NDArray[np.int64]) -> Regions:
        return Regions._of(self._core.take(np.ascontiguousarray(rows)))

    def __iter__(self) -> Iterator[Regions]:
        for row in range(len(self)):
            yield self[row]

    def explode(self) -> Regions:
        """Return the same polygons, each as a row. Nothing is copied."""
        count = len(self.polygon_offsets)
        rows = np.arange(count, dtype=np.int32)
        return Regions._of(_core.arrays(self.points, self.ring_offsets, self.polygon_offsets, rows))

    def __eq__(self, other: object) -> bool:
        """Return whether all four arrays are the same. -0.0 equals 0.0."""
        if not isinstance(other, Regions):
            return NotImplemented
        return self._core.same(other._core)

    def __hash__(self) -> int:
        value = self._hash
        if value is None:
            plain = self.points + 0.0  # -0.0 becomes 0.0
            value = hash((plain.tobytes(), self.ring_offsets.tobytes(), self.row_offsets.tobytes()))
            object.__setattr__(self, "_hash", value)
        return value

    def __repr__(self) -> str:
        def count(number: int, name: str) -> str:
            return f"{number} {name}{'' if number == 1 else 's'}"

        return (
            f"<Regions: {count(len(self), 'row')}, {count(len(self.polygon_offsets) - 1, 'polygon')}, "
            f"{count(len(self.ring_offsets) - 1, 'ring')}, {count(len(self.points), 'point')}>"
        )

    def _repr_svg_(self) -> str:
        return svg_of(self)

    def __reduce__(self) -> tuple[object, ...]:
        arrays = (self.points, self.ring_offsets, self.polygon_offsets, self.row_offsets)
        return _unpickle, tuple(np.array(array) for array in arrays)

    def to_wkb(self, *, threads: int | None = None) -> npt.NDArray[np.object_]:
        """Write a row as one geometry: a Polygon if it has one polygon, else a MultiPolygon.

        Returns
        -------
        ndarray of bytes, shape (rows,)
            Little-endian WKB; rings are closed. Cost: linear, on all cores.

        Examples
        --------
        >>> import oblast
        >>> square = oblast.from_ragged([[0, 0], [1, 0], [1, 1], [0, 1]], [0, 4])
        >>> oblast.from_wkb(square.to_wkb()).area
        1.0
        """
        with settings_of(threads, counted=False) as settings:
            written = _core.to_wkb(self._core, settings)
        array = np.empty(len(written), dtype=object)
        array[:] = written
        return array

    def to_shapely(self) -> npt.NDArray[np.object_]:
        """Make a shapely geometry of each row: a Polygon, a MultiPolygon, or an empty Polygon.

        Returns
        -------
        ndarray of shapely geometries, shape (rows,)
        """
        from oblast._shapely import to_shapely

        return to_shapely(self)

    def to_arrow(
        self,
        encoding: Literal["multipolygon", "polygon"] = "multipolygon",
        coordinates: Literal["interleaved", "separate"] = "interleaved",
    ) -> ArrowColumn:
        """Write a GeoArrow column, for whatever reads the Arrow PyCapsule protocol.

        Points are copied, because rings are closed in GeoArrow. Regions themselves speak the protocol, too, and then
        give an interleaved multipolygon.

        Parameters
        ----------
        encoding : {"multipolygon", "polygon"}
            For "polygon" each row must have at most one polygon, else ValueError.
        coordinates : {"interleaved", "separate"}
        """
        if encoding not in ("multipolygon", "polygon"):
            raise ValueError(f"encoding {encoding!r}: expected 'multipolygon' or 'polygon'")
        if coordinates not in ("interleaved", "separate"):
            raise ValueError(f"coordinates {coordinates!r}: expected 'interleaved' or 'separate'")
        column = _core.arrow_column(self._core, encoding == "multipolygon", coordinates == "interleaved")
        return ArrowColumn(column)

    def __arrow_c_schema__(self) -> object:
        return self[:0].to_arrow().__arrow_c_schema__()

    def __arrow_c_array__(self, requested_schema: object = None) -> tuple[object, object]:
        return self.to_arrow().__arrow_c_array__()

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return self.to_arrow().__arrow_c_stream__()


def _unpickle(points: Points, rings: Offsets, polygons: Offsets, rows: Offsets) -> Regions:
    return Regions._of(_core.arrays(points, rings, polygons, rows))
