"""The shapes of bench/buffers as shapely geometries, and the file that the drivers read (shape_file.h)."""

import subprocess
from pathlib import Path

import geopandas
import numpy as np
import shapely


def parts(geometries):
    return shapely.get_parts(np.asarray(geometries))


def rings_of(polygons):
    """The points of all rings without their repeated last points, and where rings and polygons end."""
    kind, coordinates, (ring_offsets, polygon_offsets) = shapely.to_ragged_array(polygons)
    assert kind == shapely.GeometryType.POLYGON
    keep = np.ones(len(coordinates), bool)
    keep[ring_offsets[1:] - 1] = False
    return coordinates[keep, :2], (ring_offsets[1:] - np.arange(1, len(ring_offsets))), polygon_offsets[1:]


def write(path, geometries):
    types = shapely.get_type_id(geometries)
    polygons, lines, points = geometries[types == 3], geometries[types == 1], geometries[types == 0]
    nothing = np.empty((0, 2)), np.empty(0, np.uint64), np.empty(0, np.uint64)
    region_points, contour_ends, polygon_ends = rings_of(polygons) if len(polygons) else nothing
    line_points, line_of = shapely.get_coordinates(lines, return_index=True)
    line_ends = np.cumsum(np.bincount(line_of, minlength=len(lines)))
    single = shapely.get_coordinates(points)
    counts = [len(a) for a in (region_points, contour_ends, polygon_ends, line_points, line_ends, single)]
    with open(path, "wb") as file:
        file.write(np.array(counts, np.uint64).tobytes())
        for array in (region_points, line_points, single):
            file.write(np.ascontiguousarray(array, np.float64).tobytes())
        for array in (contour_ends, polygon_ends, line_ends):
            file.write(np.asarray(array, np.uint64).tobytes())


def read_polygons(path):
    """The polygons of a result."""
    with open(path, "rb") as file:
        counts = np.fromfile(file, np.uint64, 6).astype(int)
        points = np.fromfile(file, np.float64, 2 * counts[0]).reshape(-1, 2)
        contour_ends = np.fromfile(file, np.uint64, counts[1]).astype(np.int64)
        polygon_ends = np.fromfile(file, np.uint64, counts[2]).astype(np.int64)
    starts = np.concatenate([[0], contour_ends[:-1]])
    order = np.insert(np.arange(len(points)), contour_ends, starts)  # each ring closed by its first point
    ring_offsets = np.concatenate([[0], contour_ends + np.arange(1, len(contour_ends) + 1)])
    polygon_offsets = np.concatenate([[0], polygon_ends])
    return shapely.from_ragged_array(shapely.GeometryType.POLYGON, points[order], (ring_offsets, polygon_offsets))


def layer(shared, name, crs=None):
    frame = geopandas.read_file(shared / "realworld" / f"{name}.geojson")
    return parts((frame.to_crs(crs) if crs else frame).geometry)


def generated(program, path, *arguments):
    if not path.exists():
        subprocess.run([program, "generate", *arguments, "-o", path], check=True)
    return path


def points(count):
    return shapely.points(np.random.default_rng(1).random((count, 2)))


def roads(program, folder, count):
    path = generated(program, folder / f"roads-{count}.gpkg", "roads", "--segments", str(count))
    return parts(geopandas.read_file(path).geometry)


def fires(program, folder):
    path = folder / "fires"
    if not path.exists():
        subprocess.run([program, "generate", "fires", "-o", path, "-q"], check=True)
    frames = [geopandas.read_file(file).geometry for file in sorted(path.glob("*.shp"))]
    return parts(np.concatenate([np.asarray(frame) for frame in frames]))
