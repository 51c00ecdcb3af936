"""geopandas' own tests against oblast.geopandas: a plugin for pytest, run by tools/python-geopandas.

The data of the tests is not in geopandas' wheel; OBLAST_SHARED/geopandas has it. Names that the tests imported are
replaced, and so is what geopandas itself calls.
"""

from __future__ import annotations

import importlib
import os
import pathlib
from collections import Counter

import geopandas.tests.util
import pytest

import oblast
import oblast.geopandas

DATA = pathlib.Path(os.environ["OBLAST_SHARED"]).resolve() / "geopandas"

OVERLAPPING_ROWS = (
    "rows of one layer overlap: both get a vertex where their borders cross, so that borders that rows of the result "
    "share are the same vertices; the regions are the same"
)
# What differs, and why. A test that is listed and passes is an error, too.
DIFFERS: dict[str, str] = {
    "test_overlay::test_overlay_overlap[union]": OVERLAPPING_ROWS,
    "test_overlay::test_overlay_overlap[intersection]": OVERLAPPING_ROWS,
    "test_overlay::test_overlay_overlap[difference]": OVERLAPPING_ROWS,
    "test_overlay::test_overlay_overlap[symmetric_difference]": OVERLAPPING_ROWS,
    "test_overlay::test_keep_geom_type_geometry_collection": (
        "keep_geom_type=None: a pair that has an area, and touches elsewhere, is not in the warning's count; "
        "the rows are the same"
    ),
}


def _point_at_data() -> None:
    util = geopandas.tests.util
    util._NYBB = f"zip://{DATA / 'nybb_16a.zip'}"
    util._NATURALEARTH_LOWRES = str(DATA / "naturalearth_lowres" / "naturalearth_lowres.shp")
    util._NATURALEARTH_CITIES = str(DATA / "naturalearth_cities" / "naturalearth_cities.shp")


_point_at_data()
oblast.geopandas.install()


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    test_overlay = importlib.import_module("geopandas.tests.test_overlay")
    test_overlay.DATA = str(DATA / "overlay")
    for item in items:
        module = item.getparent(pytest.Module)
        name = f"{module.obj.__name__.rpartition('.')[2]}::{item.name}" if module else item.name
        if name in DIFFERS:
            item.add_marker(pytest.mark.xfail(reason=DIFFERS[name], strict=True))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    counts: Counter[tuple[str, str]] = Counter(oblast.fallbacks())
    terminalreporter.section("calls that geopandas answered")
    for (function, reason), count in sorted(counts.items()):
        terminalreporter.line(f"{count:5}  {function}: {reason}")
