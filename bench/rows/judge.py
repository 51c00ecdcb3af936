"""judge.py OUTPUT: prints the number of features, of rows with an area, of invalid rows, and the sum of the areas."""

import json
import sys

import geopandas
import shapely

frame = geopandas.read_file(sys.argv[1])
features = len(frame)
geometries = frame.geometry.dropna().values if "geometry" in frame else geopandas.array.from_shapely([])
areas = shapely.area(geometries)
print(json.dumps({"features": features, "rows": int((areas > 0).sum()), "invalid": int((~shapely.is_valid(geometries)).sum()),
                  "area": float(areas.sum())}))
