"""The environments with the oldest Gymnasium that the package supports; the other tests run with the newest."""

import os
import subprocess
import sys
import tomllib

import pytest
from paths import ROOT, TESTS

OLDEST = "1.2.0"
CORE = ("test_envs.py", "test_autoreset.py", "test_sb3.py")
INDEPENDENT = "not last_bit and not whatever_happens"
"""Without the long tests of the task itself."""


def run(*command, **kwargs):
    # No deadline: the tests that run here have their own.
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **kwargs)
    return done.returncode, done.stdout


def test_oldest_gymnasium_tested_is_the_oldest_that_the_package_supports():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert f"gymnasium>={OLDEST.removesuffix('.0')}" in project["dependencies"]


@pytest.mark.slow
def test_environments_with_the_oldest_gymnasium_pass_their_tests(tmp_path):
    target = tmp_path / "site"
    status, out = run(
        sys.executable, "-m", "pip", "install", "--no-deps", "--target", str(target), f"gymnasium=={OLDEST}"
    )
    if status:
        pytest.skip(f"gymnasium {OLDEST} cannot be installed: {out.strip().splitlines()[-1]}")
    path = os.pathsep.join([str(target), str(ROOT), os.environ.get("PYTHONPATH", "")])
    environment = {**os.environ, "PYTHONPATH": path.rstrip(os.pathsep)}
    status, out = run(
        sys.executable, "-c", "import gymnasium; print(gymnasium.__version__)", env=environment, cwd=tmp_path
    )
    assert out.strip() == OLDEST
    files = [str(TESTS / "envs" / name) for name in CORE]
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", INDEPENDENT, *files]
    status, out = run(*command, env=environment, cwd=ROOT)
    assert status == 0, out
    assert " passed" in out
