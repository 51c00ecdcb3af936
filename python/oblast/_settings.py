"""What every call may be told: threads, progress, fill rules, statistics."""

from __future__ import annotations

import contextlib
import contextvars
from collections.abc import Callable, Iterator
from typing import Literal

from oblast import _core

__all__ = ["FillRule", "Progress", "Statistics", "Workspace", "settings_of", "statistics"]

Progress = bool | Callable[[float], object]
FillRule = Literal["polygons", "even_odd", "nonzero", "positive", "negative"] | tuple[Literal["at_least"], int]

_FILL_KINDS = ("polygons", "at_least", "even_odd", "nonzero", "positive", "negative")
ENGINES = ("leonov_nikitin", "vatti", "skvortsov")
STAGES = ("collect", "node", "label", "select", "link", "assemble")
_COUNTS = (
    "input_contours",
    "input_vertices",
    "output_polygons",
    "output_contours",
    "output_vertices",
    "resolved_polygons",
    "intersections",
)


class Workspace:
    """Memory that calls keep for later calls: pass it as ``workspace=``.

    Useful for many calls of some hundred thousand vertices, which then get fewer pages from the system. It changes no
    result. One workspace a thread is fastest; several threads may share one.

    Parameters
    ----------
    most_bytes : int
        The most bytes that are kept between calls.

    Examples
    --------
    >>> import oblast
    >>> workspace = oblast.Workspace()
    >>> square = oblast.from_ragged([[0, 0], [1, 0], [1, 1], [0, 1]], [0, 4])
    >>> for _ in range(3):
    ...     r = oblast.union(square, square, workspace=workspace)
    """

    __slots__ = ("_core",)

    def __init__(self, most_bytes: int = 16 << 20) -> None:
        self._core = _core.Workspace(most_bytes)

    @property
    def kept_bytes(self) -> int:
        """The bytes that are kept now."""
        return self._core.kept_bytes()

    def clear(self) -> None:
        """Free all memory that is kept."""
        self._core.clear()

    def __repr__(self) -> str:
        return f"<Workspace: {self.kept_bytes} bytes kept>"


class Statistics:
    """What the calls inside ``with oblast.statistics()`` did; see `statistics`."""

    def __init__(self) -> None:
        self.calls = 0
        self.input_contours = 0
        self.input_vertices = 0
        self.output_polygons = 0
        self.output_contours = 0
        self.output_vertices = 0
        self.resolved_polygons = 0
        self.intersections = 0
        self.rounds = 0
        self.largest_displacement = 0.0
        self.largest_displacement_ulps = 0.0
        self.seconds: dict[str, float] = dict.fromkeys(STAGES, 0.0)

    def _add(self, call: _core.Statistics) -> None:
        self.calls += 1
        for name in _COUNTS:
            setattr(self, name, getattr(self, name) + getattr(call, name))
        self.rounds = max(self.rounds, call.rounds)
        self.largest_displacement = max(self.largest_displacement, call.largest_displacement)
        self.largest_displacement_ulps = max(self.largest_displacement_ulps, call.largest_displacement_ulps)
        for index, stage in enumerate(STAGES):
            self.seconds[stage] += call.seconds(index)

    def __repr__(self) -> str:
        return (
            f"<Statistics: {self.calls} calls, {self.input_vertices} vertices in, {self.output_vertices} out, "
            f"{self.intersections} intersections, at most {self.rounds} rounds, "
            f"{self.largest_displacement_ulps:g} ulps, {sum(self.seconds.values()):.3f} s>"
        )


_collecting: contextvars.ContextVar[Statistics | None] = contextvars.ContextVar("statistics", default=None)


@contextlib.contextmanager
def statistics() -> Iterator[Statistics]:
    """Count what the calls of this thread or task do, until the block ends.

    Counts and seconds are summed over the calls; rounds and displacements are the largest ones. Overlays, unions and
    calls on rows are counted; the parts of `overlay_pairs`, `hull`, `check` and `Locator` are not. Inside the block
    calls run all stages of the pipeline, also where a shorter way would give the same result.

    Yields
    ------
    Statistics
        With the members ``calls``, ``input_contours``, ``input_vertices``, ``output_polygons``, ``output_contours``,
        ``output_vertices``, ``resolved_polygons`` (polygons that met themselves), ``intersections``, ``rounds`` (of
        rounding; the last one finds nothing), ``largest_displacement`` (of a new vertex from its edge, in units of
        the coordinates), ``largest_displacement_ulps`` (the same in units in the last place of the largest
        coordinate) and ``seconds`` (by stage).

    Examples
    --------
    >>> import oblast
    >>> a = oblast.from_ragged([[0, 0], [2, 0], [2, 2], [0, 2]], [0, 4])
    >>> b = oblast.from_ragged([[1, 1], [3, 1], [3, 3], [1, 3]], [0, 4])
    >>> with oblast.statistics() as s:
    ...     r = oblast.intersection(a, b)
    >>> s.intersections, s.input_vertices
    (2, 8)
    """
    collected = Statistics()
    token = _collecting.set(collected)
    try:
        yield collected
    finally:
        _collecting.reset(token)


@contextlib.contextmanager
def _bar(progress: Progress) -> Iterator[Callable[[float], object]]:
    """The callable that is told the fraction: the caller's, or one that draws a bar by tqdm if that is installed."""
    if callable(progress):
        yield progress
        return
    try:
        from tqdm.auto import tqdm
    except ImportError:
        yield lambda fraction: None
        return
    with tqdm(total=100, unit="%", bar_format="{l_bar}{bar}| {elapsed}<{remaining}") as bar:
        yield lambda fraction: bar.update(int(100 * fraction) - bar.n)


def _fill(settings: _core.Settings, operand: int, rule: FillRule) -> None:
    kind, depth = (rule, 1) if isinstance(rule, str) else rule
    if kind not in _FILL_KINDS or not isinstance(depth, int):
        raise ValueError(f"fill rule {rule!r}: expected one of {_FILL_KINDS}, or ('at_least', k)")
    settings.set_fill(operand, _FILL_KINDS.index(kind), depth)


_USUAL = _core.Settings()


@contextlib.contextmanager
def _watched(
    threads: int | None,
    progress: Progress,
    workspace: Workspace | None,
    most_bytes: int,
    fill: tuple[FillRule, ...],
    engine: str,
    touching: bool,
    minimal: bool,
    collected: Statistics | None,
) -> Iterator[_core.Settings]:
    settings = _core.Settings()
    settings.set_threads(0 if threads is None else threads)
    settings.set_memory(most_bytes)
    if workspace is not None:
        settings.set_workspace(workspace._core)
    for operand, rule in enumerate(fill):
        _fill(settings, operand, rule)
    if engine not in ENGINES:
        raise ValueError(f"engine {engine!r}: expected one of {ENGINES}")
    settings.set_engine(ENGINES.index(engine))
    settings.set_touching(touching)
    settings.set_minimal(minimal)
    with contextlib.ExitStack() as stack:
        if progress:
            settings.set_progress(stack.enter_context(_bar(progress)))
        if collected is None:
            yield settings
            return
        call = _core.Statistics()
        settings.set_statistics(call)
        yield settings
        collected._add(call)


def settings_of(
    threads: int | None = None,
    progress: Progress = False,
    workspace: Workspace | None = None,
    most_bytes: int = 0,
    fill: tuple[FillRule, ...] = (),
    engine: str = "leonov_nikitin",
    touching: bool = False,
    minimal: bool = False,
    counted: bool = True,
) -> contextlib.AbstractContextManager[_core.Settings]:
    """The settings of one call. The usual ones are made once, because small calls are many."""
    collected = _collecting.get() if counted else None
    usual = threads is None and not progress and workspace is None and most_bytes == 0
    if usual and not fill and engine == "leonov_nikitin" and not (touching or minimal) and collected is None:
        return contextlib.nullcontext(_USUAL)
    return _watched(threads, progress, workspace, most_bytes, fill, engine, touching, minimal, collected)
