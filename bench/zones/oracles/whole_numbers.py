"""Objects with whole coordinates whose edges meet at common ends only, as the oracles want them."""

import geopandas
import numpy as np
import shapely

import inputs


def jobs(arguments):
    """By name: what makes the objects, and the tolerance (0: the default)."""
    n, random = arguments.segments, np.random.default_rng(arguments.seed)
    return {
        "roads": (lambda: roads(arguments, n), 0),
        "segments": (lambda: segments(n, random), 0),
        "rectangles": (lambda: shapely.polygons(rectangles(n // 4, random)), 0),
        "mixed": (lambda: mixed(n // 3, random), 0),
        "grid": (lambda: grid(int(np.sqrt(n / 2)), random), 0),
        "gaps": (lambda: gaps(60), 0.05),
        "points": (lambda: shapely.points(unique_points(10 * n, 1 << 24, random)), 0),
    }


def unique_points(count, extent, random):
    return random.permutation(np.unique(random.integers(0, extent, (count, 2)), axis=0))


def roads(arguments, count):
    """Streets and roads, rounded to tenths of a metre."""
    lines = inputs.roads(arguments.program, arguments.folder, count)
    points, line = shapely.get_coordinates(lines, return_index=True)
    return without_crossings(np.rint((points - points.min(axis=0)) * 10).astype(np.int64), line)


def segments(count, random):
    """Short segments in all directions; those that would cross an earlier one are left out."""
    ends = random.integers(0, 1 << 20, (count, 1, 2)) + random.integers(-4000, 4000, (count, 2, 2))
    return without_crossings(ends.reshape(-1, 2), np.repeat(np.arange(count), 2))


def edges_that_meet(points, line):
    """Pairs of edges of lines that meet elsewhere than at common ends: the numbers of the lines."""
    at = np.flatnonzero(line[1:] == line[:-1])
    a, b, of = points[at], points[at + 1], line[at]
    boxes = shapely.box(*np.minimum(a, b).T, *np.maximum(a, b).T)
    i, j = shapely.STRtree(boxes).query(boxes)
    i, j = i[i < j], j[i < j]
    bad = meet(a[i], b[i], a[j], b[j])
    return of[i[bad]], of[j[bad]]


def without_crossings(points, line):
    """Lines without those that meet an earlier one elsewhere than at common vertices, or themselves."""
    kept = np.concatenate([[True], (points[1:] != points[:-1]).any(axis=1) | (line[1:] != line[:-1])])
    points, line = points[kept], line[kept]
    dropped = set()
    for first, second in sorted(zip(*edges_that_meet(points, line), strict=True)):
        if first not in dropped:
            dropped.add(second)
    kept = ~np.isin(line, list(dropped)) & (np.bincount(line)[line] > 1)
    return shapely.linestrings(points[kept], indices=np.unique(line[kept], return_inverse=True)[1])


def checked(objects):
    """The objects, if the oracles may have them: no two edges cross or overlap. (Walls that two houses share are one.)"""
    points, line = shapely.get_coordinates(objects, return_index=True)
    at = np.flatnonzero(line[1:] == line[:-1])
    ends = np.stack([points[at], points[at + 1]], 1).astype(np.int64)
    turned = (ends[:, 0, 0] > ends[:, 1, 0]) | ((ends[:, 0, 0] == ends[:, 1, 0]) & (ends[:, 0, 1] > ends[:, 1, 1]))
    ends[turned] = ends[turned, ::-1]
    edges = np.unique(ends.reshape(-1, 4), axis=0)
    first, _ = edges_that_meet(edges.reshape(-1, 2), np.repeat(np.arange(len(edges)), 2))
    if len(first) > 0:
        raise ValueError(f"{len(first)} edges cross or overlap others, first {edges[first[0]]}")
    return objects


def meet(a, b, c, d):
    """Whether segments cross, overlap, or touch elsewhere than at common ends. Exact: coordinates are below 2^30."""

    def turn(p, q, r):
        u, v = q - p, r - p
        return np.sign(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])

    def holds(p, q, r):
        return (turn(p, q, r) == 0) & (((p - r) * (q - r)).sum(axis=1) < 0)

    crosses = (turn(a, b, c) * turn(a, b, d) < 0) & (turn(c, d, a) * turn(c, d, b) < 0)
    equal = ((a == c).all(axis=1) & (b == d).all(axis=1)) | ((a == d).all(axis=1) & (b == c).all(axis=1))
    return crosses | equal | holds(a, b, c) | holds(a, b, d) | holds(c, d, a) | holds(c, d, b)


def places(count, pitch, random):
    """The middles of squares of a grid, moved a little."""
    side = int(np.ceil(np.sqrt(count)))
    number = np.arange(count)
    return pitch * np.stack([number % side, number // side], axis=1) + random.integers(-400, 400, (count, 2))


def rectangles(count, random):
    """The corners of houses, turned at random; each tenth is two that share a wall."""
    low = places(count, 2500, random)
    direction = random.integers(-30, 31, (count, 2))
    direction[(direction == 0).all(axis=1)] = (1, 0)
    aside = np.stack([-direction[:, 1], direction[:, 0]], axis=1)
    width, height = random.integers(4, 11, (2, count, 1))
    corners = np.stack([low, low + direction * width, low + direction * width + aside * height, low + aside * height], 1)
    two = np.arange(count) % 10 == 0
    near, far = low + direction * (width // 2), low + direction * (width // 2) + aside * height
    near, far = near[two], far[two]
    p, q, r, s = (corners[two, k] for k in range(4))
    return np.concatenate([corners[~two], np.stack([p, near, far, s], 1), np.stack([near, q, r, far], 1)])


def mixed(count, random):
    """Houses, points, segments alone and segments that begin at a corner of a house."""
    houses = rectangles(count // 4, random)
    pitch = 2500
    alone = places(count // 2, pitch, random) * (1, -1) - (0, 2 * pitch)  # below the houses
    odd = alone[1::2]
    corner = houses[::3, 0]
    away = corner + (corner - houses[::3, 2]) // 8
    lines = [np.stack([odd, odd + random.integers(1, 900, odd.shape)], 1), np.stack([corner, away], 1)]
    return np.concatenate(
        [shapely.polygons(houses), shapely.linestrings(np.concatenate(lines)), shapely.points(alone[0::2])]
    )


def grid(side, random):
    """The streets of a square grid, each an object; one of five is missing, and in some squares there is a point."""
    x, y = (a.ravel() for a in np.meshgrid(np.arange(side), np.arange(side)))
    corner = 1000 * np.stack([x, y], axis=1)
    streets = np.concatenate([np.stack([corner, corner + (1000, 0)], 1), np.stack([corner, corner + (0, 1000)], 1)])
    streets = streets[random.random(len(streets)) < 0.8]
    middles = corner[random.random(len(corner)) < 0.3] + 500
    return np.concatenate([shapely.linestrings(streets), shapely.points(middles)])


def gaps(count):
    """Long walls with gaps of one to three units between them."""
    low = np.cumsum(10 + np.arange(count) % 3 + 1)
    side, up = np.array([2000, 701]), np.array([0, 10])
    corner = np.stack([np.zeros(count, np.int64), low], axis=1)
    return shapely.polygons(np.stack([corner, corner + side, corner + side + up, corner + up], 1))
