"""Many pairs, at once and by a call each; a job is a generator as one.py describes."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
from inputs import MICRO, SCALE, layer, lists, polygons_only, ring_area, shapely_polygons

CORES = 2


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
