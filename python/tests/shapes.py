"""Shapes that the tests share."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

import oblast


def square(x: float = 0, y: float = 0, side: float = 1) -> oblast.Regions:
    """A square by its lower left corner."""
    return oblast.from_ragged([[x, y], [x + side, y], [x + side, y + side], [x, y + side]], [0, 4])


def squares(*corners: tuple[float, float], side: float = 2) -> oblast.Regions:
    """A row for each square."""
    points = np.concatenate([square(x, y, side).points for x, y in corners])
    return oblast.from_ragged(points, np.arange(len(corners) + 1) * 4)


def tangle(vertices: int, seed: int = 0) -> oblast.Regions:
    """A polygon that crosses itself about vertices^2 / 5 times."""
    points: npt.NDArray[np.float64] = np.random.default_rng(seed).random((vertices, 2))
    return oblast.from_ragged(points, [0, vertices])


def with_hole() -> oblast.Regions:
    """Three rows: a square with a hole, nothing, two triangles."""
    points = [[0, 0], [3, 0], [3, 3], [0, 3], [1, 1], [1, 2], [2, 2], [2, 1]]
    points += [[5, 5], [6, 5], [6, 6], [8, 8], [9, 8], [9, 9]]
    return oblast.from_ragged(points, [0, 4, 8, 11, 14], [0, 2, 3, 4], [0, 1, 1, 3])
