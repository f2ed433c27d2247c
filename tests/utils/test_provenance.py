"""The commit of the package, and not of a repository around it."""

import subprocess

import pytest

from quadruped_env.utils import provenance


@pytest.mark.parametrize("tracked", [True, False])
def test_commit_is_that_of_a_repository_only_if_it_tracks_the_package(tmp_path, monkeypatch, tracked):
    def git(*arguments):
        author = ("-c", "user.name=a", "-c", "user.email=a@b")
        subprocess.run(["git", "-C", tmp_path, *author, *arguments], check=True, capture_output=True)

    package = tmp_path / ".venv" / "lib" / "provenance.py"
    package.parent.mkdir(parents=True)
    package.touch()
    (tmp_path / "robot.py").touch()
    git("init")
    git("add", "robot.py", *([package] if tracked else []))
    git("commit", "-m", "theirs")
    monkeypatch.setattr(provenance, "__file__", str(package))
    commit = provenance.git_commit()
    assert (len(commit) == 12) is tracked
    assert (commit == "unknown") is not tracked
