"""Do rows meet a mask in lines or points that are no border of an area in common? Decided without tolerances.

Rows and mask are overlaid. In the result, borders that rows share are the same vertices, bit for bit, and edges of
different rows are identical or meet at their ends. So a place that two parts have in common is a vertex or an edge of
both, and comparing vertices and edges decides.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from oblast._regions import Regions
from oblast._rows import OverlaidRows, overlay_features

Indices = npt.NDArray[np.int64]
Flags = npt.NDArray[np.bool_]


def touches_outside(rows: Regions, mask: Regions) -> Flags:
    """Return for each row whether it meets the mask outside the closure of the area that they have in common.

    Parameters
    ----------
    rows : Regions
    mask : Regions
        One row.

    Returns
    -------
    ndarray of bool, shape (len(rows),)
        True, too, for a row that has no area at all. Cost: an overlay, and sorting its vertices.
    """
    parts = overlay_features(rows, mask, "union")
    found = np.ones(len(rows), dtype=bool)
    found[parts.a[parts.a >= 0]] = False
    vertices, edges, piece = _numbered(parts)
    row, in_mask = parts.a[piece], parts.b[piece] >= 0
    for numbers, beyond in ((vertices, vertices), edges):
        found[_beyond_common_area(row, in_mask, numbers, beyond)] = True
    return found


def _beyond_common_area(row: Indices, in_mask: Flags, numbers: Indices, beyond: Indices) -> Indices:
    """Rows of which a part outside the mask has an element that is the mask's, and not one of the common area.

    `beyond` is the element as seen from its other side: the same vertex, or the edge in the other direction.
    """
    count = int(numbers.max(initial=-1)) + 1
    of_mask = np.zeros(count, dtype=bool)
    of_mask[numbers[in_mask]] = True
    outside = ~in_mask & (row >= 0) & (beyond >= 0)
    outside[outside] = of_mask[beyond[outside]]
    common = in_mask & (row >= 0)
    covered = np.isin(row[outside] * count + beyond[outside], row[common] * count + numbers[common])
    return row[outside][~covered]


def _numbered(parts: OverlaidRows) -> tuple[Indices, tuple[Indices, Indices], Indices]:
    """Number equal vertices alike, and equal directed edges; an edge begins at its vertex.

    Returns the numbers of the vertices; those of the edges, and of the same edges in the other direction (-1: there
    is none); and the part that each vertex belongs to.
    """
    regions = parts.regions
    rings = regions.ring_offsets.astype(np.int64)
    sizes = np.diff(rings)
    polygon = np.repeat(np.arange(len(regions.polygon_offsets) - 1), np.diff(regions.polygon_offsets))
    part = np.repeat(np.arange(len(regions)), np.diff(regions.row_offsets))
    _, vertices = np.unique(regions.points.view(np.complex128).ravel(), return_inverse=True)
    following = np.arange(1, len(vertices) + 1)
    following[rings[1:] - 1] = rings[:-1]
    count = len(vertices)
    ends = vertices[following]
    different, edges = np.unique(vertices * count + ends, return_inverse=True)
    turned = ends * count + vertices
    place = np.minimum(np.searchsorted(different, turned), max(len(different) - 1, 0))
    reverse = np.where(different[place] == turned, place, -1) if count else place
    return vertices, (edges, reverse), np.repeat(part[polygon], sizes)
