"""Learning speed: what a training meets of the suite's commands after some time of learning.

The commands are those that the suite draws, one undisturbed episode of 10 s each, with the suite's tolerance. The
policies are checkpoints of one training, whose schedules end with the last time.
"""

import math
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Final

import numpy as np

from benchmarks.measures import Say
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.steady import run_command_map
from quadruped_env.evaluation.suite.suite_definition import CommandMap, full_suite
from quadruped_env.policies import Policy, load_policy
from quadruped_env.policies.files import CHECKPOINTS
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.training.recipes import with_recipe
from quadruped_env.training.train import train

COMMANDS: Final = replace(full_suite().commands, num_seeds=1, axes={})
_SHARE: Final = 0.05
"""Time between checkpoints, as a share of the time until the first one that is tested."""


@dataclass(frozen=True)
class Point:
    """A checkpoint of a training, tested."""

    seed: int
    seconds: float
    """Wall clock of learning, s"""
    timesteps: int
    met: float
    """Share of the commands that it meets"""
    forward_velocity_error: float
    """Mean over the commands of the error of the mean velocity, without sign, m/s"""
    yaw_rate_error: float
    """The same of the yaw rate, rad/s"""
    falls: float
    """Share of the episodes that end in a fall"""

    def __str__(self) -> str:
        return (
            f"seed {self.seed}, {self.seconds:5.1f} s, {self.timesteps:>9,} steps: {self.met:.0%} of the commands met, "
            f"errors {self.forward_velocity_error:.3f} m/s and {self.yaw_rate_error:.3f} rad/s, {self.falls:.1%} falls"
        )


def results_of(policy: Policy, seed: int, commands: CommandMap = COMMANDS) -> Point:
    """Return the results of a policy at the suite's commands."""
    found = run_command_map(commands, Candidate.of_policy(policy, "policy"))
    # There is no error where every robot falls at once.
    names = "met", "forward_velocity_error", "yaw_rate_error", "falls"
    means = {name: math.nan if (mean := found[name]["mean"]) is None else mean for name in names}
    return Point(seed=seed, seconds=policy.card["seconds"], timesteps=policy.card["timesteps"], **means)


def learning_curve(
    times: Sequence[float], settings: Mapping[str, Any], say: Say, commands: CommandMap = COMMANDS
) -> list[Point]:
    """Train for the last of `times`, increasing, s, and test a checkpoint at each of them.

    Args:
        times: wall clock of learning, s. A checkpoint is up to 5 % of the first time, and an update, later.
        settings: what a user would give of `TrainConfig`.
        say: called with each result in words.
        commands: commands to test at.
    """
    budget = {"seconds": times[-1], "checkpoint_seconds": _SHARE * times[0]}
    config = with_recipe({**settings, **budget}, MINI_QUADRUPED)
    points = []
    with tempfile.TemporaryDirectory() as runs:
        run, whole = train(config, Path(runs), "learning speed")
        if not whole:
            raise KeyboardInterrupt
        checkpoints = [load_policy(path) for path in (run / CHECKPOINTS).iterdir()]
        checkpoints.sort(key=lambda policy: policy.card["seconds"])
        checkpoints.append(load_policy(run))
        for time in times:
            policy = next(one for one in checkpoints if one.card["seconds"] >= time)
            points.append(results_of(policy, config.seed, commands))
            say(str(points[-1]))
    return points


def summary(curves: Sequence[Sequence[Point]]) -> str:
    """Return a Markdown table of curves with the same times: medians over the seeds, and each seed's commands met."""
    lines = ["| s | steps | commands met | each seed | error, m/s | rad/s | falls |", "|---|---|---|---|---|---|---|"]
    for points in zip(*curves, strict=True):
        rows = [asdict(point) for point in points]
        median = {name: float(np.median([row[name] for row in rows])) for name in rows[0]}
        each = ", ".join(f"{point.met:.0%}" for point in points)
        lines.append(
            f"| {median['seconds']:.0f} | {median['timesteps']:,.0f} | {median['met']:.0%} | {each} "
            f"| {median['forward_velocity_error']:.3f} | {median['yaw_rate_error']:.3f} | {median['falls']:.1%} |"
        )
    return "\n".join(lines)
