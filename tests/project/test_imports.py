"""What an import of the package loads, and what it changes."""

import subprocess
import sys

import pytest

import quadruped_env


def run(code):
    """Output of a fresh Python that runs the code."""
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout


def test_import_registers_the_environments_and_changes_nothing_else_in_the_process(tmp_path):
    code = """
import gymnasium, logging, mujoco, os, signal, sys, warnings

def state():
    config = mujoco.MjLogConfig.get()
    return [dict(os.environ), sys.meta_path, sys.path, os.getcwd(), os.listdir(), logging.root.handlers,
            warnings.filters, signal.getsignal(signal.SIGTERM), config.logto_file, set(gymnasium.registry)]

before = [part if isinstance(part, str | int | None) else part.copy() for part in state()]
import quadruped_env
*unchanged, envs = zip(before, state())
assert all(old == new for old, new in unchanged), unchanged
print(*sorted(envs[1] - envs[0]))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path, check=True)
    assert done.stdout.split() == ["MiniQuadruped-v0", "MiniQuadrupedRough-v0"]


def test_make_loads_few_modules_and_nothing_of_recordings_or_ros():
    print_modules = "import sys; print(*(name for name in sys.modules if name.startswith('quadruped_env')))"
    loaded = run(f"import gymnasium, quadruped_env; gymnasium.make('MiniQuadruped-v0'); {print_modules}").split()
    unneeded = tuple(f"quadruped_env.{name}" for name in ("trajectory", "ros", "live", "report", "policies"))
    assert [name for name in loaded if name.startswith(unneeded)] == []
    assert len(loaded) <= 82


def test_names_are_imported_when_they_are_used():
    assert set(quadruped_env.__all__) <= set(dir(quadruped_env))
    assert all(getattr(quadruped_env, name) is not None for name in quadruped_env.__all__)
    assert quadruped_env.task.TaskConfig
    with pytest.raises(AttributeError, match="has no attribute 'tasks'"):
        _ = quadruped_env.tasks
