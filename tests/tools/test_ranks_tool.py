"""The measurement of two ranks against one, with small numbers."""

import json
import subprocess
import sys

import pytest
from paths import ROOT
from waiting import DEADLINE

pytestmark = pytest.mark.slow


def measure(output, *arguments):
    command = [sys.executable, str(ROOT / "tools" / "ranks.py"), "-o", str(output), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=DEADLINE)
    assert done.returncode == 0, done.stderr
    return done.stdout, json.loads(output.read_text())


def test_speed_is_that_of_pairs_of_runs(tmp_path):
    text, found = measure(tmp_path / "ranks.json", "--only", "speed", "--rounds", "1")
    assert "two ranks over one" in text
    (pair,) = found["speed"]
    assert len(pair) == 2
    assert all(one["steps_per_second"] > 0 and one["update_seconds"] > 0 for one in pair)
    exchange = found["exchange"]
    assert exchange["gradient_steps"] == 16
    assert min(exchange["all_reduce_microseconds"].values()) > 0


def test_seeds_that_were_trained_are_not_trained_again(tmp_path):
    arguments = ("--only", "walk", "--timesteps", "8192", "--every", "4096")
    _, first = measure(tmp_path / "ranks.json", *arguments, "--seeds", "0")
    assert [(one["seed"], one["ranks"], one["seconds"]) for one in first["walk"]["results"]] == [
        (0, 1, None),
        (0, 2, None),
    ]
    text, second = measure(tmp_path / "ranks.json", *arguments, "--seeds", "0", "--timesteps", "8192")
    assert second["walk"] == first["walk"]
    assert "seed 0" not in text
