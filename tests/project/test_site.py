"""The documentation as a site: `make docs` builds it without a warning, and it needs no network and no server."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote

import pytest
from pages import DOCS
from paths import ROOT
from waiting import wait_until

from quadruped_env import envs, policies, task

pytest.importorskip("furo", reason="Sphinx is not installed: pip install -e '.[docs]'")
pytest.importorskip("myst_parser", reason="Sphinx is not installed: pip install -e '.[docs]'")
from bs4 import BeautifulSoup

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The site of a copy of the checkout, built by the command of the Makefile."""
    copy = tmp_path_factory.mktemp("docs")
    for name in ("docs", "assets", "examples"):
        shutil.copytree(ROOT / name, copy / name, ignore=shutil.ignore_patterns("api"))
    for name in ("CONTRIBUTING.md", "CHANGELOG.md", "README.md", "Makefile"):
        shutil.copy(ROOT / name, copy)
    for name in ("quadruped_env", "tests", "tools", "train"):  # for links to files
        (copy / name).symlink_to(ROOT / name)
    (command,) = re.findall(r"^\t\$\(BIN\)/python (-m sphinx .*)$", (copy / "Makefile").read_text(), re.MULTILINE)
    # A proxy that does not answer: the build asks nothing of a network.
    environment = {**os.environ, **dict.fromkeys(("http_proxy", "https_proxy"), "http://127.0.0.1:9")}
    done = subprocess.run(
        [sys.executable, *command.split()], cwd=copy, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return copy / "build" / "site"


def soup(path):
    return BeautifulSoup(path.read_text(), "html.parser")


def test_site_has_every_page_a_search_and_the_names_of_the_api(site):
    for page in DOCS:
        assert soup(site / "docs" / f"{page.stem}.html").h1, page.name
    assert "docs/index.html" in (site / "index.html").read_text()
    assert soup(site / "docs" / "index.html").find("input", attrs={"name": "q"})
    assert (site / "searchindex.js").stat().st_size > 100_000
    for package in (envs, policies, task):
        ids = {tag["id"] for tag in soup(site / "docs" / "api" / f"{package.__name__}.html").find_all(id=True)}
        for name in package.__all__:
            if callable(getattr(package, name)):
                assert any(found.endswith(f".{name}") for found in ids), name
    text = soup(site / "docs" / "api" / "quadruped_env.envs.html").get_text()
    assert re.search(r"track_forward_velocity\s+exp\(", text), "the tables of the specification are tables"


def test_every_link_within_the_site_leads_to_a_file_and_an_anchor(site):
    pages = {path: soup(path) for path in site.rglob("*.html") if path.name != "walk.html"}
    anchors = {path: {tag.get("id") for tag in page.find_all(id=True)} for path, page in pages.items()}
    broken, outside = set(), set()
    for path, page in pages.items():
        for tag in page.find_all(["a", "link", "script", "img", "iframe"]):
            target = tag.get("href") or tag.get("src") or ""
            if re.match("[a-z]+:", target):
                if tag.name != "a":
                    outside.add(f"{path.name}: {target}")
                continue
            file, _, anchor = target.split("?")[0].partition("#")
            linked = Path(os.path.normpath(path.parent / unquote(file))) if file else path
            if not linked.is_file() or (anchor and linked in anchors and unquote(anchor) not in anchors[linked]):
                broken.add(f"{path.name}: {target}")
    assert not broken
    assert not outside, "the site needs no network"


def test_robot_walks_on_the_first_page(site, page):
    page.goto((site / "docs" / "index.html").as_uri())
    robot = page.frame_locator("iframe.walk").locator("body")
    wait_until(lambda: re.search(r"Distance\s+[1-9\-.]*\d*[1-9] m", robot.inner_text()), "a distance that was walked")
    assert page.watched.errors == []
    assert page.watched.outside() == []
