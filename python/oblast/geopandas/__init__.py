"""A drop-in for geopandas: overlay, dissolve, union_all, clip and buffer with its signatures and semantics.

And `zones` of the rows of a frame; `morphological_tessellation` and `enclosed_tessellation` have momepy's signatures.

>>> from oblast import geopandas as og
>>> import geopandas, shapely
>>> a = geopandas.GeoDataFrame({"name": ["a"]}, geometry=[shapely.box(0, 0, 2, 2)])
>>> b = geopandas.GeoDataFrame({"name": ["b"]}, geometry=[shapely.box(1, 1, 3, 3)])
>>> og.overlay(a, b, how="identity")[["name_1", "name_2"]].values.tolist()
[['a', 'b'], ['a', nan]]

What is not oblast's is answered by geopandas itself, and counted by `oblast.fallbacks`.
"""

from oblast.geopandas._buffer import buffer
from oblast.geopandas._clip import clip
from oblast.geopandas._dissolve import dissolve, union_all
from oblast.geopandas._install import Installed, install, uninstall
from oblast.geopandas._overlay import overlay
from oblast.geopandas._tessellation import enclosed_tessellation, morphological_tessellation
from oblast.geopandas._zones import zones

__all__ = [
    "Installed",
    "buffer",
    "clip",
    "dissolve",
    "enclosed_tessellation",
    "install",
    "morphological_tessellation",
    "overlay",
    "uninstall",
    "union_all",
    "zones",
]
