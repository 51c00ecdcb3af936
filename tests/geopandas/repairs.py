"""Judges repaired layers by GEOS: is every feature valid, is every coverage one?

    repairs.py FILE

FILE is what `oblast_hostile_rows --repair --texts FILE` wrote: lines of generator, seed, r (a feature repaired by itself) or
c (a row of a repaired coverage), WKT. Prints a table by generator and the first faults.

beyond: layers that GEOS cannot judge, since magnitudes of their coordinates differ by more than 1e30. It decides with twice
the digits of a double, which is 32. differ: coverages that GEOS calls invalid though they are not. Where many edges meet in
one point at angles of a few units in the last place it sees overlaps; these are proved here with exact fractions. Exit code 1
if a feature is invalid, or a coverage is not proved.
"""

import collections
import fractions
import itertools
import sys

import numpy
import shapely


def beyond_geos(geometries):
    coordinates = numpy.abs(shapely.get_coordinates(geometries))
    coordinates = coordinates[coordinates > 0]
    return coordinates.size > 0 and coordinates.max() > 1e30 * coordinates.min()


def side(a, b, c):
    """The sign of the area of the triangle, exactly."""
    (ax, ay), (bx, by), (cx, cy) = ([fractions.Fraction(x) for x in p] for p in (a, b, c))
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    return (area > 0) - (area < 0)


def meet_badly(e, f):
    """Do two edges meet elsewhere than in common ends? Equal edges do not."""
    (a, b), (c, d) = e, f
    if {a, b} == {c, d}:
        return False
    if max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0]):
        return False
    if max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
        return False
    common = {a, b} & {c, d}
    if common:
        (p,) = common
        u, v = (a if b == p else b), (c if d == p else d)
        return side(p, u, v) == 0 and (u > p) == (v > p)
    return side(a, b, c) * side(a, b, d) <= 0 and side(c, d, a) * side(c, d, b) <= 0


def is_coverage(geometries):
    """Edges of different features are the same or meet in common ends, and no two features are on one side of an edge."""
    edges = []
    for feature, geometry in enumerate(shapely.normalize(geometries)):  # outer rings clockwise, holes the other way
        for ring in shapely.get_rings(shapely.get_parts(geometry)):
            points = [tuple(p) for p in shapely.get_coordinates(ring)]
            edges += [(feature, edge) for edge in itertools.pairwise(points)]
    if len({edge for _, edge in edges}) < len(edges):
        return False
    return not any(f != g and meet_badly(d, e) for (f, d), (g, e) in itertools.combinations(edges, 2))


def layers(path):
    """(generator, seed, kind) and the geometries, layer by layer."""
    found = collections.defaultdict(list)
    with open(path, encoding="ascii") as lines:
        for line in lines:
            generator, seed, kind, wkt = line.rstrip("\n").split("\t")
            found[generator, int(seed), kind].append(wkt)
    for key, texts in found.items():
        yield key, shapely.from_wkt(texts)


def main():
    columns = ["layers", "features", "beyond", "invalid", "coverages", "differ", "bad"]
    counts = collections.defaultdict(collections.Counter)
    shown = 0
    for (generator, seed, kind), geometries in layers(sys.argv[1]):
        count = counts[generator]
        count["layers" if kind == "r" else "coverages"] += 1
        count["features"] += len(geometries)
        if beyond_geos(geometries):
            count["beyond"] += 1
            continue
        faults = [shapely.is_valid_reason(g) for g in geometries if not shapely.is_valid(g)]
        count["invalid"] += len(faults)
        if kind == "c" and not shapely.coverage_is_valid(geometries):
            proved = is_coverage(geometries)
            count["differ" if proved else "bad"] += 1
            if not proved:
                faults.append("no valid coverage")
        if faults and shown < 10:
            shown += 1
            print(f"{generator} seed {seed} {kind}: {faults[0]}")
    print(f"{'generator':22}" + "".join(f"{name:>10}" for name in columns))
    total = collections.Counter()
    for generator, count in counts.items():
        print(f"{generator:22}" + "".join(f"{count[name]:10}" for name in columns))
        total.update(count)
    print(f"{'all':22}" + "".join(f"{total[name]:10}" for name in columns))
    print(f"shapely {shapely.__version__}, GEOS {shapely.geos_version_string}")
    return 1 if total["invalid"] or total["bad"] else 0


if __name__ == "__main__":
    sys.exit(main())
