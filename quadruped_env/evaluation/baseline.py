"""Baseline: a scripted gait, measured over random starts. A trained policy has to beat it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.confidence import Estimate, bootstrap_mean, proportion
from quadruped_env.evaluation.measures import METRICS, measure
from quadruped_env.evaluation.recorded_episode import Recording, play, publish
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.gait import SinusoidalGait
from quadruped_env.policies import TrajectoryController
from quadruped_env.robot import MINI_QUADRUPED, Robot
from quadruped_env.simulation import Terrain, flat
from quadruped_env.task import TaskConfig
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.utils.progress import Progress, part_of
from quadruped_env.utils.text_table import text_table

SHOWN: Final = (
    "fall_rate",
    "forward_velocity",
    "yaw_rate",
    "lateral_velocity",
    "distance",
    "electrical_cost_of_transport",
    "mechanical_cost_of_transport",
    "electrical_power",
    "mechanical_power",
    "stride_frequency",
    "slip",
    "peak_torque",
    "peak_joint_speed",
)
"""Metrics of a gait that follows no velocity command."""


@dataclass(frozen=True)
class Baseline:
    """A scripted gait, measured and recorded."""

    preset: str
    gait: SinusoidalGait
    rate: float
    """Rate of the joint targets, Hz"""
    seeds: Sequence[int]
    commands: JointTrajectory
    """Joint targets that the gait's publisher sends"""
    recording: Recording
    """One robot that plays the joint targets, from a start without randomness"""
    metrics: dict[str, NDArray[np.float64]]
    """Metric (a name in `METRICS`) -> one number per episode from a random start"""

    def estimate(self, name: str) -> Estimate:
        """Return the mean over the episodes and its 95 % confidence interval, in the metric's unit."""
        values = self.metrics[name]
        return proportion(values) if name == "fall_rate" else bootstrap_mean(values)

    def table(self) -> str:
        """Return the metrics as a plain-text table."""
        robot = self.recording.robot
        rows = [("", "mean", "95 % interval", "limit")]
        for name in filter(self.metrics.__contains__, SHOWN):
            metric, estimate = METRICS[name], self.estimate(name)
            mean, low, high = (metric.show(value) for value in (estimate.mean, estimate.low, estimate.high))
            most = metric.limit_of(robot)
            limit = "" if most is None else f"{most:g} {metric.unit}"
            if most is not None and estimate.mean > most:
                limit += ", exceeded"
            interval = "" if low == "-" else f"{low} to {high} "
            rows.append((metric.label, mean, f"{interval}{metric.unit}", limit))
        violations = self.gait.violations()
        return "\n".join(
            [
                f"{self.preset}: {self.rate:g} commands per second for {self.commands.duration:g} s, "
                f"{len(self.seeds)} random starts on {self.recording.terrain.name}",
                text_table(rows),
                f"The joint targets {'exceed limits:' if violations else 'are within the limits.'}",
                *(f"  {violation}" for violation in violations),
                f"Recorded: {self.recording.outcome()}",
            ]
        )


def run_baseline(
    preset: str = "tuned",
    seconds: float = 10.0,
    rate: float = 50.0,
    episodes: int = 20,
    progress: Progress | None = None,
    robot: Robot = MINI_QUADRUPED,
    terrain: str | Terrain | None = None,
) -> Baseline:
    """Measure a preset over random starts, and record it once.

    The robot receives only the published joint targets and interpolates linearly between them. At the control rate of
    50 Hz that is the gait itself; at the 20 Hz of the ROS 2 tutorial its amplitude is slightly smaller.

    Args:
        preset: a name in `quadruped_env.gait.PRESETS`.
        seconds: length of every episode, s.
        rate: rate of the joint targets, Hz.
        episodes: number of random starts to measure.
        progress: called with the fraction done.
        robot: robot to measure.
        terrain: a terrain, or the name of a built-in one; None is level ground.

    Raises:
        QuadrupedError: if the preset or the terrain is unknown, or a number is out of range.
    """
    if episodes < 1:
        raise QuadrupedError(f"episodes: expected 1 or more; found {episodes}")
    gait = SinusoidalGait.preset(preset, robot)
    commands = publish(gait, seconds, rate)
    seeds = range(FIRST_SEED, FIRST_SEED + episodes)
    controller = TrajectoryController(commands, preset)
    config = TaskConfig().for_robot(robot).on_terrain(terrain or flat)
    rollout = roll_out(controller, [(0.0, 0.0)], seeds, seconds, config, part_of(progress, 0.0, 0.5), physics=True)
    recording = play(commands, preset, progress=part_of(progress, 0.5, 1.0), robot=robot, terrain=terrain)
    return Baseline(preset, gait, rate, seeds, commands, recording, measure(rollout))
