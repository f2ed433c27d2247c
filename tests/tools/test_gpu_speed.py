"""The measurement of a GPU's speed, run on Warp's CPU device with small numbers."""

import subprocess
import sys

import pytest
from paths import ROOT
from waiting import DEADLINE

pytest.importorskip("mujoco_warp", reason="MuJoCo Warp is not installed: pip install -e '.[gpu]'")
pytest.importorskip("rsl_rl", reason="rsl-rl is not installed: pip install -e '.[gpu]'")

SCRIPT = ROOT / "tools" / "gpu_speed.py"


def run(*arguments):
    command = [sys.executable, str(SCRIPT), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=5 * DEADLINE)


def test_goals_apply_to_the_best_number_of_envs():
    from benchmarks.gpu_speed import Speed, table, unreached

    slow, fast = Speed(1024, 4e5, 3e5, 1.0, 2.0), Speed(8192, 1.2e6, 3.9e5, 4.0, 2.0)
    assert unreached([slow, fast]) == ["training steps/s: 390,000; goal 400,000"]
    assert len(unreached([slow])) == 2
    assert "| 8,192 | 1,200,000 | 390,000 | 4.00 | 2 |" in table([slow, fast])
