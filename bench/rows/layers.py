"""layers.py PROGRAM SHARED FOLDER [NAME...]: makes layers, as GeoJSON, for bench/rows and bench/program.

NAME is districts, communes, fires or parcels: these and the layers that belong to them. Layers that exist are kept."""

import subprocess
import sys
from pathlib import Path

import geopandas
import numpy as np
import pandas
import shapely


def write(frame, path):
    # Coordinates keep their bits, in the fewest digits: GDAL's writer would round them, or write twenty digits.
    path.write_text(frame.to_json(drop_id=True))


def germany(shared, folder):
    for name, source, columns in (("districts", "germany-districts-high", {"NAME_2": "district"}),
                                  ("counties", "germany-counties-medium", {"NAME_3": "county", "NAME_1": "state"})):
        frame = geopandas.read_file(shared / "realworld" / f"{source}.geojson").rename(columns=columns)
        frame = frame[[*columns.values(), "geometry"]]
        frame.geometry = shapely.make_valid(frame.geometry.values)  # the peers refuse invalid features
        write(frame, folder / f"{name}.geojson")


def communes(shared, folder):
    parts = []
    for region in ("hauts-de-france", "normandie"):
        frame = geopandas.read_file(shared / "realworld" / f"france-communes-{region}.geojson")
        frame["region"], frame["departement"] = region, frame["code"].str[:2]
        parts.append(frame)
    both = pandas.concat(parts, ignore_index=True)
    both.geometry = shapely.make_valid(both.geometry.values)
    write(both, folder / "communes.geojson")
    metres = both[both["region"] == "hauts-de-france"][["code", "departement", "geometry"]].to_crs(2154)
    metres.geometry = shapely.make_valid(metres.geometry.values)
    metres = metres.set_crs(None, allow_override=True)
    write(metres, folder / "communes-metres.geojson")
    low_x, low_y, high_x, high_y = (np.array(metres.total_bounds) // 1000 + [0, 0, 1, 1]) * 1000
    x, y = (c.ravel() for c in np.meshgrid(np.arange(low_x, high_x, 1000), np.arange(low_y, high_y, 1000)))
    write(geopandas.GeoDataFrame({"cell": np.arange(len(x))}, geometry=shapely.box(x, y, x + 1000, y + 1000)),
          folder / "grid.geojson")
    middle = shapely.Point((low_x + high_x) / 2, (low_y + high_y) / 2)
    write(geopandas.GeoDataFrame({"window": [1]}, geometry=[middle.buffer(40_000, quad_segs=64)]),
          folder / "window.geojson")


def fires(oblast, folder):
    """The fire detections of six months as one layer; a row is a polygon with its month."""
    source = folder / "fires"
    if not source.exists():
        subprocess.run([oblast, "generate", "fires", "-q", "-o", source], check=True)
    parts = []
    for path in sorted(source.glob("*.shp")):
        frame = geopandas.read_file(path)[["geometry"]]
        frame["month"] = path.stem.split("-")[2]
        parts.append(frame)
    both = pandas.concat(parts, ignore_index=True).explode(ignore_index=True)
    both.geometry = shapely.make_valid(both.geometry.values)
    write(both, folder / "fires.geojson")


def parcels(folder):
    """100,000 parcels: the quadrilaterals of a grid whose corners were moved at random. Zones: 20,000 polygons."""
    random = np.random.default_rng(21)
    columns, rows = 400, 250
    corners = np.stack(np.meshgrid(np.arange(columns + 1.0), np.arange(rows + 1.0)), axis=-1)
    corners += random.uniform(-0.4, 0.4, corners.shape)
    rings = np.stack([corners[:-1, :-1], corners[:-1, 1:], corners[1:, 1:], corners[1:, :-1], corners[:-1, :-1]], axis=2)
    shapes = shapely.polygons(rings.reshape(-1, 5, 2) * 100)
    number = np.arange(len(shapes))
    columns_of_parcels = {"parcel": number, "block": number // 1000}
    write(geopandas.GeoDataFrame(columns_of_parcels, geometry=shapes), folder / "parcels-with-faults.geojson")
    valid = shapely.is_valid(shapes)
    shapes[~valid] = shapely.convex_hull(shapes[~valid])
    write(geopandas.GeoDataFrame(columns_of_parcels, geometry=shapes), folder / "parcels.geojson")
    count, vertices = 20_000, 24
    centres = random.uniform(0, 1, (count, 1, 2)) * [columns, rows]
    angles = np.sort(random.uniform(0, 2 * np.pi, (count, vertices)), axis=1)
    radii = random.uniform(0.5, 2.5, (count, vertices))
    stars = centres + radii[..., None] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    stars = np.concatenate([stars, stars[:, :1]], axis=1) * 100
    zones = shapely.make_valid(shapely.polygons(stars))
    write(geopandas.GeoDataFrame({"zone": np.arange(count)}, geometry=zones), folder / "zones.geojson")


def make(oblast, shared, folder, names=()):
    folder.mkdir(parents=True, exist_ok=True)
    makers = {"districts": lambda: germany(shared, folder), "communes": lambda: communes(shared, folder),
              "fires": lambda: fires(oblast, folder), "parcels": lambda: parcels(folder)}
    for first, maker in makers.items():
        if first in (names or makers) and not (folder / f"{first}.geojson").exists():
            print(f"making {first}", flush=True)
            maker()


if __name__ == "__main__":
    make(sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]), sys.argv[4:])
