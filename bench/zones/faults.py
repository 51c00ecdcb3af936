"""What is wrong with cells, whoever made them: counted exactly, by the overlays of oblast."""

import numpy as np
import oblast
import shapely


def of(shapes, cells, frame):
    """Objects without a cell, gaps in the frame, overlaps, objects that their cells do not cover; how much nearer another
    object is, at the worst of the vertices and middles of the cells' edges (by GEOS' distances)."""
    cells = cells[~cells.is_empty & cells.is_valid]
    own = shapes.loc[cells.index]
    regions = oblast.from_shapely(np.asarray(cells))
    depth = oblast.depth(regions)
    twice = [row for row, times in zip(depth.regions, depth.depth, strict=True) if times > 1]
    gaps = oblast.difference(frame, oblast.union_all(regions))
    return {
        "vertices": len(regions.points),
        "missing": len(shapes) - len(cells),
        "gaps": len(gaps.polygon_offsets) - 1,
        "overlaps": sum(len(row.polygon_offsets) - 1 for row in twice),
        "cut": cut(own, cells, frame),
        "error": nearness(shapes, own, cells, frame),
        "area_of_gaps": gaps.area,
        "area_of_overlaps": sum(row.area for row in twice),
    }


def cut(own, cells, frame):
    """Objects in the frame of which more than a billionth is outside of their cells. New vertices on a wall are rounded,
    which moves it by some units in the last place; that does not count."""
    size = np.maximum(own.area, own.length)
    outside = shapely.difference(np.asarray(own), np.asarray(cells))
    part = np.maximum(shapely.area(outside), np.where(own.area > 0, 0, shapely.length(outside)))
    return int(((part > 1e-9 * size) & np.asarray(own.within(frame))).sum())


def nearness(shapes, own, cells, frame, most=200_000):
    """The largest distance from a cell's border to its object, less that to the nearest one."""
    parts, row_of_part = shapely.get_parts(np.asarray(cells), return_index=True)
    rings, part_of_ring = shapely.get_rings(parts, return_index=True)
    points, ring = shapely.get_coordinates(rings, return_index=True)
    row = row_of_part[part_of_ring][ring]
    is_edge = ring[1:] == ring[:-1]
    middles = (points[1:] + points[:-1])[is_edge] / 2
    places = shapely.points(np.concatenate([points, middles]))
    rows = np.concatenate([row, row[1:][is_edge]])
    inside = shapely.dwithin(places, frame, 1e-6)
    chosen = np.flatnonzero(inside)
    if len(chosen) > most:
        chosen = np.random.default_rng(3).choice(chosen, most, replace=False)
    tree = shapely.STRtree(np.asarray(shapes))
    (found, _), least = tree.query_nearest(places[chosen], return_distance=True, all_matches=False)
    distance = shapely.distance(places[chosen][found], np.asarray(own)[rows[chosen][found]])
    return float((distance - least).max())
