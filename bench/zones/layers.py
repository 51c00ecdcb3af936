"""Buildings and streets: what they are, the zones of oblast, and those of momepy by its own settings."""

import geopandas
import inputs
import momepy
import numpy as np
import oblast
import shapely
from libpysal.cg import voronoi_frames

THEIR_STEP = 0.5  # momepy samples outlines at this distance, so that borders are off by up to half of it


def jobs(arguments):
    """By name: what gives the shapes and their frame, and the tool of momepy for them."""
    return {
        "bubenec-buildings": (lambda: layer(arguments, "buildings"), momepy_buildings),
        "bubenec-streets": (lambda: layer(arguments, "streets"), libpysal_streets),
        "rectangles": (lambda: rectangles(arguments.buildings), momepy_buildings),
        "roads": (lambda: roads(arguments), libpysal_streets),
    }


def framed(shapes):
    return shapes, shapely.box(*shapes.total_bounds)


def layer(arguments, name):
    frame = geopandas.read_file(arguments.shared / "realworld" / "bubenec.gpkg", layer=name)
    return framed(frame.geometry)


def roads(arguments):
    return framed(geopandas.GeoSeries(inputs.roads(arguments.program, arguments.folder, arguments.segments)))


def rectangles(count):
    """Houses of 5 to 11 m by 6 to 12 m, one in each square of 25 m, turned at random; each tenth is two that touch."""
    random = np.random.default_rng(7)
    side = int(np.ceil(np.sqrt(count)))
    number = np.arange(count)
    centre = 25.0 * np.stack([number % side, number // side], axis=1) + random.uniform(-4, 4, (count, 2))
    width, height = random.uniform(5, 11, count), random.uniform(6, 12, count)
    angle = random.uniform(0, np.pi, count)
    along = np.stack([np.cos(angle), np.sin(angle)], axis=1) * width[:, None] / 2
    across = np.stack([-np.sin(angle), np.cos(angle)], axis=1) * height[:, None] / 2
    corners = [centre - along - across, centre + along - across, centre + along + across, centre - along + across]
    whole = number % 10 != 0
    low, high = (corners[0] + corners[1]) / 2, (corners[3] + corners[2]) / 2  # the wall of two that touch
    parts = [
        np.stack(corners, axis=1)[whole],
        np.stack([corners[0], low, high, corners[3]], axis=1)[~whole],
        np.stack([low, corners[1], corners[2], high], axis=1)[~whole],
    ]
    return framed(geopandas.GeoSeries(shapely.polygons(np.concatenate(parts))))


def ours(shapes, frame, tolerance, threads=None):
    found = oblast.zones(shapes, frame, tolerance=tolerance, threads=threads)
    return geopandas.GeoSeries(found.regions.to_shapely(), index=shapes.index, crs=shapes.crs)


def momepy_buildings(shapes, frame):
    return momepy.morphological_tessellation(shapes, clip=frame).geometry


def libpysal_streets(shapes, frame):
    return voronoi_frames(shapes, clip=frame, segment=THEIR_STEP, return_input=False, as_gdf=False)
