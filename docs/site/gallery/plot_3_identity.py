"""
Districts cut by counties
=========================

The same land at two resolutions: districts of Germany with 45,827 vertices, and counties with 40,433. Their borders follow
each other and cross thousands of times, so an overlay is full of slivers. This is what makes overlays slow, and what makes
them fail.
"""

import os
import time
from pathlib import Path

import geopandas as gpd
import matplotlib.pyplot as plt
import numpy as np

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
# The rows are exactly the districts again: their areas add up, and they do not overlap. All rows are proved together.

print(f"area of the districts {districts.area.sum():.12f}")
print(f"area of our rows      {ours.area.sum():.12f}")
print("our rows:  ", oblast.check(ours.geometry).message)
print("geopandas':", oblast.check(theirs.geometry).message)

# %%
# Most rows are slivers: here by their area, and a place where two borders follow each other.

figure, (chart, place) = plt.subplots(1, 2, figsize=(10, 4.2))
chart.hist(np.log10(ours.area[ours.area > 0]), bins=60, color="#2d6ca2")
chart.set(xlabel="log10 of the area in square degrees", ylabel="rows", title=f"{len(ours)} rows")
x, y = districts.geometry.iloc[10].exterior.coords[40] if districts.geometry.iloc[10].geom_type == "Polygon" else (
    districts.geometry.iloc[10].geoms[0].exterior.coords[40]
)
ours.plot(ax=place, column=np.arange(len(ours)) % 9, cmap="Pastel1")
districts.boundary.plot(ax=place, color="#37474f", linewidth=1.2)
counties.boundary.plot(ax=place, color="#c62828", linewidth=0.8)
place.set(xlim=(x - 0.06, x + 0.06), ylim=(y - 0.04, y + 0.04), title="districts (grey) and counties (red)")
place.set_aspect(1.5)
place.set_xticks([])
place.set_yticks([])
figure.tight_layout()
