"""Threads, forks, signals, progress, memory."""

from __future__ import annotations

import gc
import multiprocessing
import os
import signal
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest
import shapely

import oblast
from shapes import square, tangle

SLOW = 6000  # vertices of a tangle whose union takes many seconds


def test_sixteen_threads_at_once() -> None:
    inputs = [tangle(150, seed) for seed in range(8)]
    expected = [oblast.union_all(r) for r in inputs]

    def all_of(_: int) -> bool:
        return all(oblast.union_all(r) == e for r, e in zip(inputs, expected, strict=True))

    with ThreadPoolExecutor(16) as pool:
        assert all(pool.map(all_of, range(48)))


def test_the_interpreter_is_free_during_a_call() -> None:
    """The call ends only because another Python thread, which runs meanwhile, makes its progress function raise."""
    seen: list[float] = []
    enough = threading.Event()

    def other_thread() -> None:
        while len(seen) < 3:
            pass
        enough.set()

    def progress(fraction: float) -> None:
        seen.append(fraction)
        if enough.is_set():
            raise TimeoutError

    thread = threading.Thread(target=other_thread)
    thread.start()
    with pytest.raises(TimeoutError):
        oblast.union_all(tangle(SLOW), progress=progress)
    thread.join()


@pytest.mark.parametrize(
    "call",
    [
        lambda: oblast.union_all(tangle(SLOW)),
        lambda: oblast.overlay_features(tangle(SLOW), tangle(SLOW, 1)),
        lambda: oblast.check(tangle(12 * SLOW)),
        lambda: oblast.overlay_pairs(tangle(SLOW), square()),
        lambda: oblast.buffer(shapely.LineString(tangle(SLOW).points), 1e-4),
    ],
)
def test_ctrl_c_stops_a_call(call) -> None:
    stop = threading.Event()

    def interrupt() -> None:
        if not stop.wait(0.3):
            os.kill(os.getpid(), signal.SIGINT)

    # A process that a shell started in the background ignores the signal.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    thread = threading.Thread(target=interrupt)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            call()
            pytest.fail("the call came to its end")
    finally:
        stop.set()
        thread.join()
        signal.signal(signal.SIGINT, before)
    assert oblast.union(square(), square(5)).area == 2  # later calls are not affected


def test_progress_grows_to_one() -> None:
    seen: list[float] = []
    r = oblast.union_all(tangle(1500), progress=seen.append)
    assert r == oblast.union_all(tangle(1500))
    assert seen == sorted(seen) and seen[-1] == 1 and len(seen) >= 2
    pairs: list[float] = []
    oblast.overlay_pairs(square(), square(), progress=pairs.append)
    assert pairs[-1] == 1


def test_progress_that_raises_ends_the_call() -> None:
    def progress(fraction: float) -> None:
        raise LookupError(f"at {fraction < 1}")

    with pytest.raises(LookupError, match="at True"):
        oblast.union_all(tangle(SLOW), progress=progress)


def test_progress_bar(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("tqdm")
    oblast.union_all(tangle(1000), progress=True)
    assert "100%" in capsys.readouterr().err


def _in_child(queue) -> None:
    rows = oblast.overlay_pairs(tangle(60), square(), [0] * 1000, [0] * 1000)
    queue.put((oblast.union_all(tangle(1500)), len(rows)))


def test_calls_after_a_fork() -> None:
    expected = oblast.union_all(tangle(1500))  # the threads of oneTBB run now, and a fork does not copy them
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=_in_child, args=(queue,))
    child.start()
    united, rows = queue.get(timeout=60)
    child.join(60)
    assert united == expected and rows == 1000 and child.exitcode == 0


def _resident() -> int:
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def _raise() -> None:
    with pytest.raises(oblast.OblastError):
        oblast.union_all(([[0, 0], [float("nan"), 0], [1, 1]], [0, 3]))


@pytest.mark.parametrize(
    "call",
    [
        lambda: oblast.overlay(tangle(40), square(0, 0, 0.5)),
        lambda: oblast.from_wkb(square().to_wkb()),
        lambda: oblast.from_arrow(square().to_arrow()),
        lambda: oblast.union_all(square(), progress=lambda f: None),
        lambda: oblast.overlay_features(square(), square()),
        _raise,
    ],
)
def test_ten_thousand_calls_keep_no_memory(call) -> None:
    for _ in range(500):
        call()
    gc.collect()
    before = _resident()
    for _ in range(10_000):
        call()
    gc.collect()
    assert _resident() - before < 4 << 20  # 400 bytes a call would be a leaked object
