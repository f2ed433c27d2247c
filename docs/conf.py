"""The documentation as a site, written by `make docs`.

The source directory is the repository, so that the links of a page are the same here and on GitHub.
"""

import importlib.util
import json
import re
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

from quadruped_env import __version__
from quadruped_env.policies import load_policy
from quadruped_env.policies.files import SHOWN
from quadruped_env.walking_page import write_page

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
PICTURE = "[![The page in which the robot walks](../assets/pictures/page.webp)](programs.md#the-page-that-walks)"
"""Line of the first page that the walking page replaces."""
EMBEDDED = """```{raw} html
<iframe class="walk" src="../walk.html" title="The robot, walking" allow="gamepad *; fullscreen *"></iframe>
<p class="walk">Arrow keys steer, a click pushes. <a href="../walk.html">Open it alone</a></p>
```"""

project = "MiniQuadruped"
author = "The MiniQuadruped contributors"
release = version = __version__
root_doc = "docs/index"
source_suffix = {".md": "markdown", ".rst": "restructuredtext", ".ipynb": "markdown"}
include_patterns = [
    "docs/*.md",
    "docs/*.ipynb",
    "docs/*/*.md",
    "docs/api/*.rst",
    "CONTRIBUTING.md",
    "CHANGELOG.md",
    "assets/**/README.md",
    "examples/**/README.md",
]
exclude_patterns = [".*", "build", "dist", "mutants", "quadruped_env", "results", "runs", "sweeps", "tests", "tools"]
extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
]
templates_path = [str(DOCS / "_templates")]
# The extra 'docs' has no torch; what is documented of a training needs none.
autodoc_mock_imports = [name for name in ("torch", "stable_baselines3") if importlib.util.find_spec(name) is None]
default_role = "code"  # docstrings write code as Markdown does
myst_heading_anchors = 4
autodoc_member_order = "bysource"
autodoc_typehints_format = "short"

html_theme = "furo"
html_title = f"MiniQuadruped {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_extra_path = ["_redirect"]
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False


def write_walking_page(app: Sphinx) -> None:
    """Write the page that walks into the site."""
    write_page(load_policy(SHOWN), Path(app.outdir, "walk.html"), SHOWN)


def embed_walking_page(app: Sphinx, page: str, source: list[str]) -> None:
    """Show the page that walks where the first page has a picture for GitHub."""
    if page == root_doc:
        assert PICTURE in source[0], f"{root_doc}.md: PICTURE of conf.py is not there"
        source[0] = source[0].replace(PICTURE, EMBEDDED)


def convert_notebook(app: Sphinx, page: str, source: list[str]) -> None:
    """Convert a notebook to Markdown, in place."""
    if not app.env.doc2path(page, base=False).match("*.ipynb"):
        return
    cells = [(cell["cell_type"], "".join(cell["source"])) for cell in json.loads(source[0])["cells"]]
    # :force: since a line of Jupyter, such as %pip, is not Python.
    code = "```{{code-block}} python\n:force:\n\n{}\n```"
    source[0] = "\n\n".join(code.format(text) if kind == "code" else text for kind, text in cells)


def convert_docstring(app: Sphinx, what: str, name: str, value: Any, options: Any, lines: list[str]) -> None:
    """Convert the headings, tables and bars of a docstring from Markdown to reStructuredText, in place."""
    text = re.sub(r"^#+ (.*)$", r".. rubric:: \1" + "\n", "\n".join(lines), flags=re.MULTILINE)
    parts = re.split(r"((?:^\|.*\n?)+)", text, flags=re.MULTILINE)
    parts[1::2] = map(list_table, parts[1::2])
    lines[:] = "".join(parts).replace("|", r"\|").split("\n")
    if what in ("attribute", "data", "property"):
        lines.insert(0, "\\")  # nothing, but napoleon takes what comes before a colon in the first line for the type


def list_table(table: str) -> str:
    """Directive for a Markdown table."""
    head, _, *body = [line.strip("| ").split(" |") for line in table.splitlines()]
    text = "\n.. list-table::\n   :header-rows: 1\n\n"
    for cells in (head, *body):
        filled = cells + [""] * (len(head) - len(cells))
        text += "   * - " + "\n     - ".join(cell.strip() for cell in filled) + "\n"
    return text + "\n"


def setup(app: Sphinx) -> None:
    """Connect the functions above."""
    app.connect("builder-inited", write_walking_page)
    app.connect("source-read", embed_walking_page)
    app.connect("source-read", convert_notebook)
    app.connect("autodoc-process-docstring", convert_docstring, priority=400)  # before napoleon
