"""Replaces functions of geopandas, so that programs need not change."""

from __future__ import annotations

from types import TracebackType
from typing import Any, Self

import geopandas
import geopandas.tools
from geopandas import GeoDataFrame
from geopandas.array import GeometryArray

from oblast.geopandas._buffer import buffer
from oblast.geopandas._clip import clip
from oblast.geopandas._dissolve import dissolve, union_all
from oblast.geopandas._originals import originals
from oblast.geopandas._overlay import overlay

__all__ = ["Installed", "install", "uninstall"]


class Installed:
    """What `install` returns: as a context manager it ends with `uninstall`."""

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        raised: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        uninstall()


def _replace(overlay: Any, clip: Any, dissolve: Any, union_all: Any, buffer: Any) -> None:
    for module in (geopandas, geopandas.tools):
        module.overlay = overlay
        module.clip = clip
    GeoDataFrame.dissolve = dissolve
    GeometryArray.union_all = union_all
    GeometryArray.buffer = buffer


def install() -> Installed:
    """Let geopandas call oblast: overlay, clip, dissolve, union_all and buffer, as functions and methods.

    Modules that imported a function by name before keep geopandas' own. Calls that are not oblast's are answered by
    geopandas, and counted by `oblast.fallbacks`.

    Returns
    -------
    Installed
        A context manager that calls `uninstall` at its end.

    Examples
    --------
    >>> import geopandas, oblast.geopandas, shapely
    >>> squares = geopandas.GeoSeries([shapely.box(0, 0, 1, 1), shapely.box(1, 0, 2, 1)])
    >>> with oblast.geopandas.install():
    ...     squares.union_all().area
    2.0
    """
    _replace(overlay, clip, dissolve, union_all, buffer)
    return Installed()


def uninstall() -> None:
    """Give geopandas its own functions back."""
    _replace(*originals())
