"""The measurement of a sweep against trainings in a row."""

import json
import subprocess
import sys

import pytest
from paths import ROOT, importing
from waiting import DEADLINE


@pytest.mark.slow
def test_sweep_speed_measures_both_and_the_memory(tmp_path):
    pytest.importorskip("ray")
    output = tmp_path / "speed.json"
    done = subprocess.run(
        [sys.executable, ROOT / "tools" / "sweep_speed.py", "--seeds", "2", "--timesteps", "20000", "-o", output],
        capture_output=True,
        text=True,
        check=False,
        timeout=4 * DEADLINE,
        env=importing(),
    )
    assert done.returncode == 0, done.stdout + done.stderr
    document = json.loads(output.read_text())
    assert len(document["by_hand_seconds"]) == 2
    assert document["ratio"] == pytest.approx(document["sweep_seconds"] / sum(document["by_hand_seconds"]))
    assert min(document["memory_mb"][kind] for kind in ("driver", "one trial", "Ray")) > 1.0
