"""The driver of the newest GEOS, as the wheel of shapely brings it.

Same interface as the others (bench/README.md). Geometries are made outside the clock; the operation
and the extraction of result arrays (shapely.to_ragged_array) are inside. GEOS itself uses one thread; many
pairs are divided among threads, which shapely's vectorised functions allow by releasing the interpreter.
"""

import argparse
import json
import re
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import shapely

from workload_file import Operand, memory_kib, read_workload, reset_peak, write_result

OPERATIONS = ["intersection", "union", "difference", "symdifference"]
OVERLAY = [shapely.intersection, shapely.union, shapely.difference, shapely.symmetric_difference]
REGION_SET, OVERLAPPING, CROSSING = range(3)
EVEN_ODD = 2


class Unsupported(Exception):
    pass


def polygons_of(operand):
    """All polygons of all pairs as one array of shapely polygons, and where each pair ends in it."""
    contour_ends, polygon_ends, ends = operand.absolute_ends()
    starts = np.concatenate([[0], contour_ends[:-1]]).astype(np.int64) if len(contour_ends) else contour_ends
    # Every ring repeats its first point at its end.
    points = np.insert(operand.points, contour_ends, operand.points[starts], axis=0)
    ring_offsets = np.concatenate([[0], contour_ends + np.arange(1, len(contour_ends) + 1)])
    polygon_offsets = np.concatenate([[0], polygon_ends])
    polygons = shapely.from_ragged_array(shapely.GeometryType.POLYGON, points, (ring_offsets, polygon_offsets))
    return polygons, ends


def geometries_of(operand):
    """One geometry a pair."""
    polygons, ends = polygons_of(operand)
    if len(ends) == len(polygons):
        return polygons
    owners = np.repeat(np.arange(len(ends)), np.diff(np.concatenate([[0], ends])))
    if operand.coverage:
        return np.array([shapely.geometrycollections(polygons)])
    return shapely.multipolygons(polygons, indices=owners, out=np.full(len(ends), shapely.MultiPolygon(), object))


def resolved(geometries, kind, fill):
    """GEOS overlays valid geometries only; what is not valid yet is made so, inside the clock."""
    if kind == OVERLAPPING:
        return shapely.unary_union(geometries[:, None], axis=1)
    if kind == CROSSING:
        if fill != EVEN_ODD:
            raise Unsupported("contours that cross themselves have only an even-odd meaning (make_valid)")
        return shapely.make_valid(geometries)
    return geometries


def extract(geometries):
    """The result arrays, one pair after another."""
    parts, owners = shapely.get_parts(geometries, return_index=True)
    areal = np.isin(shapely.get_type_id(parts), [3, 6])
    parts, owners = parts[areal & ~shapely.is_empty(parts)], owners[areal & ~shapely.is_empty(parts)]
    if not len(parts):
        return Operand.empty(len(geometries))
    polygons, inner = shapely.get_parts(parts, return_index=True)
    _, points, (ring_offsets, polygon_offsets) = shapely.to_ragged_array(polygons)
    return Operand.from_absolute(points, ring_offsets[1:], polygon_offsets[1:], owners[inner], len(geometries))


def united(geometries, coverage):
    return np.array([shapely.coverage_union_all(geometries)]) if coverage else shapely.unary_union(geometries[:, None], axis=1)


def run(workload, operation, a, b, threads):
    unary = not len(workload.b.points)

    def work(part):
        if unary and workload.a.kind != CROSSING:
            return united(a[part], workload.a.coverage)
        left = resolved(a[part], workload.a.kind, workload.fill)
        return left if unary else OVERLAY[operation](left, resolved(b[part], workload.b.kind, workload.fill))

    if len(a) == 1 or threads == 1:
        return extract(work(slice(None)))
    bounds = [len(a) * i // threads for i in range(threads + 1)]
    with ThreadPoolExecutor(threads) as pool:
        return extract(np.concatenate(list(pool.map(work, map(slice, bounds, bounds[1:])))))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("workload")
    parser.add_argument("operation", choices=["default", *OPERATIONS])
    parser.add_argument("--repeat", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--dump")
    parser.add_argument("--coverage", action="store_true", help="unite coverages by coverage_union_all")
    arguments = parser.parse_args()

    workload = read_workload(arguments.workload)
    peer = "geos-newest-coverage" if arguments.coverage else "geos-newest"
    head = {
        "peer": peer,
        "version": f"{shapely.geos_version_string} (shapely {shapely.__version__})",
        "operation": arguments.operation,
        "threads": arguments.threads,
    }
    try:
        if arguments.coverage and not workload.a.coverage:
            raise Unsupported("only for coverages")
        workload.a.coverage = arguments.coverage
        operation = workload.operation
        if arguments.operation != "default":
            operation = OPERATIONS.index(arguments.operation)
        a, b = geometries_of(workload.a), geometries_of(workload.b)
        for _ in range(arguments.repeat):
            result = None
            input_kib = reset_peak()
            start = time.perf_counter()
            result = run(workload, operation, a, b, arguments.threads)
            seconds = time.perf_counter() - start
            line = {
                "seconds": seconds,
                "peak_kib": memory_kib("VmHWM"),
                "input_kib": input_kib,
                "polygons": len(result.polygon_ends),
                "contours": len(result.contour_ends),
                "vertices": len(result.points),
                "area": result.area(),
            }
            print(json.dumps(head | line), flush=True)
        if arguments.dump:
            write_result(arguments.dump, result)
    except Unsupported as reason:
        print(json.dumps(head | {"unsupported": str(reason)}))
    except (shapely.errors.ShapelyError, ValueError, MemoryError) as error:
        print(json.dumps(head | {"error": re.sub(r"\s+", " ", str(error))}))


if __name__ == "__main__":
    sys.exit(main())
