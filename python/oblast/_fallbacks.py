"""What the drop-in for geopandas passed on to geopandas."""

from __future__ import annotations

import threading
from collections import Counter
from typing import NamedTuple

__all__ = ["Fallback", "fallbacks"]


class Fallback(NamedTuple):
    """A call that was passed on, and why."""

    function: str
    reason: str


_lock = threading.Lock()
_counts: Counter[Fallback] = Counter()


def passed_on(function: str, reason: str) -> None:
    """Count a call that geopandas answers."""
    with _lock:
        _counts[Fallback(function, reason)] += 1


def fallbacks(*, clear: bool = False) -> dict[Fallback, int]:
    """Count the calls of `oblast.geopandas` that geopandas answered itself, by function and reason.

    Parameters
    ----------
    clear : bool
        Forget the counts afterwards.

    Returns
    -------
    dict of Fallback to int
        A Fallback is ``(function, reason)``.
    """
    with _lock:
        counted = dict(_counts)
        if clear:
            _counts.clear()
    return counted
