"""The jobs of bench/rows/run: what each tool is told to do. A key of `JOBS` is the name of a job."""

from dataclasses import dataclass


@dataclass
class Job:
    layers: list  # names without extension
    oblast: list  # arguments; {} is replaced by a layer's path
    geopandas: str = ""  # an expression over a, b, gpd
    duckdb: str = ""  # a query over the tables a, b
    mapshaper: list = None  # arguments between input and output


PAIRS = """SELECT a.* EXCLUDE geom, b.* EXCLUDE geom, ST_CollectionExtract(ST_Intersection(a.geom, b.geom), 3) AS geom
           FROM a JOIN b ON ST_Intersects(a.geom, b.geom)"""


def rest(of, other, columns):
    """What no row of the other layer covers."""
    return f"""SELECT {columns}, CASE WHEN c.geom IS NULL THEN {of}.geom ELSE
                 ST_CollectionExtract(ST_Difference({of}.geom, c.geom), 3) END AS geom
               FROM {of} LEFT JOIN (SELECT {of}.rowid AS id, ST_Union_Agg({other}.geom) AS geom FROM {of} JOIN {other}
                 ON ST_Intersects({of}.geom, {other}.geom) GROUP BY {of}.rowid) c ON {of}.rowid = c.id"""


def dissolved(column):
    return f"SELECT {column}, ST_Union_Agg(geom) AS geom FROM a GROUP BY {column}"


NOT_EMPTY = "SELECT * FROM ({}) WHERE NOT ST_IsEmpty(geom)"

JOBS = {
    "identity": Job(
        ["districts", "counties"],
        ["overlay", "identity", "{}", "{}"],
        "gpd.overlay(a, b, how='identity')",
        NOT_EMPTY.format(f"{PAIRS} UNION ALL {rest('a', 'b', 'a.* EXCLUDE geom, NULL')}"),
    ),
    "union": Job(
        ["districts", "counties"],
        ["overlay", "union", "{}", "{}"],
        "gpd.overlay(a, b, how='union')",
        NOT_EMPTY.format(f"{PAIRS} UNION ALL {rest('a', 'b', 'a.* EXCLUDE geom, NULL')}"
                      f" UNION ALL {rest('b', 'a', 'NULL, b.* EXCLUDE geom')}"),
        ["-union", "target=*"],
    ),
    "grid": Job(
        ["communes-metres", "grid"],
        ["overlay", "intersection", "{}", "{}"],
        "gpd.overlay(a, b, how='intersection')",
        NOT_EMPTY.format(PAIRS),
        ["-union", "target=*", "-filter", "code !== null && cell !== null"],
    ),
    "departements": Job(
        ["communes"],
        ["dissolve", "{}", "--by", "departement"],
        "a[['departement', 'geometry']].dissolve(by='departement')",
        dissolved("departement"),
        ["-dissolve", "departement"],
    ),
    "regions": Job(
        ["communes"],
        ["dissolve", "{}", "--by", "region"],
        "a[['region', 'geometry']].dissolve(by='region')",
        dissolved("region"),
        ["-dissolve", "region"],
    ),
    "months": Job(
        ["fires"],
        ["dissolve", "{}", "--by", "month"],
        "a.dissolve(by='month')",
        dissolved("month"),
        ["-dissolve", "month"],
    ),
    "depth": Job(
        ["fires"],
        ["depth", "{}"],
        mapshaper=["-mosaic", "calc=depth = count()", "-dissolve", "depth"],
    ),
    "parcels": Job(
        ["parcels", "zones"],
        ["overlay", "intersection", "{}", "{}"],
        "gpd.overlay(a, b, how='intersection')",
        NOT_EMPTY.format(PAIRS),
        ["-union", "target=*", "-filter", "parcel !== null && zone !== null"],
    ),
}
