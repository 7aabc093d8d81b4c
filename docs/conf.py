"""How Sphinx builds the documentation site; `make docs` runs it."""

import os
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "docs/_extensions"))

import rimroll  # noqa: E402

MANIFEST = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
repository = MANIFEST["urls"]["Repository"]

project = "rimroll"
author = MANIFEST["authors"][0]["name"]
copyright = author
version = release = rimroll.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    # In docs/_extensions:
    "command_help",
    "examples",
    "links",
    "mathematics",
    "public_names",
    "run_pages",
]
exclude_patterns = ["_*", "README.md"]
nitpicky = True

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
myst_dmath_double_inline = True
myst_heading_anchors = 3
suppress_warnings = ["myst.header"]  # CHANGELOG.md repeats headings by intent
numfig = True  # equations are numbered by the page of the theory that they stand on
numfig_secnum_depth = 1

# Whether tools/build_docs.sh adds JupyterLite, which then runs the notebooks.
notebooks_run = bool(os.environ.get("PYODIDE"))

autosummary_generate = False
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_type_aliases = {name: name for name in ("Array", "Number", "Values")}
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 88
napoleon_google_docstring = False
napoleon_use_rtype = False
nitpick_ignore_regex = [
    # Types in signatures that are no part of the reference, or belong to other packages.
    ("py:.*", r"(?!rimroll\.).*"),
    ("py:class", r"rimroll\..*\.[A-Z]\w*|rimroll\._.*"),
    ("py:mod", r"rimroll\.experiment\.(likelihood|predicted)"),  # for people who read the source
]

html_theme = "furo"
html_title = f"rimroll {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_math_renderer = "katex"
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "source_repository": f"{repository}/",
    "source_branch": "main",
    "source_directory": "docs/",
}
highlight_language = "text"
copybutton_exclude = ".linenos, .gp, .go"
