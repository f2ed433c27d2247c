"""The policy that is evaluated, and where its results go."""

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from quadruped_env.control.policy import SHIPPED, finished_directory, shipped_directory
from quadruped_env.policies import Policy, load_policy
from quadruped_env.training.run import PROGRESS_FILE, run_name

LATEST_RUN: Final = Path("runs", "latest")


@dataclass(frozen=True)
class Subject:
    """A policy to evaluate, and where its results go."""

    name: str
    """Of the run, or of the shipped policy"""
    policy: Policy
    directory: Path
    """The training run, or the shipped policy's place in the package"""
    output: Path

    @property
    def source(self) -> str:
        """What a person types to name it again; no path of this machine."""
        return self.name if self.name in SHIPPED else f"runs/{self.name}"

    @property
    def progress_file(self) -> Path | None:
        """What its training logged, where that is still there."""
        path = self.directory / PROGRESS_FILE
        return path if path.is_file() else None


def find_subject(run: str | None, output: Path | None = None, task_file: Path | None = None) -> Subject:
    """The policy that a person names; of a run that was killed, that of its last checkpoint.

    Args:
        run: a run's directory or a shipped policy's name; None takes the latest run, or else the shipped policy.
        output: where the results go; None takes `evaluation` in the run's directory, or `results/<name>`.
        task_file: the user's file of terms that the run was trained with; it is executed.

    Raises:
        QuadrupedError: if there is no such policy, or it is damaged.

    Warns:
        QuadrupedWarning: if the policy is a checkpoint's, though the run was named.
    """
    if run is None:
        run = str(LATEST_RUN) if LATEST_RUN.exists() else SHIPPED[0]
    if run in SHIPPED:
        return Subject(run, load_policy(run), shipped_directory(run), output or Path("results", run))
    directory = finished_directory(Path(run)).resolve()
    return Subject(
        run_name(directory), load_policy(directory, task_file), directory, output or Path(run) / "evaluation"
    )
