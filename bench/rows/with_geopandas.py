"""with_geopandas.py EXPRESSION OUTPUT INPUT...: prints the seconds of the expression."""

import sys
import time
import warnings

import geopandas as gpd

warnings.filterwarnings("ignore")
expression, output, *inputs = sys.argv[1:]
layers = dict(zip("ab", [gpd.read_file(path) for path in inputs]))
begin = time.perf_counter()
result = eval(expression, {"gpd": gpd, **layers})
print(time.perf_counter() - begin)
result.to_file(output, driver="GeoJSON", COORDINATE_PRECISION=17)
