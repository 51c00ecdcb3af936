"""GEOS, the newest one, through shapely: the zones of all shapes, united. The arguments are those of shape_file.h."""

import re
import sys
import time
from pathlib import Path

import inputs
import numpy as np
import shapely


def read(path):
    with open(path, "rb") as file:
        counts = np.fromfile(file, np.uint64, 6).astype(int)
        if counts[2]:
            return inputs.read_polygons(path)
        coordinates = np.fromfile(file, np.float64, 2 * (counts[3] + counts[5])).reshape(-1, 2)
        ends = np.fromfile(file, np.uint64, counts[4]).astype(np.int64)
    lines = shapely.linestrings(coordinates[: counts[3]], indices=np.repeat(np.arange(len(ends)), np.diff(ends, prepend=0)))
    return np.concatenate([lines, shapely.points(coordinates[counts[3] :])])


def main():
    path, distance, segments, result, rounds = sys.argv[1], float(sys.argv[2]), int(sys.argv[3]), sys.argv[4], int(sys.argv[5])
    shapes = read(path)
    best = None
    for _ in range(rounds):
        begin = time.perf_counter()
        if distance < 0:
            zone = shapely.buffer(shapely.union_all(shapes), distance, quad_segs=segments // 4)
        else:
            zone = shapely.union_all(shapely.buffer(shapes, distance, quad_segs=segments // 4))
        seconds = time.perf_counter() - begin
        best = seconds if best is None else min(best, seconds)
        if best > 5:
            break
    status = Path("/proc/self/status").read_text()
    megabytes = int(re.search(r"VmHWM:\s*(\d+)", status)[1]) / 1024
    inputs.write(result, shapely.get_parts(zone))
    print(best, megabytes)


main()
