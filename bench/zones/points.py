"""Tools for the zones of points that are called from Python, and what is wrong with cells of points."""

from itertools import chain

import numpy as np
import oblast
import shapely
from scipy.spatial import Voronoi


def tools(sites, frame):
    """By name: a call that gives the cells, clipped to the frame."""
    return {
        "oblast in Python": lambda: oblast.zones(sites, frame).regions.to_shapely(),
        "shapely.voronoi_polygons": lambda: by_shapely(sites, frame),
        "scipy.spatial.Voronoi": lambda: by_scipy(sites, frame),
    }


def clipped(cells, frame):
    """Only cells that leave the frame are cut."""
    shapely.prepare(frame)
    out = ~shapely.covers(frame, cells)
    cells[out] = shapely.intersection(cells[out], frame)
    return cells


def by_shapely(sites, frame):
    return clipped(shapely.get_parts(shapely.voronoi_polygons(shapely.multipoints(sites), extend_to=frame)), frame)


def by_scipy(sites, frame):
    """Four points far away make the cells of all others finite."""
    x0, y0, x1, y1 = frame.bounds
    far = 8 * max(x1 - x0, y1 - y0)
    others = [[x0 - far, y0], [x1 + far, y1], [x1, y0 - far], [x0, y1 + far]]
    diagram = Voronoi(np.concatenate([sites, others]))
    regions = [diagram.regions[region] for region in diagram.point_region[: len(sites)]]
    sizes = np.fromiter(map(len, regions), np.int64, len(regions))
    vertices = np.fromiter(chain.from_iterable(regions), np.int64, sizes.sum())
    ends = np.cumsum(sizes)
    order = np.insert(vertices, ends, vertices[ends - sizes])  # each ring closed by its first vertex
    offsets = np.concatenate([[0], ends + np.arange(1, len(ends) + 1)])
    each = np.arange(len(offsets))
    return clipped(
        shapely.from_ragged_array(shapely.GeometryType.POLYGON, diagram.vertices[order], (offsets, each)), frame
    )


def faults(sites, cells, frame):
    """As faults.of. Cells need not be in the order of the sites."""
    cells = cells[~shapely.is_empty(cells)]
    valid = shapely.is_valid(cells)
    regions = oblast.from_shapely(cells)
    depth = oblast.depth(regions)
    twice = [row for row, times in zip(depth.regions, depth.depth, strict=True) if times > 1]
    gaps = oblast.difference(frame, oblast.union_all(regions))
    points = shapely.points(sites)
    tree = shapely.STRtree(cells)
    _, cell = tree.query(points, predicate="intersects")
    own, which = np.unique(cell, return_index=True)
    site = tree.query(points, predicate="intersects")[0][which]
    vertices, row = shapely.get_coordinates(cells[own], return_index=True)
    some = np.random.default_rng(3).choice(len(vertices), min(len(vertices), 200_000), replace=False)
    places = shapely.points(vertices[some])
    (_, _), least = shapely.STRtree(points).query_nearest(places, return_distance=True, all_matches=False)
    distance = shapely.distance(places, points[site[row[some]]])
    return {
        "vertices": int(shapely.get_num_coordinates(cells).sum()),
        "missing": len(sites) - len(np.unique(own)) + int((~valid).sum()),
        "gaps": len(gaps.polygon_offsets) - 1,
        "overlaps": sum(len(row.polygon_offsets) - 1 for row in twice),
        "cut": 0,
        "error": float((distance - least).max()),
        "area_of_gaps": gaps.area,
        "area_of_overlaps": sum(row.area for row in twice),
    }
