"""The page *Your first change*: its files and commands, in the page's order, with small budgets."""

import re
import shlex
import subprocess
import sys

import pytest
from paths import ROOT, importing
from waiting import output_of

from quadruped_env.policies import load_policy

PAGE = (ROOT / "docs" / "first-change.md").read_text()
PIECE = re.compile(
    r"^```python\n# (?P<file>\S+\.py)\n(?P<code>.*?)^```$|^ {4}(?P<command>(?:mini-quadruped|python) [^\n]*)$",
    re.MULTILINE | re.DOTALL,
)
SMALL = {
    "train": "--timesteps 6144",
    "compare": "--seeds 1 --seconds 1 --no-video",
    "baseline": "--episodes 1 --seconds 1",
    "view": "--measure 0.1",
    "steps.py": "",
}
"""Second word of a command -> options that make it short; the last value of an option counts."""


@pytest.mark.slow
def test_files_and_commands_of_the_page_run_in_order(tmp_path):
    program = f"{shlex.quote(sys.executable)} -m quadruped_env"
    shell = f'mini-quadruped() {{ {program} "$@"; }}; python() {{ {shlex.quote(sys.executable)} "$@"; }}; '
    printed = {}
    for piece in PIECE.finditer(PAGE):
        if piece["file"]:
            (tmp_path / piece["file"]).write_text(piece["code"])
            continue
        command = piece["command"]
        line = f"{shell}{command} {SMALL[command.split()[1]]}"
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
        with subprocess.Popen(["bash", "-c", line], cwd=tmp_path, env=importing(), **pipes) as running:
            printed[command], _ = output_of(running)
        assert running.returncode == 0, f"{command}\n{printed[command]}"
    assert len(printed) == 9

    before, high, command = (
        load_policy(next((tmp_path / "runs").glob(f"*-{name}"))).config for name in ("before", "high", "command")
    )
    assert (before.reward.foot_lift, high.reward.foot_lift) == (0.012, 0.04)
    assert high.reward.weights.gait_clock == 16.0
    assert command.command.step_height == (0.01, 0.04)
    assert len(re.findall(r"^commanded \d+ mm", printed["python steps.py"], re.MULTILINE)) == 3
