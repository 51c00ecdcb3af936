"""
Millions of pairs
=================

Often one does not want the overlay of two layers, but of many pairs: each building with each parcel, each cell with
each field. A loop in Python spends its time on the loop. ``oblast.overlay_pairs`` takes the numbers of all pairs, and
makes all overlays in C++ on all cores.
"""

import os
import time
from pathlib import Path

import geopandas as gpd
import matplotlib.pyplot as plt
import numpy as np
import shapely

import oblast

# %%
# All communes of Normandie, and a grid of cells. Which of them meet says the index of shapely.

folder = Path(os.environ["OBLAST_SHARED"]) / "realworld"
communes = gpd.read_file(folder / "france-communes-normandie.geojson").to_crs("EPSG:2154")
x0, y0, x1, y1 = communes.total_bounds
size = 200
x, y = np.meshgrid(np.arange(x0, x1, size), np.arange(y0, y1, size))
cells = shapely.box(x.ravel(), y.ravel(), x.ravel() + size, y.ravel() + size)
i, j = shapely.STRtree(communes.geometry.values).query(cells, predicate="intersects")[::-1]
print(f"{len(communes)} communes, {len(cells)} cells, {len(i)} pairs")

# %%
# Convert once, then overlay all pairs.

begin = time.perf_counter()
a, b = oblast.from_shapely(communes.geometry.values), oblast.from_shapely(cells)
middle = time.perf_counter()
parts = oblast.overlay_pairs(a, b, i, j, "intersection")
end = time.perf_counter()
print(f"conversion {middle - begin:.2f} s, overlay {end - middle:.2f} s")
print(f"overlay: {1e6 * (end - middle) / len(i):.2f} microseconds a pair")

# %%
# The same in shapely for the first 100,000 pairs.

some = slice(100_000)
begin = time.perf_counter()
theirs = shapely.intersection(communes.geometry.values[i[some]], cells[j[some]])
seconds = time.perf_counter() - begin
print(f"shapely: {1e6 * seconds / len(theirs):.2f} microseconds a pair")

# %%
# Nothing is lost: the parts of a commune add up to it.

areas = np.zeros(len(communes))
np.add.at(areas, i, shapely.area(parts.to_shapely()))
print(f"largest difference: {np.abs(areas / communes.area - 1).max():.1e} of a commune")

# %%
# A commune and its parts.

chosen = 1200
shapes = gpd.GeoDataFrame(geometry=parts[np.flatnonzero(i == chosen)].to_shapely())
figure, axis = plt.subplots(figsize=(9, 4.5))
shapes.plot(ax=axis, column=shapes.area, cmap="Blues", edgecolor="white", linewidth=0.4)
communes.iloc[[chosen]].boundary.plot(ax=axis, color="#37474f")
axis.set_title(f"{communes.nom.iloc[chosen]}: {len(shapes)} parts")
axis.set_axis_off()
figure.tight_layout()
