"""Commands that the programs print, and their error under a Python without their dependencies."""

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


# --- the wrong Python


def test_program_with_a_wrong_python_names_the_right_one_in_one_line(tmp_path):
    for program in PROGRAMS:
        done = run(*BARE, ROOT / program, "--flag", cwd=tmp_path)
        assert (done.returncode, done.stdout) == (2, ""), program
        (line,) = done.stderr.splitlines()
        assert line.startswith(f"error: {sys.executable} has no gymnasium, mujoco, numpy, safetensors; ")
        assert line.endswith(f"/.venv/bin/python -S {ROOT / program} --flag")


def test_package_with_a_wrong_python_names_the_right_one_in_one_line():
    for program in ("-m quadruped_env.live", "-m quadruped_env", "quadruped_env"):
        done = run(*BARE, *program.split(), "sim", cwd=ROOT)
        assert done.returncode == 2
        (line,) = done.stderr.splitlines()
        assert line.endswith(f"run it with .venv/bin/python -S {program} sim")
    done = run(*BARE, "-c", "import quadruped_env", cwd=ROOT)
    assert done.returncode == 1
    assert re.search(r"ModuleNotFoundError: .* has no gymnasium, .*", done.stderr.splitlines()[-1])


def test_python_that_is_too_old_error_names_its_version(monkeypatch):
    monkeypatch.setattr(interpreter, "OLDEST", (99, 0))
    with pytest.raises(ModuleNotFoundError, match=r"is Python 3\.\d+, and 99\.0 or later is needed; "):
        interpreter.check_python()


@pytest.mark.parametrize("version", ["3.6", "3.8", "3.10"])
@pytest.mark.parametrize("program", [["train/ppo.py"], ["-m", "quadruped_env", "train"]], ids=" ".join)
def test_program_with_an_old_python_names_the_version_in_one_line(version, program, monkeypatch):
    monkeypatch.delenv(f"PYTHON{version.replace('.', '')}", raising=False)
    old = ros2_install.python(version)
    if old is None:
        pytest.skip(f"no Python {version} on this machine")
    done = run(old, *program, cwd=ROOT)
    assert (done.returncode, done.stdout) == (2, "")
    (line,) = done.stderr.splitlines()
    assert line.startswith(f"error: {old} is Python {version}, and 3.11 or later is needed; ")


@pytest.mark.parametrize(
    ("versions", "modules", "lack"),
    [
        ({"mujoco": "3.11.0"}, ["_structs"], "has mujoco 3.11.0, and 3.17 or later is needed"),
        (
            # After pip has replaced an older one.
            {"mujoco": "4.0.0", "mujoco-core": "4.0.0", "mujoco-studio": "4.0.0"},
            [],
            "has mujoco 4.0.0 and mujoco-core 4.0.0 and mujoco-studio 4.0.0 with files missing",
        ),
        (
            # After the repair that MuJoCo's own error names.
            {"mujoco": "4.0.0", "mujoco-core": "4.0.1"},
            ["_structs"],
            "has mujoco 4.0.0 and mujoco-core 4.0.1, which do not fit together",
        ),
        ({"mujoco": "3.17.0", "mujoco-core": "4.0.0"}, ["_structs"], None),  # pip leaves the parts of a newer one
        ({"mujoco": "4.1.0.dev5", "mujoco-core": "4.1.0.dev5"}, ["_structs"], None),
    ],
)
def test_mujoco_that_cannot_be_used_error_names_a_repair(versions, modules, lack, tmp_path):
    for name in ("gymnasium", "numpy", "safetensors", "pip", "mujoco"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").touch()
    for name in modules:
        (tmp_path / "mujoco" / f"{name}.py").touch()
    for name, version in versions.items():
        folder = tmp_path / f"{name.replace('-', '_')}-{version}.dist-info"
        folder.mkdir()
        (folder / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n")
    code = "from quadruped_env import _python"  # the package's own __init__ checks before anything else
    done = run(*BARE, "-c", code, cwd=ROOT, env=os.environ | {"PYTHONPATH": str(tmp_path)})
    last = done.stderr.splitlines()[-1]
    if lack is None:
        assert "uninstall" not in last  # it fails later, in these empty packages
        return
    python = re.escape(interpreter.python_command())
    repair = (
        rf"{python} -m pip uninstall -y mujoco mujoco-core mujoco-studio && {python} -m pip install 'mujoco>=3\.17'"
    )
    assert re.fullmatch(rf"ModuleNotFoundError: \S+ {re.escape(lack)}; {repair}", last)


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
    find_spec = lambda name: None if name in absent else object()  # noqa: E731
    monkeypatch.setattr(interpreter, "find_spec", find_spec)
    monkeypatch.setattr(interpreter, "PathFinder", types.SimpleNamespace(find_spec=find_spec))
    monkeypatch.setattr(interpreter, "python_command", lambda: "python")
    index = "https://download.pytorch.org/whl/cpu"
    for portable, pip in ((False, "python -m pip install"), (True, "pip install")):
        assert interpreter.install_command("train", portable) == (
            f"{pip} torch --index-url {index} && {pip} 'mini-quadruped[train]'"
        )
    absent.add("pip")
    uv = "uv pip install --python python"
    assert interpreter.install_command("sweep") == f"{uv} torch --index-url {index} && {uv} 'mini-quadruped[sweep]'"
    assert interpreter.pip_command("uninstall") == "uv pip uninstall --python python"
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
