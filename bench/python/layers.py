"""Jobs on layers with attributes; a job is a generator as one.py describes."""

import os
import warnings
from pathlib import Path

import geopandas
import pandas
import shapely

warnings.filterwarnings("ignore")
DATA = Path(os.environ["OBLAST_SHARED"]) / "realworld"


def germany():
    return (
        geopandas.read_file(DATA / "germany-districts-high.geojson"),
        geopandas.read_file(DATA / "germany-counties-medium.geojson"),
    )


def communes():
    files = ("france-communes-hauts-de-france.geojson", "france-communes-normandie.geojson")
    frame = pandas.concat([geopandas.read_file(DATA / file) for file in files], ignore_index=True)
    frame["departement"] = frame["code"].str[:2]
    return frame[["departement", "geometry"]]


def answer(geometries):
    return shapely.area(geometries).sum(), len(geometries)


def identity_oblast(_folder):
    import oblast

    a, b = germany()
    yield
    left, right = oblast.from_shapely(a.geometry), oblast.from_shapely(b.geometry)
    yield
    rows = oblast.overlay_features(left, right, "identity")
    yield
    geometries = rows.regions.to_shapely()
    yield
    yield answer(geometries)


def identity_oblast_geopandas(_folder):
    from oblast import geopandas as og

    a, b = germany()
    yield
    yield
    result = og.overlay(a, b, how="identity", keep_geom_type=True)
    yield
    yield
    yield answer(result.geometry)


def identity_geopandas(_folder):
    a, b = germany()
    yield
    yield
    result = geopandas.overlay(a, b, how="identity", keep_geom_type=True)
    yield
    yield
    yield answer(result.geometry)


# What both cover, and what of the first layer no row of the second one covers.
IDENTITY = """
WITH pairs AS (SELECT a.i AS i, b.j AS j, a.geometry AS g, b.geometry AS h FROM a JOIN b
               ON ST_Intersects(a.geometry, b.geometry)),
     covered AS (SELECT i, ST_Union_Agg(h) AS h FROM pairs GROUP BY i)
SELECT i, j, ST_Intersection(g, h) AS geometry FROM pairs
UNION ALL
SELECT a.i, NULL AS j, ST_Difference(a.geometry, covered.h) AS geometry FROM a JOIN covered ON a.i = covered.i
"""


def identity_sedonadb(_folder):
    import sedonadb

    a, b = germany()
    a, b = a[["geometry"]].assign(i=range(len(a))), b[["geometry"]].assign(j=range(len(b)))
    yield
    connection = sedonadb.connect()
    connection.create_data_frame(a).to_memtable().to_view("a")
    connection.create_data_frame(b).to_memtable().to_view("b")
    yield
    table = connection.sql(IDENTITY).to_memtable()
    yield
    geometries = table.to_pandas().geometry
    yield
    yield answer(geometries[shapely.area(geometries) > 0])


def dissolve_oblast(_folder):
    import oblast

    frame = communes()
    yield
    regions = oblast.from_shapely(frame.geometry)
    yield
    rows = oblast.dissolve(regions, frame["departement"].to_numpy(dtype=str))
    yield
    geometries = rows.regions.to_shapely()
    yield
    yield answer(geometries)


def dissolve_oblast_geopandas(_folder):
    from oblast import geopandas as og

    frame = communes()
    yield
    yield
    result = og.dissolve(frame, by="departement")
    yield
    yield
    yield answer(result.geometry)


def dissolve_geopandas(_folder):
    frame = communes()
    yield
    yield
    result = frame.dissolve(by="departement")
    yield
    yield
    yield answer(result.geometry)


def dissolve_sedonadb(_folder):
    import sedonadb

    frame = communes()
    yield
    connection = sedonadb.connect()
    connection.create_data_frame(frame).to_memtable().to_view("a")
    yield
    query = "SELECT departement, ST_Union_Agg(geometry) AS geometry FROM a GROUP BY departement"
    table = connection.sql(query).to_memtable()
    yield
    geometries = table.to_pandas().geometry
    yield
    yield answer(geometries)
