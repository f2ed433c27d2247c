"""Modules that an import of the package loads, and registration of the environments without an import of Gymnasium."""

import subprocess
import sys

import pytest

import quadruped_env

MAKE = "gymnasium.make('MiniQuadruped-v0'); gymnasium.make_vec('MiniQuadrupedRough-v0', num_envs=2)"


def run(code):
    """Output of a fresh Python that runs the code."""
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize(
    "imports",
    [
        "import quadruped_env, gymnasium",
        "import quadruped_env, importlib.util; importlib.util.find_spec('gymnasium'); import gymnasium",
        "import quadruped_env, gymnasium.spaces, gymnasium",
    ],
)
def test_environments_are_registered_in_either_order(imports):
    run(f"{imports}; {MAKE}")


def test_registration_waits_for_another_thread_that_imports_gymnasium():
    run(f"""
import importlib.machinery, sys, threading

class Held:
    def find_spec(self, name, path=None, target=None):
        if name == "gymnasium.core":
            spec = importlib.machinery.PathFinder.find_spec(name, path)
            execute = spec.loader.exec_module
            spec.loader.exec_module = lambda module: (begun.set(), go_on.wait(1.0), execute(module))
            return spec

begun, go_on = threading.Event(), threading.Event()
sys.meta_path.insert(0, Held())
thread = threading.Thread(target=lambda: __import__("gymnasium"))
thread.start()
begun.wait()
import quadruped_env, gymnasium
{MAKE}
""")


def test_make_loads_few_modules_and_nothing_of_recordings_or_ros():
    print_modules = "import sys; print(*(name for name in sys.modules if name.startswith('quadruped_env')))"
    loaded = run(f"import gymnasium, quadruped_env; gymnasium.make('MiniQuadruped-v0'); {print_modules}").split()
    unneeded = tuple(f"quadruped_env.{name}" for name in ("trajectory", "ros", "live", "reporting", "policies"))
    assert [name for name in loaded if name.startswith(unneeded)] == []
    assert len(loaded) <= 82


def test_names_are_imported_when_they_are_used():
    assert set(quadruped_env.__all__) <= set(dir(quadruped_env))
    assert all(getattr(quadruped_env, name) is not None for name in quadruped_env.__all__)
    assert quadruped_env.task.TaskConfig
    with pytest.raises(AttributeError, match="has no attribute 'tasks'"):
        _ = quadruped_env.tasks
