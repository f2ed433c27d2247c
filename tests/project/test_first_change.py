"""The page *Your first change*: its files and commands, in its order, with small budgets; then `look.py`."""

import os
import re
import shlex
import signal
import subprocess
import sys

import pytest
from paths import ROOT, importing
from waiting import output_of

from quadruped_env.policies import load_policy

PAGE = (ROOT / "docs" / "first-change.md").read_text().replace("\\\n", " ")
SYMPTOMS = (ROOT / "docs" / "my-training-does-not-work.md").read_text().partition("\n## ")[0]
PIECE = re.compile(
    r"^```python\n# (?P<file>\S+\.py)\n(?P<code>.*?)^```$|^ {4}(?P<command>(?:mini-quadruped|python) [^\n]*)$",
    re.MULTILINE | re.DOTALL,
)
SMALL = {
    "train": "--timesteps 6144",
    "compare": "--seeds 1 --seconds 2",
    "baseline": "--episodes 1 --seconds 1",
    "drive.py": "",
    "look.py": "",
}
"""Second word of a command -> options that make it short; the last value of an option counts."""


@pytest.mark.slow
def test_files_and_commands_of_the_page_run_in_order(tmp_path):
    program = f"{shlex.quote(sys.executable)} -m quadruped_env"
    shell = f'mini-quadruped() {{ {program} "$@"; }}; python() {{ {shlex.quote(sys.executable)} "$@"; }}; '
    printed = {}
    for piece in PIECE.finditer(PAGE + SYMPTOMS):
        if piece["file"]:
            (tmp_path / piece["file"]).write_text(piece["code"])
            continue
        command = piece["command"]
        name = command.split()[1]
        line = f"{shell}{command} {SMALL.get(name, '--port 0')}"
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
        options = {"cwd": tmp_path, "env": importing(), "start_new_session": True}
        with subprocess.Popen(["bash", "-c", line], **options, **pipes) as running:
            if name == "view":
                assert "http://" in running.stdout.readline()
                os.killpg(running.pid, signal.SIGINT)
            printed[command], _ = output_of(running)
        assert running.returncode == 0, f"{command}\n{printed[command]}"
    assert len(printed) == 10

    runs = [next((tmp_path / "runs").glob(f"*-{name}")) for name in ("before", "thrifty")]
    assert [load_policy(run).config.reward.weights.electrical_power for run in runs] == [-0.04, -0.4]
    heavier, lighter = (printed[command] for command in printed if "baseline" in command)
    assert "Forward velocity" in heavier
    assert heavier != lighter
    for command in (command for command in printed if "drive.py" in command):
        assert len(re.findall(r"^command \(.*\): \[.*\], \d+\.\d W$", printed[command], re.MULTILINE)) == 3
    assert re.search(r"^gait_clock( +-?\d+\.\d\d){3}$", printed["python look.py runs/latest"], re.MULTILINE)
