"""`make install` with pretended Pythons: the interpreter it chooses, and where torch comes from."""

import importlib.metadata
import json
import os
import shutil
import subprocess
import sys
import tomllib

import pytest
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name
from paths import ROOT

from quadruped_env.utils import interpreter

CPU_INDEX = "https://download.pytorch.org/whl/cpu"
CONSTRAINTS = (ROOT / "constraints.txt").read_text().splitlines()
TORCH = next(line for line in CONSTRAINTS if line.startswith("torch=="))
PRETENDED = f"""#!{sys.executable} -IS
import json, os, shutil, sys
from pathlib import Path

program = Path(os.path.abspath(sys.argv[0]))
here = Path(os.environ["PRETENDED"])
config = json.loads((here / "config.json").read_text())
version = Path(os.readlink(program)).name.removeprefix("pretended-")
sys.version_info = tuple(map(int, version.split("."))) + (0,)
sys.path[:0] = [str(here / "installed"), "."]
arguments = sys.argv[1:]
if arguments[0] == "-c":
    exec(arguments[1])
elif arguments[:3] == ["-m", "venv", "--clear"]:
    shutil.rmtree(arguments[3], ignore_errors=True)
    folder = Path(arguments[3], "bin")
    folder.mkdir(parents=True)
    (folder / "python").symlink_to(os.readlink(program))
    (folder.parent / "pyvenv.cfg").touch()
else:
    assert arguments[:2] == ["-m", "pip"], arguments
    asked = [word for word in arguments[2:] if word not in ("--quiet", "--disable-pip-version-check")]
    with open(here / "log", "a") as log:
        print(*asked, file=log)
    sys.exit(any(word in config["unavailable"] for word in asked))
"""


class Checkout:
    """A copy of what `make install` reads, and a PATH of pretended Pythons."""

    def __init__(self, folder):
        self.folder, self.programs = folder, folder / "programs"
        (folder / "tools").mkdir()
        self.programs.mkdir()
        for name in ("Makefile", "constraints.txt", "pyproject.toml", "tools/install.sh"):
            shutil.copy(ROOT / name, folder / name)
        (folder / "quadruped_env.py").touch()
        for name in ("make", "sh", "dirname", "sed", "grep", "touch", "uname", "tr"):
            (self.programs / name).symlink_to(shutil.which(name))
        self.unavailable = [f"{TORCH}+cpu"]

    def add_python(self, name, version):
        pretended = self.folder / f"pretended-{version}"
        pretended.write_text(PRETENDED)
        pretended.chmod(0o755)
        (self.programs / name).symlink_to(pretended)

    def add_venv(self, version):
        (self.folder / ".venv" / "bin").mkdir(parents=True)
        (self.folder / ".venv" / "pyvenv.cfg").touch()
        (self.folder / ".venv" / "bin" / "python").symlink_to(self.folder / f"pretended-{version}")

    def add_installed(self, name, version):
        folder = self.folder / "installed" / f"{name}-{version}.dist-info"
        folder.mkdir(parents=True)
        (folder / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n")

    def make(self, *arguments):
        (self.folder / "config.json").write_text(json.dumps({"unavailable": self.unavailable}))
        (self.folder / "log").unlink(missing_ok=True)
        environment = {"PATH": str(self.programs), "PRETENDED": str(self.folder)}
        command = ["make", "-C", self.folder, *arguments]
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)

    @property
    def installations(self):
        """Arguments of pip, but for calls that ask for its version."""
        log = self.folder / "log"
        return [line for line in log.read_text().splitlines() if line != "--version"] if log.exists() else []

    @property
    def version(self):
        """Version of `.venv`."""
        return os.readlink(self.folder / ".venv" / "bin" / "python").rpartition("-")[2]


@pytest.fixture
def checkout(tmp_path):
    return Checkout(tmp_path)


@pytest.mark.parametrize("page", ["README.md", "README.zh-CN.md", "docs/install.md", "docs/troubleshooting.md"])
def test_command_for_the_cpu_build_is_that_of_the_hints(page):
    assert f"pip install {interpreter.CPU_TORCH}" in (ROOT / page).read_text()
    assert CPU_INDEX in interpreter.CPU_TORCH


PACKAGE = "install -c constraints.txt -e .[test]"
OWN_CPU = f"install -c constraints.txt {TORCH}+cpu"
FROM_INDEX = f"install --no-deps --retries 1 --index-url {{}} {TORCH}"


def test_every_pin_supports_the_first_patch_release_of_the_oldest_python():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    oldest = project["requires-python"].removeprefix(">=") + ".0"
    pins = {canonicalize_name(line.partition("==")[0]) for line in CONSTRAINTS if "==" in line}
    required = {
        f"{distribution.name}=={distribution.version}": distribution.metadata["Requires-Python"] or ""
        for distribution in importlib.metadata.distributions()
        if canonicalize_name(distribution.name) in pins
    }
    assert len(required) > 50
    assert {pin: need for pin, need in required.items() if not SpecifierSet(need).contains(oldest)} == {}


class TestPython:
    def test_without_a_recent_python_an_error_says_how_to_get_one_before_any_download(self, checkout):
        checkout.add_python("python3", "3.10")
        done = checkout.make("install")
        assert done.returncode == 2
        error = done.stderr.splitlines()[0]
        assert error.startswith("error: python3 is Python 3.10, and 3.11 or later is needed. Install one next to it, ")
        assert "uv python install 3.12" in error
        assert "apt install python3.12-venv" in error
        assert "PYTHON=/path/to/python" in error
        assert checkout.installations == []
        assert not (checkout.folder / ".venv").exists()

    def test_program_of_pyenv_that_starts_no_python_is_passed_over(self, checkout):
        checkout.add_python("python3", "3.10")
        checkout.add_python("python3.14", "3.14")
        shim = checkout.programs / "python3.12"
        shim.write_text("#!/bin/sh\necho 'pyenv: python3.12: command not found' >&2\nexit 127\n")
        shim.chmod(0o755)
        assert checkout.make("install").returncode == 0
        assert checkout.version == "3.14"

    def test_venv_of_a_python_that_is_too_old_is_made_again(self, checkout):
        checkout.add_python("python3", "3.10")
        checkout.add_venv("3.10")
        checkout.add_python("python3.12", "3.12")
        assert checkout.make("install").returncode == 0
        assert checkout.version == "3.12"

    def test_venv_is_kept_unless_another_python_is_asked_for(self, checkout):
        checkout.add_python("python3", "3.11")
        checkout.add_python("python3.13", "3.13")
        assert checkout.make("install", "PYTHON=python3.13").returncode == 0
        assert checkout.version == "3.13"
        os.utime(checkout.folder / "pyproject.toml", (2e10, 2e10))  # as after a pull
        assert checkout.make("install").returncode == 0
        assert (checkout.version, checkout.installations[-1]) == ("3.13", PACKAGE)
        (checkout.folder / ".venv" / "mine").touch()
        assert checkout.make("install", "PYTHON=python3.13").returncode == 0
        assert (checkout.folder / ".venv" / "mine").exists()
        assert checkout.make("install", "PYTHON=python3").returncode == 0
        assert checkout.version == "3.11"

    def test_python_that_is_named_and_too_old_is_an_error(self, checkout):
        checkout.add_python("python3", "3.12")
        checkout.add_python("python3.10", "3.10")
        done = checkout.make("install", "PYTHON=python3.10")
        assert done.stderr.startswith("error: python3.10 is Python 3.10, and 3.11 or later is needed")

    def test_folder_that_is_no_venv_is_not_emptied(self, checkout):
        checkout.add_python("python3", "3.12")
        done = checkout.make("install", "VENV=tools")
        assert done.returncode == 2
        assert "error: tools exists and is not a virtual environment" in done.stderr
        assert (checkout.folder / "tools" / "install.sh").exists()


@pytest.mark.skipif(
    not sys.platform.startswith("linux") or os.uname().machine not in ("x86_64", "aarch64"),
    reason="torch comes from PyPI on this platform",
)
class TestPackages:
    @pytest.fixture(autouse=True)
    def python(self, checkout):
        checkout.add_python("python3", "3.12")

    def test_torch_comes_from_the_cpu_index_where_pip_has_no_cpu_build(self, checkout):
        assert checkout.make("install").returncode == 0
        assert checkout.installations == [OWN_CPU, FROM_INDEX.format(CPU_INDEX), PACKAGE]

    def test_cpu_build_that_pip_has_is_used_without_the_index(self, checkout):
        checkout.unavailable = []
        assert checkout.make("install").returncode == 0
        assert checkout.installations == [OWN_CPU, PACKAGE]

    def test_torch_that_is_installed_is_kept(self, checkout):
        checkout.add_installed("torch", TORCH.removeprefix("torch==") + "+cu130")
        assert checkout.make("install").returncode == 0
        assert checkout.installations == [PACKAGE]

    def test_index_that_is_named_is_used(self, checkout):
        checkout.unavailable = []
        index = "https://download.pytorch.org/whl/cu130"
        assert checkout.make("install", f"TORCH_INDEX={index}").returncode == 0
        assert checkout.installations == [FROM_INDEX.format(index), PACKAGE]

    def test_index_that_fails_error_names_the_alternatives_and_nothing_else_is_installed(self, checkout):
        checkout.unavailable.append(TORCH)
        done = checkout.make("install")
        assert done.returncode == 2
        assert f"error: no {TORCH.replace('==', ' ')} for Python 3.12 from {CPU_INDEX}. " in done.stderr
        assert "'make install TORCH_INDEX='" in done.stderr
        assert PACKAGE not in checkout.installations
        assert not (checkout.folder / ".venv" / ".installed").exists()

    def test_older_mujoco_is_removed_before_anything_is_installed(self, checkout):
        checkout.add_installed("mujoco", "3.11.0")
        assert checkout.make("install").returncode == 0
        assert checkout.installations[0] == "uninstall -y mujoco"

    def test_documentation_needs_no_torch(self, checkout):
        checkout.make("docs")  # then Sphinx is missing
        assert checkout.installations == ["install -c constraints.txt -e .[docs]"]

    def test_dev_brings_the_rest_once(self, checkout):
        assert checkout.make("dev").returncode == 0
        assert checkout.installations[-1] == PACKAGE.replace("test", "dev")
        assert checkout.make("install", "dev").returncode == 0
        assert checkout.installations == []
