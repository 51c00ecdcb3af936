"""Point sets for the comparison with an exact Delaunay triangulation. No point is there twice."""

import numpy as np


def jobs(count, seed=1):
    """By name: what makes the points, about `count` of them, or a tenth of that."""
    random = np.random.default_rng(seed)
    side, tenth = int(np.sqrt(count)), count // 10
    return {
        "uniform": lambda: random.random((count, 2)),
        "uniform on whole numbers": lambda: whole(random, count, 1 << 24),
        "clusters": lambda: random.random((100, 2))[random.integers(0, 100, tenth)] + random.normal(0, 1e-4, (tenth, 2)),
        "square grid": lambda: lattice(side).astype(float),
        "square grid of tenths": lambda: lattice(int(np.sqrt(tenth))) / 10,
        "far from the origin": lambda: whole(random, tenth, 1 << 24) + 1e9 + 1 / 8,
        "circles": lambda: circles(tenth, 1),
        "circles in circles": lambda: circles(tenth, 4),
        "on a level line": lambda: np.arange(tenth)[:, None] * (3.0, 0.0) + (1, 2),
        # Few: zones are strips through the whole frame, and the judge takes the square of their number.
        "on a slanted line": lambda: np.arange(tenth // 20)[:, None] * (3.0, 7.0) + (1, 2),
        "on a line, rounded": lambda: unique(np.arange(tenth // 20)[:, None] * (0.3, 0.7)),
        "on 100 lines": lambda: lines(random, 100, tenth // 100),
    }


def unique(points):
    return np.unique(points, axis=0)


def whole(random, count, extent):
    return random.permutation(unique(random.integers(0, extent, (count, 2)))).astype(float)


def lattice(side):
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    return np.stack([x.ravel(), y.ravel()], axis=1)


def on_circle(radius):
    """All whole points on a circle around the origin."""
    x = np.arange(radius + 1, dtype=np.int64)
    square = radius * radius - x * x
    y = np.rint(np.sqrt(square)).astype(np.int64)
    x, y = x[y * y == square], y[y * y == square]
    return unique(np.concatenate([np.stack([s * x, t * y], 1) for s in (-1, 1) for t in (-1, 1)]))


def circles(count, nested):
    """Whole points on circles of a million and more, each with 972 of them or more; `nested` circles have one centre."""
    radii = [5 * 13 * 17 * 29 * 37 * k for k in range(1, nested + 1)]
    together = np.concatenate([on_circle(radius) for radius in radii])
    centres = 3 * radii[-1] * lattice(int(np.ceil(np.sqrt(count / len(together)))))
    return unique((centres[:, None] + together).reshape(-1, 2)).astype(float)


def lines(random, count, each):
    """Points at whole steps along lines with whole directions."""
    start = random.integers(0, 1 << 20, (count, 1, 2))
    direction = random.integers(-50, 50, (count, 1, 2))
    return unique((start + direction * np.arange(each)[:, None]).reshape(-1, 2)).astype(float)
