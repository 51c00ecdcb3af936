"""The jobs of bench/program/run: what each tool is told to do with three pairs of layers.

Words in braces are replaced: {a}, {b}, {mask}, {faults} by the path of a layer, {out} by the output, {both} by a
GeoPackage with the layers a and b, which is made before, {by} by a column.
"""

from dataclasses import dataclass


@dataclass
class Job:
    a: str  # names of layers of bench/rows/layers.py
    b: str
    mask: str  # for clip and erase
    by: str  # a column of a
    faults: str  # for check and repair: of layers.py, or of the real layers, of which two have invalid features


JOBS = {
    "counties": Job("counties", "districts", "districts", "state", "russia-subjects"),
    "communes": Job("communes-metres", "grid", "window", "departement", "brazil-states"),
    "parcels": Job("parcels", "zones", "zones", "block", "parcels-with-faults"),
}

# What of b a feature of a needs, by the spatial index of the GeoPackage.
NEAR = ("b.fid IN (SELECT id FROM rtree_b_geom WHERE minx <= ST_MaxX(a.geom) AND maxx >= ST_MinX(a.geom) "
        "AND miny <= ST_MaxY(a.geom) AND maxy >= ST_MinY(a.geom))")
WITHOUT_B = (f"CASE WHEN EXISTS (SELECT 1 FROM b WHERE {NEAR} AND ST_Intersects(a.geom, b.geom)) THEN "
             f"ST_Difference(a.geom, (SELECT ST_Union(b.geom) FROM b WHERE {NEAR})) ELSE a.geom END")


def sql(text, source="{both}"):
    """SQL of SQLite with the functions of Spatialite: that of the GeoPackage itself, or GDAL's dialect."""
    dialect = [] if source in ("{both}", "{masked}") else ["-dialect", "SQLite"]
    return ["ogr2ogr", "-f", "GeoJSON", "-lco", "COORDINATE_PRECISION=17", "{out}", source, *dialect, "-sql", text]


def geopandas(code):
    return ["{python}", "{with_geopandas}", code, "{out}"]


def mapshaper(*words):
    return ["{mapshaper}", "-i", "{a}", *words, "-o", "{out}", "format=geojson"]


# By command and tool. A tool that has no such operation is left out.
COMMANDS = {
    "clip": {
        "oblast": ["clip", "{a}", "{mask}", "-o", "{out}"],
        "ogr2ogr": ["ogr2ogr", "-f", "GeoJSON", "-lco", "COORDINATE_PRECISION=17", "{out}", "{a}", "-clipsrc", "{mask}"],
        "mapshaper": mapshaper("-clip", "{mask}"),
        "geopandas": geopandas("gpd.clip(read('{a}'), read('{mask}'))"),
    },
    "erase": {
        "oblast": ["erase", "{a}", "{mask}", "-o", "{out}"],
        "ogr2ogr": sql(f"SELECT a.{{by}}, {WITHOUT_B} AS geom FROM a", "{masked}"),
        "mapshaper": mapshaper("-erase", "{mask}"),
        "geopandas": geopandas("gpd.overlay(read('{a}'), read('{mask}'), how='difference')"),
    },
    "dissolve": {
        "oblast": ["dissolve", "{a}", "--by", "{by}", "-o", "{out}"],
        "ogr2ogr": sql("SELECT {by}, ST_Union(geom) AS geom FROM a GROUP BY {by}"),
        "mapshaper": mapshaper("-dissolve", "{by}"),
        "geopandas": geopandas("read('{a}')[['{by}', 'geometry']].dissolve(by='{by}')"),
    },
    "identity": {
        "oblast": ["overlay", "identity", "{a}", "{b}", "-o", "{out}"],
        "ogr2ogr": sql(f"SELECT a.{{by}}, b.fid AS other, ST_CollectionExtract(ST_Intersection(a.geom, b.geom), 3) "
                       f"AS geom FROM a JOIN b ON {NEAR} AND ST_Intersects(a.geom, b.geom) "
                       f"UNION ALL SELECT a.{{by}}, NULL, {WITHOUT_B} FROM a"),
        "geopandas": geopandas("gpd.overlay(read('{a}'), read('{b}'), how='identity')"),
    },
    "check": {
        "oblast": ["check", "{faults}"],
        "ogr2ogr": sql("SELECT ST_IsValidReason(geometry) AS reason FROM \"{faults_name}\" WHERE NOT "
                       "ST_IsValid(geometry)", "{faults}"),
        "geopandas": geopandas("invalid(read('{faults}'))"),
    },
    "repair": {
        "oblast": ["repair", "{faults}", "-o", "{out}"],
        "ogr2ogr": ["ogr2ogr", "-f", "GeoJSON", "-lco", "COORDINATE_PRECISION=17", "{out}", "{faults}", "-makevalid"],
        "mapshaper": ["{mapshaper}", "-i", "{faults}", "-clean", "-o", "{out}", "format=geojson"],
        "geopandas": geopandas("made_valid(read('{faults}'))"),
    },
}
