"""
A proof by check
================

Is a result right? ``oblast.check`` does not trust the overlay that computed it. It proves by exact arithmetic that
edges meet only at common ends, that rings are closed and turned as they should be, and that polygons do not overlap;
or it names the first fault.
"""

import os
from pathlib import Path

import geopandas as gpd
import matplotlib.pyplot as plt
import numpy as np
import shapely

import oblast

# %%
# A layer as it was published: the 83 subjects of Russia. Some of its rows cross themselves.

folder = Path(os.environ["OBLAST_SHARED"]) / "realworld"
subjects = gpd.read_file(folder / "russia-subjects.geojson")
rows = shapely.orient_polygons(subjects.geometry.values)  # rings turned as they should be
reports = [oblast.check(row) for row in rows]
faulty = [i for i, report in enumerate(reports) if not report]
print(len(faulty), "of", len(subjects), "rows have a fault")
for i in faulty[:3]:
    print(subjects.name[i], "-", reports[i].kind, "at", reports[i].point)

# %%
# ``repair`` resolves each row by itself. It decides what is inside, and moves no vertex. The proof holds for all of
# them.

repaired = oblast.repair(subjects.geometry)
print("now valid:", sum(bool(oblast.check(row)) for row in repaired), "of", len(repaired))

# %%
# An overlay: the union of all subjects. The proof covers its whole boundary, and its canonical order, too.

union = oblast.union_all(repaired)
print(len(union.points), "vertices,", oblast.check(union, canonical=True).message)

# %%
# Now let somebody save it with five digits behind the point. It looks the same. The proof finds the first place that
# broke.

rounded = oblast.from_ragged(np.round(union.points, 5), union.ring_offsets, union.polygon_offsets)
print(oblast.check(rounded).message)

# %%
# The first fault of the published layer.

row = faulty[0]
x, y = reports[row].point
size = 0.004
figure, (whole, near) = plt.subplots(1, 2, figsize=(10, 4), width_ratios=[2, 1])
subjects.plot(ax=whole, color="#cfd8dc", edgecolor="white", linewidth=0.3)
subjects.iloc[faulty].plot(ax=whole, color="#f2a541", edgecolor="white", linewidth=0.3)
whole.plot(x, y, "o", markersize=12, fillstyle="none", color="#c62828")
whole.set(xlim=(19, 190), ylim=(40, 82), aspect=2, title=f"{len(faulty)} rows with a fault")
subjects.boundary.iloc[[row]].plot(ax=near, color="#37474f", linewidth=1)
near.plot(x, y, "o", color="#c62828")
near.set(xlim=(x - size, x + size), ylim=(y - size / 2, y + size / 2), aspect=2)
near.set_title(f"{subjects.name[row]}: {reports[row].kind}")
for axis in (whole, near):
    axis.set_axis_off()
figure.tight_layout()
