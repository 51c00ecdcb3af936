"""A picture of regions, for notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from oblast._regions import Regions

_MOST_VERTICES = 20_000


def _path(ring: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> str:
    return "M" + "L".join(f"{x:.6g} {y:.6g}" for x, y in ring) + "Z"


def svg_of(regions: Regions, size: int = 300) -> str:
    """An SVG of at most `size` pixels a side; y grows upwards. Of large regions every nth vertex is drawn."""
    points = regions.points
    finite = points[np.isfinite(points).all(axis=1)]
    if len(finite) == 0:
        return f'<svg xmlns="http://www.w3.org/2000/svg" width="{size}" height="20"></svg>'
    low, high = finite.min(axis=0), finite.max(axis=0)
    extent = np.maximum(high - low, max(float((high - low).max()), 1e-300) * 1e-3)
    scale = size / float(extent.max())
    step = max(1, len(points) // _MOST_VERTICES)
    drawn = np.nan_to_num((points - low) * [1, -1] * scale + [0, float(extent[1]) * scale])
    rings, polygons = regions.ring_offsets, regions.polygon_offsets
    paths = []
    for p in range(len(polygons) - 1):
        parts = (drawn[rings[r] : rings[r + 1]] for r in range(polygons[p], polygons[p + 1]))
        paths.append("".join(_path(part[::step] if len(part) > 3 * step else part) for part in parts))
    width, height = extent * scale
    shapes = "".join(f'<path d="{path}"/>' for path in paths)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="-1 -1 {width + 2:.6g} {height + 2:.6g}">'
        f'<g fill="#7fa8d1" fill-opacity="0.6" fill-rule="evenodd" stroke="#1f4e79">{shapes}</g></svg>'
    )
