"""judge.py OUTPUT: prints the number of rows with an area, of invalid rows, and the sum of the areas."""

import json
import sys

import geopandas
import shapely

geometries = geopandas.read_file(sys.argv[1]).geometry.values
areas = shapely.area(geometries)
print(json.dumps({"rows": int((areas > 0).sum()), "invalid": int((~shapely.is_valid(geometries)).sum()),
                  "area": float(areas.sum())}))
