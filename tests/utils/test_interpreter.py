"""Commands that the programs print, and their error under an old Python."""

import os
import re
import shlex
import subprocess
import sys
import tomllib
from pathlib import Path

import gymnasium
import pytest
from paths import ROOT
from ros2_peers import install as ros2_install

from quadruped_env import __version__
from quadruped_env.utils import interpreter

PYTHON = sys.executable


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, check=False, **options)


@pytest.mark.parametrize("version", ["3.8", "3.10"])
def test_program_with_an_old_python_ends_with_a_sentence(version, monkeypatch):
    monkeypatch.delenv(f"PYTHON{version.replace('.', '')}", raising=False)
    old = ros2_install.python(version)
    if old is None:
        pytest.skip(f"no Python {version} on this machine")
    for program in (["train/ppo.py"], ["-m", "quadruped_env", "train"]):
        done = run(old, *program, cwd=ROOT)
        assert (done.returncode, done.stdout) == (1, "")
        last = done.stderr.splitlines()[-1]
        assert last.startswith(f"ImportError: mini-quadruped needs Python 3.11 or later; this is {old}, {version}.")


@pytest.fixture
def environment(monkeypatch, tmp_path):
    """A virtual environment below the working directory, which is not on the PATH."""
    programs = tmp_path / "my venv" / "bin"
    programs.mkdir(parents=True)
    for name in ("python", "mini-quadruped"):
        (programs / name).touch(0o755)
    monkeypatch.setattr(sys, "executable", str(programs / "python"))
    monkeypatch.setenv("PATH", os.defpath)
    monkeypatch.chdir(tmp_path)
    return programs


def test_program_command_is_the_name_only_where_the_path_has_this_pythons(environment, monkeypatch, tmp_path):
    assert interpreter.program_command("view", "my run") == "'my venv/bin/mini-quadruped' view 'my run'"
    assert interpreter.module_command("tensorboard.main") == "'my venv/bin/python' -m tensorboard.main"
    monkeypatch.chdir(ROOT)
    assert interpreter.program_command("view") == f"'{environment}/mini-quadruped' view"
    monkeypatch.setenv("PATH", str(environment))
    assert interpreter.program_command("view") == "mini-quadruped view"
    other = tmp_path / "other"
    other.mkdir()
    (other / "mini-quadruped").touch(0o755)
    monkeypatch.setenv("PATH", f"{other}{os.pathsep}{environment}")
    assert interpreter.program_command("view") == f"'{environment}/mini-quadruped' view"


@pytest.mark.parametrize("directory", [ROOT, ROOT / "docs"])
def test_program_command_of_a_checkout_without_installation_starts_the_package(environment, monkeypatch, directory):
    (environment / "mini-quadruped").unlink()
    monkeypatch.chdir(directory)
    python, *words = shlex.split(interpreter.program_command("train", "--version"))
    assert python == str(environment / "python")
    # Without the file that makes an editable installation importable.
    packages = os.environ | {"PYTHONPATH": str(Path(gymnasium.__file__).parents[1])}
    done = run(PYTHON, "-S", words[0], "--version", cwd=directory, env=packages)
    assert done.stdout == f"mini-quadruped {__version__}\n", done.stderr


def test_hint_for_an_extra_installs_the_cpu_build_of_torch_first():
    index = "https://download.pytorch.org/whl/cpu"
    assert interpreter.install_command("train") == (
        f"pip install torch --index-url {index} && pip install 'mini-quadruped[train]'"
    )
    assert interpreter.install_command("report") == "pip install 'mini-quadruped[report]'"


def test_extras_with_torch_are_those_of_the_hint():
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]

    def needs_torch(extra):
        inner = [re.match(r"mini-quadruped\[(.*)\]", need) for need in extras[extra]]
        return any(need.startswith("torch") for need in extras[extra]) or any(
            needs_torch(name) for match in inner if match for name in match[1].split(",")
        )

    assert {extra for extra in extras if needs_torch(extra)} == {*interpreter.CPU_TORCH_EXTRAS}
