"""The union of the fires; a job is a generator as one.py describes."""

import numpy as np
from inputs import MICRO, SCALE, layer, lists, polygons_only, ring_area, shapely_polygons


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
