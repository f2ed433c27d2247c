"""Modules that the nodes load: those that run on a robot load neither viewer, evaluation nor training."""

import subprocess
import sys

import pytest

ON_A_ROBOT = ("controller", "echo", "gait", "hz", "list", "record", "sim", "state", "teleop")
LIST_MODULES = """
import sys
from quadruped_env.live.nodes import node_module
node_module(sys.argv[1])
print(*sys.modules)
"""


PROGRAM = """
import sys
from quadruped_env.live.__main__ import main
try:
    main([sys.argv[1], "--help"])
finally:
    print()
    print(*sys.modules)
"""


def loaded_by(node, code=LIST_MODULES):
    """Names of the modules that a fresh Python has loaded once it imported a node, or ran other code with its name."""
    result = subprocess.run([sys.executable, "-c", code, node], capture_output=True, text=True, check=True)
    return result.stdout.splitlines()[-1].split()


@pytest.mark.parametrize(("node", "code"), [*((node, LIST_MODULES) for node in ON_A_ROBOT), ("controller", PROGRAM)])
def test_node_on_a_robot_imports_no_viewer_evaluation_or_training(node, code):
    loaded = loaded_by(node, code)
    assert f"quadruped_env.live.nodes.{node}" in loaded
    packages = tuple(f"quadruped_env.{name}" for name in ("viewer", "reporting", "replay", "evaluation", "training"))
    assert [name for name in loaded if name.startswith(packages)] == []
    assert not {"matplotlib", "viser", "torch", "stable_baselines3"} & set(loaded)
    if node == "controller":
        packages = ("task", "envs", "simulation", "policies", "trajectory")
        assert not {"gymnasium", *(f"quadruped_env.{name}" for name in packages)} & set(loaded)


def test_view_node_imports_the_viewer():
    """The names that the other test looks for exist."""
    assert "quadruped_env.viewer.viewer_scene" in loaded_by("view")
