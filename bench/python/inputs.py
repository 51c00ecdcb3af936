"""Inputs of the jobs that have no attributes, in the natural types of the tools."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "peers"))
from workload_file import read_workload

SCALE = 2**31  # pyclipper computes in whole numbers
MICRO = 10**9  # so does pyclipr, inside


def arrays_of(operand):
    """Points, ring offsets; every ring is a polygon."""
    return operand.points, np.concatenate([[0], operand.absolute_ends()[0]]).astype(np.int32)


def layer(folder, name):
    """The first operand of a workload, and the second."""
    work = read_workload(f"{folder}/{name}.work")
    return arrays_of(work.a), arrays_of(work.b)


def shapely_polygons(points, offsets):
    import shapely

    starts, ends = offsets[:-1], offsets[1:]
    closed = np.insert(points, ends, points[starts], axis=0)
    rings = offsets + np.arange(len(offsets))
    return shapely.from_ragged_array(shapely.GeometryType.POLYGON, closed, (rings, np.arange(len(rings))))


def polygons_only(geometries):
    """Shapely answers some pairs with a collection that has lines or points, too."""
    import shapely

    parts = shapely.get_parts(shapely.get_parts(geometries))
    return parts[shapely.get_type_id(parts) == 3]


def lists(points, offsets):
    return np.split(points, offsets[1:-1])


def ring_area(rings):
    total = 0.0
    for ring in rings:
        x, y = np.asarray(ring, dtype=float).T
        x, y = x - x[0], y - y[0]
        total += (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
    return total
