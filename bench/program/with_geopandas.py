"""with_geopandas.py EXPRESSION OUTPUT: writes what the expression gives as GeoJSON."""

import sys
import warnings

import geopandas as gpd
from geopandas import read_file as read  # noqa: F401, for the expression

warnings.filterwarnings("ignore")


def invalid(frame):
    """The features that are not valid, with the reason."""
    bad = frame[~frame.is_valid]
    return bad.assign(reason=bad.is_valid_reason())


def made_valid(frame):
    frame.geometry = frame.make_valid()
    return frame


eval(sys.argv[1]).to_file(sys.argv[2], driver="GeoJSON", COORDINATE_PRECISION=17)
