"""Commands that the programs print, and their error under an old Python."""

import os
import re
import runpy
import shlex
import subprocess
import sys
import tomllib
import types
from pathlib import Path

import gymnasium
import pytest
from paths import ROOT
from ros2_peers import install as ros2_install

from quadruped_env import __version__
from quadruped_env.live.__main__ import main as run_node
from quadruped_env.utils import interpreter

PROGRAMS = [
    path.relative_to(ROOT)
    for folder in ("train", "evaluate", "tools")
    for path in sorted((ROOT / folder).glob("*.py"))
    if path.name != "release.py"  # it needs none of the package's dependencies
]
BARE = (sys.executable, "-S")
"""This Python without its installed packages."""


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


# --- commands to paste


@pytest.fixture
def python_on_path(tmp_path, monkeypatch):
    """A `python` on the PATH that is not this one."""
    (tmp_path / "bin").mkdir()
    other = tmp_path / "bin" / "python"
    other.write_text("#!/bin/sh\n")
    other.chmod(0o755)
    monkeypatch.setenv("PATH", str(other.parent))


def test_the_command_is_python_where_that_is_this_one(monkeypatch, tmp_path):
    (tmp_path / "python").symlink_to(sys.executable)
    monkeypatch.setattr(sys, "executable", str(tmp_path / "python3"))
    monkeypatch.setenv("PATH", str(tmp_path))
    (tmp_path / "python").chmod(0o755)
    assert interpreter.python_command() == "python"


@pytest.mark.usefixtures("python_on_path")
def test_the_command_is_this_pythons_path_where_python_is_another(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    assert interpreter.python_command() == shlex.quote(sys.executable)
    monkeypatch.setattr(sys, "executable", str(tmp_path / ".venv" / "bin" / "python"))
    assert interpreter.python_command() == os.path.join(".venv", "bin", "python")
    monkeypatch.setattr(sys, "executable", str(tmp_path / "my venv" / "bin" / "python"))
    assert interpreter.python_command() == "'my venv/bin/python'"


@pytest.mark.usefixtures("python_on_path")
@pytest.mark.parametrize("directory", [ROOT, Path("/")])
def test_commands_in_help_can_be_pasted(directory, monkeypatch):
    monkeypatch.chdir(directory)
    text = interpreter.pasteable("mini-quadruped view flat\n\nmini-quadruped COMMAND and 'pip install mini-quadruped'")
    first, _, second = text.splitlines()
    program = first.removesuffix(" view flat")
    done = run(*shlex.split(program), "--version", cwd=directory)
    assert done.stdout == f"mini-quadruped {__version__}\n", done.stderr
    assert second == f"{program} COMMAND and 'pip install mini-quadruped'"


@pytest.mark.usefixtures("python_on_path")
@pytest.mark.parametrize("program", [*PROGRAMS, Path("live")], ids=str)
def test_no_help_has_a_command_of_another_python(program, monkeypatch, capsys):
    monkeypatch.chdir(ROOT)
    monkeypatch.setattr(sys, "path", [*sys.path])
    monkeypatch.setattr(sys, "argv", [str(program), "--help"])
    try:
        if program == Path("live"):
            run_node(["record", "--help"])
        else:
            runpy.run_path(str(ROOT / program), run_name="__main__")
    except SystemExit as ended:
        assert ended.code == 0  # noqa: PT017
    _, _, text = capsys.readouterr().out.partition("\n\n")  # without the usage
    assert re.search(r"(?<!/)\b(python (train|evaluate|-m)|mini-quadruped \w)", text) is None


def test_hint_for_an_extra_installs_the_cpu_build_of_torch_first(monkeypatch):
    absent = {"torch"}
    finder = types.SimpleNamespace(find_spec=lambda name: None if name in absent else object())
    monkeypatch.setattr(interpreter, "PathFinder", finder)
    monkeypatch.setattr(interpreter, "python_command", lambda: "python")
    index = "https://download.pytorch.org/whl/cpu"
    for portable, pip in ((False, "python -m pip install"), (True, "pip install")):
        assert interpreter.install_command("train", portable) == (
            f"{pip} torch --index-url {index} && {pip} 'mini-quadruped[train]'"
        )
        assert interpreter.install_command("report", portable) == f"{pip} 'mini-quadruped[report]'"
    absent.add("pip")
    uv = "uv pip install --python python"
    assert interpreter.install_command("sweep") == f"{uv} torch --index-url {index} && {uv} 'mini-quadruped[sweep]'"
    absent.remove("torch")
    assert interpreter.install_command("train") == f"{uv} 'mini-quadruped[train]'"


def test_command_of_pip_leaves_distutils_as_it_is(monkeypatch):
    loaded = types.ModuleType("distutils")
    monkeypatch.setitem(sys.modules, "distutils", loaded)
    # As Python does at its start where setuptools is installed.
    monkeypatch.setattr(sys, "meta_path", [*sys.meta_path])
    pytest.importorskip("_distutils_hack", reason="no setuptools, whose hook it is").insert_shim()
    assert "pip" in interpreter.pip_command()
    assert sys.modules["distutils"] is loaded


def test_extras_with_torch_are_those_of_the_hint():
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]

    def needs_torch(extra):
        inner = [re.match(r"mini-quadruped\[(.*)\]", need) for need in extras[extra]]
        return any(need.startswith("torch") for need in extras[extra]) or any(
            needs_torch(name) for match in inner if match for name in match[1].split(",")
        )

    assert {extra for extra in extras if needs_torch(extra)} == {*interpreter.CPU_TORCH_EXTRAS}


@pytest.fixture
def copied(monkeypatch, tmp_path):
    """A checkout that is not installed for this Python; it holds a link to the package."""
    checkout = tmp_path / "my checkout"
    (checkout / "train").mkdir(parents=True)
    (checkout / "pyproject.toml").touch()
    (checkout / "quadruped_env").symlink_to(ROOT / "quadruped_env")
    (tmp_path / "bin").mkdir()
    monkeypatch.setattr(interpreter, "_CHECKOUT", checkout)
    monkeypatch.setattr(interpreter, "_is_installed", lambda: False)
    monkeypatch.setattr(sys, "executable", str(tmp_path / "bin" / "python"))
    return checkout


@pytest.mark.parametrize(
    ("directory", "expected"),
    [(".", "-m quadruped_env train --seed 1"), ("..", "'my checkout/quadruped_env' train --seed 1")],
)
def test_program_command_of_a_checkout_without_installation_starts_the_package(
    copied, monkeypatch, directory, expected
):
    monkeypatch.chdir(copied / directory)
    command = interpreter.program_command("train", "--seed", 1)
    assert command.split(" ", 1)[1] == expected
    words = shlex.split(command)[1:-3]
    # Without the file that makes an editable installation importable.
    environment = os.environ | {"PYTHONPATH": str(Path(gymnasium.__file__).parents[1])}
    done = run(*BARE, *words, "--version", cwd=copied / directory, env=environment)
    assert done.stdout == f"mini-quadruped {__version__}\n", done.stderr
