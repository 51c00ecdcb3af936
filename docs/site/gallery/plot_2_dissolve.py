"""
Communes to departements
========================

Communes share their borders. Uniting them by departement removes the inner borders, and nothing else: what remains
are the same vertices, bit for bit.
"""

import os
import time
from pathlib import Path

import geopandas as gpd
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import shapely

import oblast
from oblast import geopandas as og

folder = Path(os.environ["OBLAST_SHARED"]) / "realworld"
files = ["france-communes-hauts-de-france.geojson", "france-communes-normandie.geojson"]
communes = pd.concat([gpd.read_file(folder / file) for file in files], ignore_index=True)
communes["departement"] = communes["code"].str[:2]
count = shapely.get_num_coordinates(communes.geometry).sum()
print(f"{len(communes)} communes, {count} vertices")

# %%
# ``og.dissolve`` has the signature of ``GeoDataFrame.dissolve``.

begin = time.perf_counter()
ours = og.dissolve(communes, by="departement", aggfunc={"nom": "count"})
middle = time.perf_counter()
theirs = communes.dissolve(by="departement", aggfunc={"nom": "count"})
end = time.perf_counter()
print(f"oblast {middle - begin:.2f} s, geopandas {end - middle:.2f} s")
print(ours.drop(columns="geometry").T.to_string())

# %%
# Is every vertex of the result a vertex of a commune, bit for bit? And is each departement valid?

given = np.unique(shapely.get_coordinates(communes.geometry), axis=0)
kept = np.unique(shapely.get_coordinates(ours.geometry), axis=0)
both = np.unique(np.concatenate((given, kept)), axis=0)
print(len(kept), "vertices are left;", len(both) - len(given), "of them are new")
print("valid, proved one by one:", all(oblast.check(one) for one in ours.geometry))

# %%

figure, axis = plt.subplots(figsize=(9, 5))
ours.plot(ax=axis, column=ours.index, cmap="Pastel1", edgecolor="#37474f", linewidth=1)
communes.boundary.plot(ax=axis, color="white", linewidth=0.15)
for row in ours.itertuples():
    axis.annotate(row.Index, row.geometry.representative_point().coords[0], ha="center", va="center")
axis.set_aspect(1.5)
axis.set_axis_off()
figure.tight_layout()
