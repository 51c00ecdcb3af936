"""Results of Python, judged by the program's `check --against`: points and lines, with exact rationals."""

from __future__ import annotations

import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import oblast
from shapes import square

PROGRAM = os.environ.get("OBLAST_PROGRAM", "")
pytestmark = pytest.mark.skipif(not PROGRAM, reason="OBLAST_PROGRAM does not name the program")
NAMES = {
    "intersection": "intersection",
    "union": "union",
    "difference": "difference",
    "symmetric_difference": "symdifference",
}
COORDINATES = st.one_of(st.integers(0, 6).map(float), st.floats(-10, 10, width=32))
RINGS = st.lists(st.tuples(COORDINATES, COORDINATES), min_size=3, max_size=8)


@st.composite
def layers(draw: st.DrawFn) -> oblast.Regions:
    rings = draw(st.lists(RINGS, min_size=1, max_size=4))
    return oblast.from_ragged([point for ring in rings for point in ring], np.cumsum([0, *map(len, rings)]))


def is_right(result: oblast.Regions, a: oblast.Regions, b: oblast.Regions, how: str) -> bool:
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / f"{name}.wkb" for name in ("result", "a", "b")]
        for path, regions in zip(paths, (result, a, b), strict=True):
            path.write_bytes(b"".join(regions.to_wkb()))
        command = [PROGRAM, "check", paths[0], "--against", *paths[1:], "--op", NAMES[how]]
        done = subprocess.run([*command, "--points", "5000", "--lines", "100"], capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return done.returncode == 0


@settings(max_examples=60, deadline=None)
@given(layers(), layers(), st.sampled_from(sorted(NAMES)))
def test_results_are_right(a: oblast.Regions, b: oblast.Regions, how: str) -> None:
    result = oblast.overlay(a, b, how)
    if result:  # the program takes an empty file for a mistake
        assert is_right(result, a, b, how)


def test_a_wrong_result_is_found() -> None:
    a, b = square(0, 0, 2), square(1, 1, 2)
    assert is_right(oblast.union(a, b), a, b, "union")
    assert not is_right(oblast.union(a, b), a, b, "symmetric_difference")
