"""
A union that GEOS gets wrong
============================

Two quadrilaterals lie side by side. Their shared border is not quite the same in both: two of the corners differ in
the last bits. GEOS 3.14 unites them to one of the two, without an error (`shapely issue 2368
<https://github.com/shapely/shapely/issues/2368>`_).
"""

import geopandas as gpd
import matplotlib.pyplot as plt
import shapely

import oblast

left = shapely.Polygon(
    [
        (-314.80537142831986, 3.7479731838338695),
        (-314.64218025800653, -2.7900491087570383),
        (-295.08711234218333, -2.301948231163383),
        (-295.25030351249666, 4.236074061427525),
    ]
)
right = shapely.Polygon(
    [
        (-295.25030351249666, 4.236074061427525),
        (-295.08711234218333, -2.3019482311633825),
        (-275.53204442636013, -1.8138473535697273),
        (-275.69523559667346, 4.7241749390211805),
    ]
)
theirs = shapely.union(left, right)
ours = oblast.union(left, right)

print(f"left {left.area:.3f} + right {right.area:.3f}")
print(f"GEOS {shapely.geos_version_string}: {theirs.area:.3f}")
print(f"oblast:      {ours.area:.3f}, {oblast.check(ours).message}")

# %%

figure, axes = plt.subplots(1, 3, figsize=(10, 2), sharey=True)
gpd.GeoSeries([left, right]).plot(ax=axes[0], color=["#8fb8de", "#f2a541"], edgecolor="#37474f")
axes[0].set_title(f"given: {left.area:.1f} and {right.area:.1f}")
gpd.GeoSeries([theirs]).plot(ax=axes[1], color="#c62828", edgecolor="#37474f")
axes[1].set_title(f"GEOS: {theirs.area:.1f}")
gpd.GeoSeries(ours.to_shapely()).plot(ax=axes[2], color="#6aa84f", edgecolor="#37474f")
axes[2].set_title(f"oblast: {ours.area:.1f}")
for axis in axes:
    axis.set(xlim=(-317, -273), ylim=(-5, 7))
    axis.set_axis_off()
figure.tight_layout()

# %%
# GEOS rounds crossings while it decides, and snaps vertices if the pieces do not fit together; here one of the two
# polygons is lost on the way. oblast decides by exact arithmetic which point lies on which side, and rounds a new
# vertex only at the end.
