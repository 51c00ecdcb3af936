"""Reads workload files and writes results; the format is in bench/workloads/workload_file.h."""

import ctypes
from dataclasses import dataclass

import numpy as np

MAGIC = b"OBLWORK1"


@dataclass
class Operand:
    """The arrays of all pairs of one operand; contour and polygon ends count from the beginning of their pair."""

    points: np.ndarray  # (n, 2) doubles
    contour_ends: np.ndarray
    polygon_ends: np.ndarray
    pair_ends: np.ndarray  # (pairs, 3): points, contours, polygons
    kind: int = 0
    coverage: bool = False

    @classmethod
    def empty(cls, pairs):
        none = np.zeros(0, np.uint32)
        return cls(np.zeros((0, 2)), none, none, np.zeros((pairs, 3), np.uint64))

    def absolute_ends(self):
        """Contour ends in points, polygon ends in contours, pair ends in polygons, all from the beginning of the file."""
        ends = self.pair_ends.astype(np.int64)
        begins = np.vstack([np.zeros((1, 3), np.int64), ends[:-1]])
        sizes = ends - begins
        contour_ends = self.contour_ends + np.repeat(begins[:, 0], sizes[:, 1])
        polygon_ends = self.polygon_ends + np.repeat(begins[:, 1], sizes[:, 2])
        return contour_ends.astype(np.int64), polygon_ends.astype(np.int64), ends[:, 2]

    @classmethod
    def from_absolute(cls, points, contour_ends, polygon_ends, owners, pairs):
        """From closed rings; `owners` says which pair each polygon belongs to, in order."""
        keep = np.ones(len(points), bool)
        keep[contour_ends - 1] = False  # the closing point of each ring
        points = points[keep]
        contour_ends = contour_ends - np.arange(1, len(contour_ends) + 1)
        last = np.searchsorted(owners, np.arange(pairs), side="right")  # polygons up to and with each pair
        contours = np.concatenate([[0], polygon_ends])[last]
        vertices = np.concatenate([[0], contour_ends])[contours]
        ends = np.stack([vertices, contours, last], axis=1).astype(np.int64)
        begins = np.vstack([np.zeros((1, 3), np.int64), ends[:-1]])
        sizes = ends - begins
        contour_ends = contour_ends - np.repeat(begins[:, 0], sizes[:, 1])
        polygon_ends = polygon_ends - np.repeat(begins[:, 1], sizes[:, 2])
        return cls(points, contour_ends.astype(np.uint32), polygon_ends.astype(np.uint32), ends.astype(np.uint64))

    def area(self):
        """Outer contours run one way and holes the other, so signed areas add up within a pair."""
        if not len(self.points):
            return 0.0
        contour_ends, _, _ = self.absolute_ends()
        starts = np.concatenate([[0], contour_ends[:-1]])
        sizes = contour_ends - starts
        following = np.arange(1, len(self.points) + 1)
        following[contour_ends - 1] = starts
        p = self.points - np.repeat(self.points[starts], sizes, axis=0)
        q = self.points[following] - np.repeat(self.points[starts], sizes, axis=0)
        by_contour = np.add.reduceat(p[:, 0] * q[:, 1] - q[:, 0] * p[:, 1], starts)
        sums = np.concatenate([[0.0], np.cumsum(by_contour)])[np.concatenate([[0], self.pair_ends[:, 1]]).astype(int)]
        return float(np.abs(np.diff(sums)).sum() / 2)


@dataclass
class Workload:
    operation: int
    fill: int
    a: Operand
    b: Operand


def read_workload(path):
    with open(path, "rb") as file:
        if file.read(8) != MAGIC:
            raise ValueError(f"{path}: not a workload file")
        operation, fill, kind_a, kind_b, flags, pairs = np.fromfile(file, np.uint32, 6)

        def operand(kind):
            points, contours, polygons = (int(n) for n in np.fromfile(file, np.uint64, 3))
            result = Operand(
                np.fromfile(file, np.float64, 2 * points).reshape(-1, 2),
                np.fromfile(file, np.uint32, contours),
                np.fromfile(file, np.uint32, polygons),
                np.zeros(0),
                int(kind),
            )
            file.seek((contours + polygons) % 2 * 4, 1)
            result.pair_ends = np.fromfile(file, np.uint64, 3 * int(pairs)).reshape(-1, 3)
            return result

        a, b = operand(kind_a), operand(kind_b)
    a.coverage = bool(flags & 1)
    return Workload(int(operation), int(fill), a, b)


def write_result(path, result):
    pairs = len(result.pair_ends)
    with open(path, "wb") as file:
        file.write(MAGIC)
        np.array([0, 0, 0, 0, 0, pairs], np.uint32).tofile(file)
        for operand in (result, Operand.empty(pairs)):
            np.array([len(operand.points), len(operand.contour_ends), len(operand.polygon_ends)], np.uint64).tofile(file)
            operand.points.astype(np.float64).tofile(file)
            operand.contour_ends.astype(np.uint32).tofile(file)
            operand.polygon_ends.astype(np.uint32).tofile(file)
            file.write(bytes((len(operand.contour_ends) + len(operand.polygon_ends)) % 2 * 4))
            operand.pair_ends.astype(np.uint64).tofile(file)


def memory_kib(field):
    with open("/proc/self/status") as status:
        return next((int(line.split()[1]) for line in status if line.startswith(field + ":")), 0)


def reset_peak():
    """Starts measuring the peak of resident memory; returns what is resident now."""
    ctypes.CDLL(None).malloc_trim(0)
    with open("/proc/self/clear_refs", "w") as file:
        file.write("5")
    return memory_kib("VmRSS")
