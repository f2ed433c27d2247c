"""The measurement of a GPU's speed, run on Warp's CPU device with small numbers."""

import json
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


@pytest.mark.slow
def test_tool_measures_on_the_cpu(tmp_path):
    output = tmp_path / "gpu_speed.json"
    done = run(
        *("--device", "warp-cpu", "--num-envs", 2, 4, "--steps", 4, "--updates", 2),
        *("--walk", 4, "--limit", 0.5, "--interval", 0.1, "-o", output),
    )
    assert done.returncode == 0, done.stderr
    assert "time to walk with 4 envs, without compilation: not within the limit" in done.stdout
    document = json.loads(output.read_text())
    assert [speed["num_envs"] for speed in document["speeds"]] == [2, 4]
    for speed in document["speeds"]:
        # Which of them is larger depends on what else runs on the machine.
        assert min(speed["env_steps"], speed["training_steps"]) > 0.0
        assert speed["memory"] > 0.05
        assert speed["compilation"] > 0.0
    assert document["device"].startswith("the CPU of")
    assert document["walk"]["seconds"] is None


def test_goals_apply_to_the_best_number_of_envs():
    from benchmarks.gpu_speed import Speed, table, unreached

    slow, fast = Speed(1024, 4e5, 3e5, 1.0, 2.0), Speed(8192, 1.2e6, 3.9e5, 4.0, 2.0)
    assert unreached([slow, fast]) == ["training steps/s: 390,000; goal 400,000"]
    assert len(unreached([slow])) == 2
    assert "| 8,192 | 1,200,000 | 390,000 | 4.00 | 2 |" in table([slow, fast])
