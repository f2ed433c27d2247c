"""Install the package in fresh environments, and walk, as a new user does: the short set of CI.

    python .ci/first_contact.py [NAME ...]

One environment for each newer Python that this machine has, for the oldest MuJoCo, for the newest of everything, and
for a MuJoCo that pip breaks when it installs the package. One is a clone in which the distribution's own Python, often
of an early patch release, writes the documentation, as in a container. None needs torch. Two run at a time. Exit status
1 if one fails, but for the newest versions, whose failure is only shown: it is not this repository that changed.
"""

import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests" / "helpers" / "ros2_peers"))

from install import python  # noqa: E402

WALK = """
import gymnasium, mujoco, sys
import quadruped_env

assert "site-packages" in quadruped_env.__file__, quadruped_env.__file__
gymnasium.make("MiniQuadruped-v0").reset(seed=0)
policy = quadruped_env.policies.load_policy("flat")
env = policy.make_env()
observation, info = env.reset(seed=0, options={"command": (0.5, 0.0)})
distance = 0.0
for _ in range(250):
    observation, reward, terminated, truncated, info = env.step(policy.predict(observation))
    assert not terminated
    distance += info["base_linear_velocity"][0] * env.unwrapped.dt
assert 2.0 < distance < 3.0, distance
assert "torch" not in sys.modules
print(f"Python {sys.version.split()[0]}, MuJoCo {mujoco.__version__}: {distance:.2f} m in 5 s")
"""
SYSTEM_PYTHON = Path("/usr/bin/python3")
EVERYTHING = "report,viewer,ros,dds,identify,export,hub"
"""Extras that need no torch."""


@dataclass(frozen=True)
class Contact:
    """One environment."""

    name: str
    python: str = "3.11"
    extras: str = "report"
    pinned: bool = True
    """False: without constraints.txt."""
    before: str = ""
    """Requirement that is installed before the package."""
    repair: bool = False
    """True if the package can be imported only after the repair in docs/install.md."""
    must_pass: bool = True
    make: str = ""
    """Target of the Makefile that is made in a clone, with the distribution's Python and nothing else on PATH."""

    @property
    def interpreter(self) -> str | None:
        """Program that starts its Python; None if this machine has none."""
        if not self.make:
            return python(self.python)
        question = "import ensurepip, sys; sys.exit(sys.version_info < (3, 11))"
        usable = SYSTEM_PYTHON.exists() and not subprocess.run([SYSTEM_PYTHON, "-c", question], check=False).returncode  # noqa: S603
        return str(SYSTEM_PYTHON) if usable else None


CONTACTS = (
    Contact("python-3.12", python="3.12"),
    Contact("python-3.13", python="3.13"),
    Contact("python-3.14", python="3.14"),
    Contact("oldest-mujoco", pinned=False, before="mujoco==3.17.*"),
    Contact("broken-mujoco", extras="", pinned=False, before="mujoco==3.11.*", repair=True),
    Contact("docs-with-the-system's-python", python="3.11 or later in /usr/bin, with venv", make="docs"),
    Contact("newest", extras=EVERYTHING, pinned=False, must_pass=False),
)

INSTALL = ROOT / "docs" / "install.md"


def run(command: Sequence[str | Path], folder: Path, **environment: str) -> str:
    """Run a command, and return what it printed.

    Raises:
        RuntimeError: if it fails; with the end of its output.
    """
    done = subprocess.run(  # noqa: S603
        command,
        cwd=folder,
        env=os.environ | environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        check=False,
    )
    if done.returncode:
        raise RuntimeError(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout[-3000:]}")
    return done.stdout


def walk(contact: Contact, interpreter: str, wheel: Path, folder: Path) -> str:
    """Install in a new environment, walk, and write a report; return what the walk printed."""
    run([interpreter, "-m", "venv", folder / "venv"], folder)
    binaries = folder / "venv" / "bin"
    pip: list[str | Path] = [binaries / "python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    if contact.before:
        run([*pip, contact.before], folder)
    pinned = ["-c", str(ROOT / "constraints.txt")] if contact.pinned else []
    run([*pip, *pinned, f"{wheel}[{contact.extras}]" if contact.extras else wheel], folder)
    if contact.repair:
        try:
            run([binaries / "python", "-c", "import quadruped_env"], folder)
        except RuntimeError as error:
            if "core bindings ('mujoco-core') are missing" not in str(error):
                raise
            # MuJoCo's error names a repair too, after which the versions of its parts differ.
            (repair,) = re.findall(
                "^    (pip uninstall .* && pip install .*)$", INSTALL.read_text("utf-8"), re.MULTILINE
            )
            run(["sh", "-c", repair], folder, PATH=f"{binaries}{os.pathsep}{os.environ['PATH']}")
    (folder / "walk.py").write_text(WALK, encoding="utf-8")
    printed = run([binaries / "python", "-W", "error", "walk.py"], folder)
    if contact.extras:
        options = ["--seeds", "1", "--seconds", "2", "--no-video", "-o", "report"]
        run([binaries / "mini-quadruped", "evaluate", "flat", *options], folder)
        if not (folder / "report" / "report.html").stat().st_size:
            raise RuntimeError("report.html is empty")
    return printed.strip()


def make(contact: Contact, interpreter: str, folder: Path) -> str:
    """Clone the repository, make the target there, and return the Python's version."""
    run(["git", "clone", "--quiet", ROOT, "clone"], folder)
    clone, alone = folder / "clone", {"PATH": "/usr/bin:/bin", "HOME": str(folder)}
    run(["make", contact.make], clone, **alone)
    if not (clone / "build" / "site" / "index.html").stat().st_size:
        raise RuntimeError("build/site/index.html is empty")
    if changed := run(["git", "status", "--short"], clone):
        raise RuntimeError(f"git status: {changed}")
    return run([interpreter, "--version"], folder).strip()


def check(contact: Contact, wheel: Path) -> bool:
    """Check one environment, and print the result; False if it must pass and does not."""
    interpreter = contact.interpreter
    if interpreter is None:
        print(f"SKIP {contact.name}: no Python {contact.python} on this machine", flush=True)
        return True
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        try:
            walked = make(contact, interpreter, Path(folder)) if contact.make else ""
            result, text = "PASS", walked or walk(contact, interpreter, wheel, Path(folder))
        except (RuntimeError, OSError) as error:
            result, text = "FAIL" if contact.must_pass else "FAIL (only shown)", str(error)
    print(f"{result} {contact.name} ({time.monotonic() - began:.0f} s): {text}", flush=True)
    return result != "FAIL"


def main(names: Sequence[str]) -> int:
    """Check the environments of these names, or all."""
    chosen = [contact for contact in CONTACTS if not names or contact.name in names]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        run([sys.executable, "-m", "build", "--no-isolation", "--outdir", folder, ROOT], Path(folder))
        (wheel,) = Path(folder).glob("*.whl")
        results = list(pool.map(lambda contact: check(contact, wheel), chosen))
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
