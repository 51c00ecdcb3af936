"""
Districts cut by counties
=========================

The same land at two resolutions: districts of Germany with 45,827 vertices, and counties with 40,433. Their borders
follow each other and cross thousands of times, so an overlay is full of slivers. This is what makes overlays slow,
and what makes them fail.
"""

import os
import time
from pathlib import Path

import geopandas as gpd
import matplotlib.pyplot as plt
import numpy as np
import shapely

import oblast
from oblast import geopandas as og

folder = Path(os.environ["OBLAST_SHARED"]) / "realworld"
districts = gpd.read_file(folder / "germany-districts-high.geojson")
counties = gpd.read_file(folder / "germany-counties-medium.geojson")

# %%
# Identity: all of the districts, cut by the counties. One import line differs.

begin = time.perf_counter()
ours = og.overlay(districts, counties, how="identity", keep_geom_type=True)
middle = time.perf_counter()
theirs = gpd.overlay(districts, counties, how="identity", keep_geom_type=True)
end = time.perf_counter()
print(f"oblast    {middle - begin:6.2f} s  {len(ours)} rows")
print(f"geopandas {end - middle:6.2f} s  {len(theirs)} rows")

# %%
# Do the rows cover the districts, no more and no less? The difference is of the order of rounding. And each row is
# proved valid. (Rows may overlap: the counties of this layer do, in 0.06 square degrees.)

for name, rows in (("oblast", ours), ("geopandas", theirs)):
    differs = oblast.symmetric_difference(rows.geometry, districts.geometry)
    print(f"{name}: the rows differ from the districts by {differs.area:.1e} square degrees")
proved = sum(bool(oblast.check(row)) for row in ours.geometry)
print(f"{proved} of {len(ours)} rows are proved valid")

# %%
# More than half of the rows are slivers: here by their area, and a place where two borders follow each other.

areas = shapely.area(ours.geometry.values)
x, y = shapely.get_coordinates(districts.geometry.iloc[10])[40]

figure, (chart, place) = plt.subplots(1, 2, figsize=(10, 4))
chart.hist(np.log10(areas), bins=60, color="#2d6ca2")
chart.set(xlabel="log10 of the area in square degrees", ylabel="rows", title=f"{len(ours)} rows")
ours.plot(ax=place, column=np.arange(len(ours)) % 9, cmap="Pastel1")
districts.boundary.plot(ax=place, color="#37474f", linewidth=1.2)
counties.boundary.plot(ax=place, color="#c62828", linewidth=0.8)
place.set(xlim=(x - 0.08, x + 0.08), ylim=(y - 0.05, y + 0.05))
place.set(xticks=[], yticks=[], aspect=1.5, title="districts (grey) and counties (red)")
figure.tight_layout()
