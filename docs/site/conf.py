"""Sphinx: the site that `make docs` builds. tools/docs assembles its source folder, which this file stands in."""

import os
import warnings
from pathlib import Path

import oblast

project = "oblast"
author = "the oblast developers"
copyright = author  # noqa: A001
version = release = oblast.__version__

extensions = [
    "breathe",
    "matplotlib.sphinxext.plot_directive",
    "myst_parser",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx_design",
    "sphinx_gallery.gen_gallery",
]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
# The folders of the repository are there for links to their files; only docs/ has pages.
include_patterns = [
    "*.md",
    "*.rst",
    "api/**",
    "gallery/*.rst",
    "docs/*.md",
    "docs/decisions/*.md",
    "bench/README.md",
    "bench/python/*.md",
    "python/README.md",
]
exclude_patterns = ["gallery/README.rst", "gallery/sg_execution_times.rst"]
suppress_warnings = [
    "config.cache",  # sphinx_gallery_conf holds functions
    "duplicate_declaration.cpp",  # each page of a header says `namespace oblast`
]

# Markdown of the repository. Links to its other files become downloads.
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4

autosummary_generate = True
autosummary_imported_members = False
autodoc_typehints = "none"  # numpydoc's sections say more
numpydoc_show_class_members = False
numpydoc_class_members_toctree = False

breathe_projects = {"oblast": os.environ["OBLAST_DOXYGEN_XML"]}
breathe_default_project = "oblast"
breathe_show_include = False

plot_html_show_source_link = False
plot_html_show_formats = False
plot_formats = [("svg", 100)]
plot_rcparams = {"figure.figsize": (8.5, 3.2), "savefig.bbox": "tight", "svg.fonttype": "path", "axes.titlesize": 10}
plot_apply_rcparams = True
plot_include_source = True


def quiet(gallery_conf: object, file_name: object) -> None:
    """Before each example: what matplotlib and geopandas warn of is no part of the page."""
    warnings.filterwarnings("ignore", category=UserWarning, message="Geometry is in a geographic CRS")


sphinx_gallery_conf = {
    "examples_dirs": "gallery_examples",
    "gallery_dirs": "gallery",
    "filename_pattern": "/plot_",
    "within_subsection_order": "FileNameSortKey",
    "abort_on_example_error": True,
    "show_memory": False,
    "min_reported_time": 1e9,
    "write_computation_times": False,
    "download_all_examples": False,
    "show_signature": False,
    "image_scrapers": ("matplotlib",),
    "matplotlib_animations": False,
    "reset_modules": ("matplotlib", quiet),
    "remove_config_comments": True,
    "thumbnail_size": (640, 400),
}

html_theme = "pydata_sphinx_theme"
html_title = "oblast"
html_static_path = ["_static"]
html_css_files = ["oblast.css"]
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {
    "navbar_align": "left",
    "navbar_end": ["theme-switcher"],
    "secondary_sidebar_items": ["page-toc"],
    "show_prev_next": False,
    "footer_start": ["copyright"],
    "footer_end": [],
    "logo": {"text": "oblast"},
    "header_links_before_dropdown": 7,
    "pygments_light_style": "tango",
}
html_sidebars = {"index": [], "gis": [], "library": [], "docs/guarantees": [], "docs/methods": []}
root = Path(__file__).parent
