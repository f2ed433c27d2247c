"""Modules that the nodes load: those that run on a robot load neither viewer, evaluation nor training."""

import subprocess
import sys

ON_A_ROBOT = ("calibrate", "controller", "gait", "record", "sim", "state", "teleop")
PROGRAM = """
import contextlib, sys
from quadruped_env.live.__main__ import main
from quadruped_env.live.nodes import node_module
with contextlib.suppress(SystemExit):
    main(["controller", "--help"])
print()
print(*sys.modules)
for node in sys.argv[1:]:
    node_module(node)
print(*sys.modules)
node_module("view")
print(*sys.modules)
"""


def test_nodes_on_a_robot_import_no_viewer_evaluation_or_training():
    command = [sys.executable, "-c", PROGRAM, *ON_A_ROBOT]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    by_controller, loaded, with_view = (line.split() for line in done.stdout.splitlines()[-3:])
    packages = ("task", "envs", "simulation", "policies.policy", "trajectory.joint_trajectory", "trajectory.formats")
    assert "quadruped_env.live.nodes.controller" in by_controller
    assert not {f"quadruped_env.{name}" for name in packages} & set(by_controller)
    assert {"quadruped_env.live.nodes.listen", "quadruped_env.live.nodes.teleop"} <= set(loaded)
    packages = tuple(f"quadruped_env.{name}" for name in ("viewer", "reporting", "replay", "evaluation", "training"))
    assert [name for name in loaded if name.startswith(packages)] == []
    assert not {"matplotlib", "viser", "torch", "stable_baselines3"} & set(loaded)
    assert "quadruped_env.viewer.viewer_scene" in with_view, "the names above exist"
