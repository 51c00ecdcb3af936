"""Exact polygon overlay: numpy in, numpy out, on all cores.

>>> import oblast
>>> a = oblast.from_ragged([[0, 0], [2, 0], [2, 2], [0, 2]], [0, 4])
>>> b = oblast.from_ragged([[1, 1], [3, 1], [3, 3], [1, 3]], [0, 4])
>>> oblast.overlay(a, b, "union").area
7.0

`oblast.geopandas` has overlay, dissolve, union_all, clip and buffer with geopandas' signatures, and zones of frames.
"""

from oblast import _core
from oblast._buffer import buffer
from oblast._convert import Operand, from_arrow, from_ragged, from_shapely, from_wkb
from oblast._errors import OblastError
from oblast._fallbacks import Fallback, fallbacks
from oblast._overlay import (
    difference,
    intersection,
    overlay,
    symmetric_difference,
    union,
    union_all,
)
from oblast._pairs import overlay_pairs, repair
from oblast._queries import Locator, Report, Triangulation, check, hull, triangulate
from oblast._regions import ArrowColumn, Regions
from oblast._rows import (
    Depth,
    Dissolved,
    OverlaidRows,
    Partition,
    clip,
    depth,
    dissolve,
    overlay_features,
    partition,
)
from oblast._settings import Statistics, Workspace, statistics
from oblast._zones import Zones, zones

__version__: str = _core.version

__all__ = [
    "ArrowColumn",
    "Depth",
    "Dissolved",
    "Fallback",
    "Locator",
    "OblastError",
    "Operand",
    "OverlaidRows",
    "Partition",
    "Regions",
    "Report",
    "Statistics",
    "Triangulation",
    "Workspace",
    "Zones",
    "buffer",
    "check",
    "clip",
    "depth",
    "difference",
    "dissolve",
    "fallbacks",
    "from_arrow",
    "from_ragged",
    "from_shapely",
    "from_wkb",
    "hull",
    "intersection",
    "overlay",
    "overlay_features",
    "overlay_pairs",
    "partition",
    "repair",
    "statistics",
    "symmetric_difference",
    "triangulate",
    "union",
    "union_all",
    "zones",
]
