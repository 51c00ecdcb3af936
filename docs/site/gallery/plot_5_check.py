"""
A proof by check
================

Is a result right? ``oblast.check`` does not trust the overlay that computed it. It proves by exact arithmetic that edges meet
only at common ends, that rings are closed and turned as they should be, and that polygons do not overlap; or it names the
first fault.
"""

import os
from pathlib import Path

import geopandas as gpd
import matplotlib.pyplot as plt
import numpy as np
import shapely

import oblast

folder = Path(os.environ["OBLAST_SHARED"]) / "realworld"
municipalities = gpd.read_file(folder / "italy-municipalities-r5.geojson")
regions = gpd.read_file(folder / "italy-regions.geojson")

# %%
# A layer as it was published. Its municipalities overlap in places: to see it takes exact arithmetic, not sharp eyes.

report = oblast.check(municipalities.geometry)
print(bool(report), report.kind)
print(report.message)
print("rows", report.row, "and", report.other[0])

# %%
# Its union with the regions is proved as a whole, and so is that no area was lost:
# union and intersection together have the area of both operands.

a, b = oblast.union_all(municipalities.geometry), oblast.union_all(regions.geometry)
union, common = oblast.union(a, b), oblast.intersection(a, b)
for name, result in (("union", union), ("intersection", common)):
    print(f"{name}: {len(result.points)} vertices, {oblast.check(result, canonical=True).message}")
print(f"difference of the areas: {abs(union.area + common.area - a.area - b.area):.1e} of {union.area:.3f}")

# %%
# Now let somebody move one vertex of the result by one unit in the last place. The proof finds it.

points = union.points.copy()
edge = np.diff(union.ring_offsets).argmax()
first = union.ring_offsets[edge]
points[first + 1] = points[first + 5] = np.nextafter(points[first + 5], np.inf)
broken = oblast.from_ragged(points, union.ring_offsets, union.polygon_offsets)
found = oblast.check(broken)
print(found.kind, "at", found.point)

# %%
# The place of the first fault of the published layer.

x, y = report.point
figure, (whole, near) = plt.subplots(1, 2, figsize=(10, 4.2))
municipalities.plot(ax=whole, color="#cfd8dc", edgecolor="white", linewidth=0.3)
whole.plot(x, y, "o", markersize=12, fillstyle="none", color="#c62828")
whole.set_title(f"{len(municipalities)} municipalities")
pair = municipalities.iloc[[report.row, report.other[0]]]
pair.plot(ax=near, color=["#f2a541", "#8fb8de"], alpha=0.6, edgecolor="#37474f")
near.plot(x, y, "o", color="#c62828")
size = 0.01
near.set(xlim=(x - size, x + size), ylim=(y - size, y + size), title=report.kind)
for axis in (whole, near):
    axis.set_aspect(1.35)
    axis.set_axis_off()
figure.tight_layout()
