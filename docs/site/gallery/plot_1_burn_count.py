"""
How often places burnt
======================

Satellites see a fire again and again. A month of their detections is a pile of polygons that overlap, up to hundreds
of them in one place. ``oblast.depth`` counts in one pass how many of them cover each place.
"""

# %%
# A folder of shapefiles, one for each pass of a satellite, written by ``oblast generate fires --month april``.

import os
from pathlib import Path

import geopandas as gpd
import matplotlib.pyplot as plt
import pandas as pd
import shapely

import oblast

files = sorted(Path(os.environ["OBLAST_FIRES"]).glob("*.shp"))
fires = pd.concat([gpd.read_file(file) for file in files], ignore_index=True)
print(len(files), "files,", len(fires), "detections")

# %%
# One row for each depth. The detections overlap, cross and share borders; the rows do not overlap.

with oblast.statistics() as s:
    counted = oblast.depth(fires.geometry)
print(f"{s.intersections} intersections, {s.rounds} rounds, {sum(s.seconds.values()):.2f} s")

depth = gpd.GeoDataFrame({"times": counted.depth}, geometry=counted.regions.to_shapely(), crs=fires.crs)
depth["parts"] = shapely.get_num_geometries(depth.geometry)
print(depth[["times", "parts"]].head(5).to_string(index=False))

# %%
# The whole month, and the place that burnt most often.

russia = gpd.read_file(Path(os.environ["OBLAST_SHARED"]) / "realworld/russia-subjects.geojson")
most = depth.geometry.iloc[-1].representative_point()

figure, (whole, near) = plt.subplots(1, 2, figsize=(10, 3.8), width_ratios=[2, 1])
russia.plot(ax=whole, color="#dfe5e8", edgecolor="white", linewidth=0.4)
depth.plot(ax=whole, color="#d84315", edgecolor="#d84315", linewidth=0.8)
whole.plot(most.x, most.y, "o", markersize=14, fillstyle="none", color="black")
whole.set(xlim=(25, 145), ylim=(41, 72), title=f"{len(fires)} detections of April")
part = depth.cx[most.x - 0.12 : most.x + 0.12, most.y - 0.08 : most.y + 0.08]
part.plot(ax=near, column="times", cmap="YlOrRd", legend=True, legend_kwds={"shrink": 0.8})
near.set(xlim=(most.x - 0.12, most.x + 0.12), ylim=(most.y - 0.08, most.y + 0.08))
near.set_title(f"up to {counted.depth.max()} times in one place")
for axis in (whole, near):
    axis.set_aspect(1.7)
    axis.set_axis_off()
figure.tight_layout()
