"""geopandas' own functions, also while they are replaced."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import geopandas
from geopandas import GeoDataFrame
from geopandas.array import GeometryArray

__all__ = ["Originals", "originals"]


class Originals(NamedTuple):
    """What geopandas had before anything was replaced."""

    overlay: Any
    clip: Any
    dissolve: Any
    union_all: Any
    buffer: Any


@lru_cache(maxsize=1)
def originals() -> Originals:
    """Geopandas' functions. Called first when `oblast.geopandas` is imported."""
    return Originals(
        geopandas.overlay,
        geopandas.clip,
        GeoDataFrame.dissolve,
        GeometryArray.union_all,
        GeometryArray.buffer,
    )


originals()
