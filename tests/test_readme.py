"""The README's first steps, as a person takes them."""

import contextlib
import io
import re
from pathlib import Path

import pytest

README = (Path(__file__).parents[1] / "README.md").read_text()


def test_the_snippet_prints_how_far_the_robot_walks_at_its_command():
    (snippet,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(snippet, {})  # noqa: S102
    (distance,) = re.fullmatch(r"(-?[0-9.]+) m forward\n", printed.getvalue()).groups()
    # 10 s at 0.5 m/s, from rest.
    assert float(distance) == pytest.approx(5.0, abs=0.5)


def test_the_environment_is_activated_before_the_first_python_command():
    assert 0 < README.index(". .venv/bin/activate") < README.index("`python ")
