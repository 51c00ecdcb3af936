"""One job by one tool in a fresh process: jobs that unite one layer of fires, or overlay pairs.

A job is a generator. It yields when its input is loaded, when the input is in the tool's natural types, when the
operation is done, and when the result is in arrays, or in geometries if the caller had geometries. Then it yields
what to compare.
"""

import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "peers"))
from workload_file import read_workload

CORES = 2
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


def fires_oblast(folder):
    import oblast

    (points, offsets), _ = layer(folder, "fires")
    yield
    regions = oblast.from_ragged(points, offsets)
    yield
    result = oblast.union_all(regions)
    yield
    arrays = result.points, result.ring_offsets
    yield
    yield result.area, len(arrays[0])


def fires_oblast_geopandas(folder):
    """Shapely geometries in and out."""
    import geopandas

    import oblast.geopandas

    (points, offsets), _ = layer(folder, "fires")
    series = geopandas.GeoSeries(shapely_polygons(points, offsets))
    yield
    yield
    with oblast.geopandas.install():
        result = series.union_all()
    yield
    yield
    yield result.area, None


def fires_geopandas(folder):
    import geopandas

    (points, offsets), _ = layer(folder, "fires")
    series = geopandas.GeoSeries(shapely_polygons(points, offsets))
    yield
    yield
    result = series.union_all()
    yield
    yield
    yield result.area, None


def fires_shapely(folder):
    import shapely

    (points, offsets), _ = layer(folder, "fires")
    yield
    polygons = shapely_polygons(points, offsets)
    yield
    result = shapely.union_all(polygons)
    yield
    parts = polygons_only(result)
    arrays = shapely.to_ragged_array(parts)
    yield
    yield shapely.area(parts).sum(), len(arrays[1])


def fires_pyclipper(folder):
    import pyclipper

    (points, offsets), _ = layer(folder, "fires")
    yield
    paths = pyclipper.scale_to_clipper(lists(points, offsets), SCALE)
    yield
    clipper = pyclipper.Pyclipper()
    clipper.AddPaths(paths, pyclipper.PT_SUBJECT, True)
    result = clipper.Execute(pyclipper.CT_UNION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)
    yield
    rings = [np.array(ring) / SCALE for ring in result]
    yield
    yield ring_area(rings), sum(map(len, rings))


def fires_pyclipr(folder):
    import pyclipr

    (points, offsets), _ = layer(folder, "fires")
    yield
    paths = lists(points, offsets)
    yield
    clipper = pyclipr.Clipper()
    clipper.scaleFactor = MICRO
    clipper.addPaths(paths, pyclipr.Subject)
    result = clipper.execute(pyclipr.Union, pyclipr.FillRule.NonZero)
    yield
    points = np.concatenate(result)
    yield
    yield ring_area(result), len(points)


def fires_sedonadb(folder):
    import geopandas
    import sedonadb

    (points, offsets), _ = layer(folder, "fires")
    frame = geopandas.GeoDataFrame(geometry=shapely_polygons(points, offsets))
    yield
    connection = sedonadb.connect()
    connection.create_data_frame(frame).to_memtable().to_view("a")
    yield
    table = connection.sql("SELECT ST_Union_Agg(geometry) AS geometry FROM a").to_memtable()
    yield
    geometries = table.to_pandas().geometry
    yield
    yield geometries.area.sum(), None


def pairs_oblast(folder, name="pairs"):
    import oblast

    a, b = layer(folder, name)
    yield
    left, right = oblast.from_ragged(*a), oblast.from_ragged(*b)
    yield
    result = oblast.overlay_pairs(left, right)
    yield
    arrays = result.points, result.ring_offsets
    yield
    yield result.area, len(arrays[0])


def pairs_shapely(folder):
    """On all cores: shapely's functions release the interpreter's lock."""
    import shapely

    a, b = layer(folder, "pairs")
    yield
    left, right = shapely_polygons(*a), shapely_polygons(*b)
    yield
    parts = np.array_split(np.arange(len(left)), CORES)
    with ThreadPoolExecutor(CORES) as pool:
        result = np.concatenate(list(pool.map(lambda part: shapely.intersection(left[part], right[part]), parts)))
    yield
    parts = polygons_only(result)
    arrays = shapely.to_ragged_array(parts)
    yield
    yield shapely.area(parts).sum(), len(arrays[1])


def pairs_pyclipper(folder, name="pairs"):
    import pyclipper

    a, b = layer(folder, name)
    yield
    left, right = (pyclipper.scale_to_clipper(lists(*one), SCALE) for one in (a, b))
    yield
    result = []
    for subject, clip in zip(left, right, strict=True):
        clipper = pyclipper.Pyclipper()
        clipper.AddPath(subject, pyclipper.PT_SUBJECT, True)
        clipper.AddPath(clip, pyclipper.PT_CLIP, True)
        result.append(clipper.Execute(pyclipper.CT_INTERSECTION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO))
    yield
    rings = [np.array(ring) / SCALE for rings in result for ring in rings]
    yield
    yield ring_area(rings), sum(map(len, rings))


def pairs_pyclipr(folder, name="pairs"):
    import pyclipr

    a, b = layer(folder, name)
    yield
    left, right = lists(*a), lists(*b)
    yield
    result = []
    for subject, clip in zip(left, right, strict=True):
        clipper = pyclipr.Clipper()
        clipper.scaleFactor = MICRO
        clipper.addPath(subject, pyclipr.Subject)
        clipper.addPath(clip, pyclipr.Clip)
        result.append(clipper.execute(pyclipr.Intersection, pyclipr.FillRule.NonZero))
    yield
    rings = [ring for rings in result for ring in rings]
    points = np.concatenate(rings)
    yield
    yield ring_area(rings), len(points)


def pairs_sedonadb(folder):
    import geopandas
    import sedonadb

    a, b = layer(folder, "pairs")
    frame = geopandas.GeoDataFrame({"b": geopandas.GeoSeries(shapely_polygons(*b))}, geometry=shapely_polygons(*a))
    yield
    connection = sedonadb.connect()
    connection.create_data_frame(frame).to_memtable().to_view("a")
    yield
    table = connection.sql("SELECT ST_Intersection(geometry, b) AS geometry FROM a").to_memtable()
    yield
    geometries = table.to_pandas().geometry
    yield
    yield geometries.area.sum(), None


def calls_oblast(folder):
    import oblast

    a, b = layer(folder, "calls")
    left, right = list(oblast.from_ragged(*a)), list(oblast.from_ragged(*b))
    yield
    yield
    result = [oblast.intersection(x, y) for x, y in zip(left, right, strict=True)]
    yield
    yield
    yield sum(r.area for r in result), None


def calls_shapely(folder):
    import shapely

    a, b = layer(folder, "calls")
    left, right = shapely_polygons(*a), shapely_polygons(*b)
    yield
    yield
    result = [shapely.intersection(x, y) for x, y in zip(left, right, strict=True)]
    yield
    yield
    yield sum(r.area for r in result), None


def calls_pyclipper(folder):
    yield from pairs_pyclipper(folder, "calls")


def calls_pyclipr(folder):
    yield from pairs_pyclipr(folder, "calls")
