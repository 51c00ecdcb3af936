"""with_duckdb.py QUERY OUTPUT INPUT...: prints the seconds of the query."""

import sys
import time
from pathlib import Path

import duckdb
import duckdb_extension_spatial

query, output, *inputs = sys.argv[1:]
extension = next(Path(duckdb_extension_spatial.__file__).parent.rglob("spatial.duckdb_extension"))
connection = duckdb.connect(config={"allow_unsigned_extensions": "true"})
connection.execute(f"LOAD '{extension}'")
for name, path in zip("ab", inputs):
    connection.execute(f"CREATE TABLE {name} AS SELECT * EXCLUDE (OGC_FID) FROM ST_Read('{path}')"
                       if "OGC_FID" in [c[0] for c in connection.execute(f"DESCRIBE SELECT * FROM ST_Read('{path}')").fetchall()]
                       else f"CREATE TABLE {name} AS SELECT * FROM ST_Read('{path}')")
begin = time.perf_counter()
connection.execute(f"CREATE TABLE result AS {query}")
print(time.perf_counter() - begin)
connection.execute(f"COPY result TO '{output}' WITH (FORMAT gdal, DRIVER 'GeoJSON', LAYER_CREATION_OPTIONS 'COORDINATE_PRECISION=17')")
