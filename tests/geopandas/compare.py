"""Compares `oblast overlay` and `oblast dissolve` with geopandas: the same rows, attributes and areas.

    compare.py PROGRAM [--shared FOLDER] [--random N] [--seed S]

Pairs of layers: geopandas' own test data, the real layers, and N random pairs (rows that overlap, shared borders, holes,
empty and missing geometries, missing values, columns with the same name). Rows are compared by their attributes: the areas
of equal rows are added and must agree within 1e-9 of the area of the input. A row that only one of the two has must be
smaller than that; such slivers come from rounding and are counted. Where geopandas throws, that is counted and listed.
Exit code 1 if anything differs.
"""

import argparse
import collections
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import warnings

import geopandas
import pandas
import shapely

OPERATIONS = {
    "intersection": "intersection",
    "identity": "identity",
    "union": "union",
    "difference": "difference",
    "symmetric_difference": "symdifference",
}
TOLERANCE = 1e-9


def value_of(value):
    """Attribute values that mean the same become equal: missing ones are None, whole floats are whole numbers."""
    if value is None or value is pandas.NaT or (isinstance(value, float) and math.isnan(value)):
        return None
    if isinstance(value, float) and value.is_integer():
        return int(value)
    return value.item() if hasattr(value, "item") else value


def areas_of(frame):
    """By row, as its attributes: the area of all rows with these attributes."""
    columns = sorted(c for c in frame.columns if c not in ("geometry", "fid"))
    areas = collections.Counter()
    for values, shape in zip(frame[columns].itertuples(index=False), frame.geometry):
        area = 0.0 if shape is None else shape.area
        areas[tuple(zip(columns, map(value_of, values)))] += area
    return columns, areas


class Comparison:
    def __init__(self, program, folder):
        self.program, self.folder = program, pathlib.Path(folder)
        self.counts = collections.Counter()
        self.faults = []

    def run(self, name, *arguments):
        """The result of a call of the program, or None after noting a fault."""
        out = self.folder / "out.gpkg"
        done = subprocess.run(
            [self.program, *map(str, arguments), "-o", out, "--overwrite", "--quiet"], capture_output=True, text=True
        )
        if done.returncode == 0:
            return geopandas.read_file(out)
        self.fault(name, f"exit code {done.returncode}: {done.stderr.strip()}")
        return None

    def fault(self, name, what):
        self.counts["differ"] += 1
        self.faults.append(f"{name}: {what}")

    def compare(self, name, ours, theirs, total):
        our_columns, our_areas = areas_of(ours)
        their_columns, their_areas = areas_of(theirs)
        if our_columns != their_columns:
            return self.fault(name, f"columns {our_columns} instead of {their_columns}")
        for row in our_areas.keys() | their_areas.keys():
            difference = abs(our_areas[row] - their_areas[row])
            if difference > TOLERANCE * total:
                return self.fault(name, f"row {row}: area {our_areas[row]} instead of {their_areas[row]}")
            if (row in our_areas) != (row in their_areas) and difference > 0:
                self.counts["slivers that only one has"] += 1
        self.counts["the same"] += 1

    def overlays(self, name, a, b, operations=OPERATIONS):
        paths = []
        for side, layer in (("a", a), ("b", b)):
            paths.append(self.folder / f"{side}.gpkg")
            layer.to_file(paths[-1], layer="layer", driver="GPKG")
        total = a.area.sum() + b.area.sum()
        for how in operations:
            title = f"{name} {how}"
            ours = self.run(title, "overlay", OPERATIONS[how], *paths)
            if ours is None:
                continue
            try:
                theirs = geopandas.overlay(a, b, how=how, keep_geom_type=True)
            except Exception as error:  # what it throws is what is counted
                self.counts["geopandas throws"] += 1
                print(f"geopandas throws, {title}: {str(error).splitlines()[0][:120]}")
                continue
            self.compare(title, ours, theirs, total)

    def dissolves(self, name, layer, field):
        path = self.folder / "layer.gpkg"
        layer.to_file(path, layer="layer", driver="GPKG")
        title = f"{name} dissolve by {field}"
        ours = self.run(title, "dissolve", path, "--by", field)
        if ours is not None:
            theirs = layer.dissolve(by=field, dropna=False).reset_index()
            self.compare(title, ours, theirs, layer.area.sum())


def random_layer(rng, prefix):
    rows = []
    kind = rng.choice(["grid", "squares", "triangles", "holes"])
    if kind == "grid":
        w, h = rng.randint(1, 4), rng.randint(1, 4)
        x0, y0, step = rng.uniform(0, 2), rng.uniform(0, 2), rng.choice([1.0, 0.7, rng.uniform(0.5, 1.5)])
        rows = [
            shapely.box(x0 + i * step, y0 + j * step, x0 + (i + 1) * step, y0 + (j + 1) * step)
            for i in range(w)
            for j in range(h)
        ]
    else:
        for _ in range(rng.randint(1, 8)):
            x, y, s = rng.uniform(0, 4), rng.uniform(0, 4), rng.uniform(0.2, 3)
            if rng.random() < 0.5:
                x, y, s = float(round(x)), float(round(y)), float(max(1, round(s)))
            if kind == "triangles":
                points = [(x + rng.uniform(0, 3), y + rng.uniform(0, 3)) for _ in range(3)]
                rows.append(shapely.Polygon(points))
            elif kind == "holes":
                hole = shapely.box(x + s / 4, y + s / 4, x + s / 2, y + s / 2)
                rows.append(shapely.box(x, y, x + s, y + s).difference(hole))
            else:
                rows.append(shapely.box(x, y, x + s, y + s))
    if rng.random() < 0.2:
        rows.append(shapely.MultiPolygon([shapely.box(9, 9, 10, 10), shapely.box(0, 0, 1, 1)]))
    if rng.random() < 0.2:
        rows.append(None)
    count = len(rows)
    columns = {
        "same": range(count),
        prefix + "_text": [rng.choice(["ä", "b", None]) for _ in range(count)],
        prefix + "_number": [rng.choice([1.5, -2.0, None]) for _ in range(count)],
    }
    return geopandas.GeoDataFrame(columns, geometry=rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--shared", type=pathlib.Path, default=pathlib.Path(__file__).parents[3] / "shared")
    parser.add_argument("--random", type=int, default=200, help="random pairs (200)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--real", action="store_true", help="the real layers, too: minutes, nearly all in geopandas")
    arguments = parser.parse_args()
    warnings.filterwarnings("ignore")
    with tempfile.TemporaryDirectory() as folder:
        comparison = Comparison(arguments.program, folder)
        data = arguments.shared / "geopandas"
        for name in ("polys", "overlap"):
            suffix = "_overlap" if name == "overlap" else ""
            a, b = (geopandas.read_file(data / "overlay" / name / f"df{i}{suffix}.geojson") for i in (1, 2))
            comparison.overlays(f"geopandas {name}", a, b)
        boroughs = geopandas.read_file(f"zip://{data / 'nybb_16a.zip'}")
        circles = geopandas.read_file(data / "overlay" / "nybb_qgis" / "polydf2.shp")
        comparison.overlays("geopandas nybb", boroughs, circles.to_crs(boroughs.crs))
        if arguments.real:
            real = arguments.shared / "realworld"
            a = geopandas.read_file(real / "germany-districts-high.geojson")
            b = geopandas.read_file(real / "germany-counties-medium.geojson")
            a, b = a[["geometry"]].assign(i=range(len(a))), b[["geometry"]].assign(j=range(len(b)))
            comparison.overlays("districts and counties", a, b)
        for number in range(arguments.random):
            rng = random.Random(arguments.seed * 1_000_003 + number)
            a, b = random_layer(rng, "a"), random_layer(rng, "b")
            comparison.overlays(f"random {number}", a, b, [rng.choice(list(OPERATIONS))])
            comparison.dissolves(f"random {number}", a, "a_text")
    for fault in comparison.faults[:20]:
        print("DIFFERS", fault)
    print(", ".join(f"{count} {what}" for what, count in sorted(comparison.counts.items())))
    return 1 if comparison.faults else 0


if __name__ == "__main__":
    sys.exit(main())
