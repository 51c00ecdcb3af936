"""Compares the faults that `oblast check` finds with those of GEOS.

    check_beside_geos.py PROGRAM [--shared FOLDER] [--random N]

Features: GEOS' `is_valid_reason` names one fault of a feature, the program all. Both must call the same features valid.
Coverages: GEOS' `coverage_invalid_edges` marks features whose borders do not match; the program's overlaps, T-junctions and
mismatched vertices must be at the same features. Differences are listed with their reasons. Exit code 1 if one has none.
"""

import argparse
import collections
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import warnings

import pyogrio
import shapely

POLYGONS = ("Polygon", "MultiPolygon")
BETWEEN = {"overlap", "T-junction", "mismatched vertices"}


def check(program, path, *options):
    run = subprocess.run([program, "check", str(path), "--json", *options], capture_output=True, text=True)
    if run.returncode not in (0, 1) or not run.stdout:
        raise RuntimeError(f"{path}: {run.stderr.strip()}")
    return json.loads(run.stdout)


def wkt_layer(path):
    """Every line is a feature; GEOS refuses some."""
    shapes = {}
    for number, line in enumerate(path.read_text().splitlines()):
        try:
            shapes[number] = shapely.from_wkt(line)
        except shapely.errors.GEOSException as error:
            shapes[number] = str(error)
    return shapes


def file_layers(path, folder):
    """Name, path for the program, and features by number, of each layer. Several layers become files of their own."""
    if path.suffix == ".wkt":
        yield path.name, path, wkt_layer(path)
        return
    layers = [name for name, _ in pyogrio.list_layers(path)]
    for layer in layers:
        # `read_dataframe` would mend rings that are not closed, and so would not see them.
        _, ids, geometry, _ = pyogrio.raw.read(path, layer=layer, columns=[], return_fids=True)
        shapes = {}
        for number, wkb in zip(ids, geometry if geometry is not None else []):
            try:
                shapes[int(number)] = None if wkb is None else shapely.from_wkb(wkb)
            except shapely.errors.GEOSException as error:
                shapes[int(number)] = str(error)
        if len(layers) == 1:
            yield path.name, path, shapes
            continue
        own = folder / f"{path.stem}-{layer}.gpkg"
        frame = pyogrio.read_dataframe(path, layer=layer, columns=[])
        pyogrio.write_dataframe(frame, own)
        yield f"{path.name}:{layer}", own, {number + 1: shape for number, shape in enumerate(shapes.values())}


def random_features(number, seed):
    """Polygons and multipolygons on a coarse grid, where everything that can touch does; rings may be anything."""
    draw = random.Random(seed)

    def ring(size):
        points = [(draw.randrange(size), draw.randrange(size)) for _ in range(draw.choice((3, 3, 4, 4, 5, 6, 8)))]
        return "(" + ", ".join(f"{x} {y}" for x, y in [*points, points[0]]) + ")"

    def box(size):
        x, y = draw.randrange(size), draw.randrange(size)
        w, h = draw.randrange(1, size), draw.randrange(1, size)
        return f"({x} {y}, {x + w} {y}, {x + w} {y + h}, {x} {y + h}, {x} {y})"

    def polygon():
        size = draw.choice((4, 6, 9, 14))
        shell = f"(0 0, {size} 0, {size} {size}, 0 {size}, 0 0)" if draw.random() < 0.5 else ring(size)
        return "(" + ", ".join([shell] + [draw.choice((ring, box))(size) for _ in range(draw.choice((0, 0, 1, 2, 3)))]) + ")"

    return "".join(
        "MULTIPOLYGON (" + ", ".join(polygon() for _ in range(draw.choice((1, 1, 1, 2, 3)))) + ")\n" for _ in range(number))


class Comparison:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.counts = collections.defaultdict(collections.Counter)
        self.kinds = collections.defaultdict(collections.Counter)
        self.pairs = collections.Counter()
        self.differences = []

    def compare(self, group, path, coverage=True):
        for name, own_path, shapes in file_layers(path, self.folder):
            counts = self.counts[group]
            counts["layers"] += 1
            ours = check(self.program, own_path, *(["--coverage"] if coverage else []))
            polygons = {n: s for n, s in shapes.items() if isinstance(s, str) or (s is not None and s.geom_type in POLYGONS)}
            if not polygons:
                counts["layers without polygons"] += 1
                if ours.get("polygons") != 0 and ours.get("features") != 0:
                    self.differ(name, None, "features", "GEOS sees no polygons", "")
                continue
            self.kinds[group].update(ours["faults_by_kind"])
            self.compare_features(group, name, polygons, ours)
            if coverage:
                self.compare_coverage(group, name, polygons, ours)

    def compare_features(self, group, name, polygons, ours):
        counts = self.counts[group]
        faults = collections.defaultdict(set)
        for fault in ours["faults"]:
            if not fault["note"] and fault["kind"] not in BETWEEN | {"gap"}:
                faults[fault["place"]["feature"]].add(fault["kind"])
        for number, shape in polygons.items():
            counts["features"] += 1
            reason = shape if isinstance(shape, str) else re.sub(r"\s*\[.*", "", shapely.is_valid_reason(shape))
            kinds = " + ".join(sorted(faults[number])) if number in faults else "valid"
            if group != "random":  # random features have faults of many kinds each
                self.pairs[kinds, "valid" if reason == "Valid Geometry" else reason] += 1
            if reason != "Valid Geometry":
                counts["invalid by GEOS"] += 1
            if number in faults:
                counts["invalid by oblast"] += 1
            if (reason != "Valid Geometry") != (number in faults):
                self.differ(name, number, kinds, reason, "")

    def compare_coverage(self, group, name, polygons, ours):
        counts = self.counts[group]
        ids = [n for n, s in polygons.items() if not isinstance(s, str)]
        shapes = [polygons[n] for n in ids]
        if len(ids) < len(polygons) or not all(shapely.is_valid(shapes)):
            counts["layers with invalid features: coverage not compared"] += 1
            return
        edges = shapely.coverage_invalid_edges(shapes)
        geos = {n for n, edge in zip(ids, edges) if not edge.is_empty}
        own = collections.defaultdict(set)
        for fault in ours["faults"]:
            if fault["kind"] in BETWEEN:
                for side in ("place", "other"):
                    own[fault[side]["feature"]].add(fault["kind"])
        counts["not matching by GEOS"] += len(geos)
        counts["not matching by oblast"] += len(own)
        by_id = dict(zip(ids, shapes))
        for number in sorted(geos ^ set(own)):
            reason = self.reason_of_coverage(number, number in geos, own.get(number, set()), by_id)
            self.differ(name, number, " + ".join(sorted(own.get(number, {"matches"}))),
                        "invalid edges" if number in geos else "matches", reason)

    @staticmethod
    def reason_of_coverage(number, by_geos, kinds, shapes):
        shape = shapes[number]
        if not by_geos and kinds == {"overlap"} and any(
                shapely.contains_properly(shape, other) or shapely.contains_properly(other, shape)
                for n, other in shapes.items() if n != number):
            return "one feature lies in the other, and its border meets no other border: GEOS marks the inner one only"
        return ""

    def differ(self, *row):
        self.differences.append(row)


def print_report(comparison):
    rows = list(dict.fromkeys(what for counts in comparison.counts.values() for what in counts))
    print("| | " + " | ".join(comparison.counts) + " |")
    print("|---|" + "---|" * len(comparison.counts))
    for what in rows:
        print(f"| {what} | " + " | ".join(str(counts[what]) for counts in comparison.counts.values()) + " |")
    for kind in sorted({kind for kinds in comparison.kinds.values() for kind in kinds}):
        print(f"| {kind} | " + " | ".join(str(comparison.kinds[group][kind]) for group in comparison.counts) + " |")
    print("\n| oblast: kinds of a feature's faults | GEOS: reason | features |\n|---|---|---|")
    for (ours, geos), count in sorted(comparison.pairs.items()):
        print(f"| {ours} | {geos} | {count} |")
    print(f"\nDifferences: {len(comparison.differences)}")
    for name, number, ours, geos, reason in comparison.differences:
        print(f"- {name}, feature {number}: {ours}; GEOS: {geos}. {reason or 'NO KNOWN REASON'}.")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--shared", default="../shared")
    parser.add_argument("--random", type=int, default=0, help="number of random features")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    warnings.filterwarnings("ignore")
    shared, cases = pathlib.Path(arguments.shared), pathlib.Path("tests/cases/faults")
    with tempfile.TemporaryDirectory() as folder:
        comparison = Comparison(arguments.program, pathlib.Path(folder))
        groups = {
            "fault files": [p for p in sorted(cases.rglob("*")) if p.suffix in (".wkt", ".geojson")],
            "geopandas": [p for p in sorted((shared / "geopandas" / "overlay").rglob("*"))
                          if p.suffix in (".geojson", ".shp", ".gpkg", ".json")],
            "real layers": [p for p in sorted((shared / "realworld").iterdir()) if p.suffix in (".geojson", ".gpkg")],
        }
        for group, paths in groups.items():
            for path in paths:
                comparison.compare(group, path)
        if arguments.random:
            path = pathlib.Path(folder) / "random.wkt"
            path.write_text(random_features(arguments.random, arguments.seed))
            comparison.compare("random", path, coverage=False)
        print_report(comparison)
    sys.exit(any(not row[4] for row in comparison.differences))


if __name__ == "__main__":
    main()
