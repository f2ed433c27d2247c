"""The first look: demo and viewer without torch and the other libraries of extras."""

import os
import subprocess
import sys

import pytest
import walking

EXTRAS = ("torch", "stable_baselines3", "onnx", "onnxruntime", "matplotlib", "jinja2", "av", "PIL", "yaml", "rosbags")


@pytest.fixture
def program(tmp_path):
    """Run `mini-quadruped` where none of the extras' libraries can be imported; what it printed."""
    blocked = tmp_path / "blocked"
    blocked.mkdir()

    def run(*arguments, module=True, extras=EXTRAS, **variables):
        for name in extras:
            (blocked / f"{name}.py").write_text(f"raise AssertionError('{name} was imported')\n")
        kept = {name: value for name, value in os.environ.items() if name not in ("BROWSER", "DISPLAY", "PATH")}
        done = subprocess.run(
            [sys.executable, *(["-m", "quadruped_env"] if module else []), *arguments],
            cwd=tmp_path,
            env=kept | {"PYTHONPATH": str(blocked), "PATH": str(blocked)} | variables,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        assert done.stderr == ""
        return done.stdout

    return run


def test_demo_opens_one_page_in_the_browser_and_prints_its_place_where_there_is_none(program, tmp_path):
    page = tmp_path / "mini-quadruped-demo.html"
    assert program("demo") == (
        f"the robot walks in {page.as_uri()}\nno browser could be opened: open this file in one, on any machine\n"
    )
    assert page.stat().st_size > 1_000_000
    assert "Content-Security-Policy" in page.read_text()[:2000]
    program("page")  # without a run: of the same policy
    assert [walking.document_of(path)["name"] for path in (page, tmp_path / "walk.html")] == ["rough", "rough"]
    browser, opened = tmp_path / "browser", tmp_path / "opened"
    browser.write_text(f'#!/bin/sh\necho "$1" > {opened}\n')
    browser.chmod(0o755)
    other = tmp_path / "other name.html"
    assert program("demo", "-o", other, BROWSER=f"{browser} %s") == f"the robot walks in {other.as_uri()}\n"
    assert opened.read_text() == f"{other.as_uri()}\n"


def test_viewer_shows_the_shipped_policy_without_torch(program):
    pytest.importorskip("viser", reason="viser is not installed: pip install -e '.[viewer]'")
    code = "from quadruped_env.viewer import open_show; show = open_show(['flat'], port=0); show.run(0.2); show.close()"
    assert program("-c", code, module=False, extras=("torch", "stable_baselines3")) == ""
