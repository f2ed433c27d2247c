"""Policies and commands of small comparisons."""

import itertools
import math

import numpy as np

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.policies import Policy
from quadruped_env.task import ActionConfig, TaskConfig

TINY = ((0.2, 0.0), (0.4, 0.0), (0.0, 0.0), (-0.2, 0.0), (0.0, 0.5))
"""Velocity commands, m/s and rad/s."""


def random_policy(mode, robot=None, **config):
    """A policy with random weights, for a task with this action mode and config, and by default the built-in robot."""
    rng = np.random.default_rng(0)
    task = TaskConfig(action=ActionConfig(mode=mode), **config)
    if robot is not None:
        task = task.for_robot(robot)
    widths = (ObservationLayout(task.robot).width * task.observation_history, 16, task.robot.num_joints)
    weights = tuple(
        (0.3 * rng.normal(size=shape) / math.sqrt(shape[0])).astype(np.float32) for shape in itertools.pairwise(widths)
    )
    biases = tuple(np.zeros(width, np.float32) for width in widths[1:])
    card = {"command": "python train/ppo.py", "seed": 0, "best return": math.nan}
    return Policy.for_task(weights, biases, "tanh", task, card)


def write_comparison(policies, comparison, output, ranked=None, gains=None):
    """Page and numbers of a comparison, as the program writes them."""
    from quadruped_env.report.pages import report

    document = report.write_comparison_numbers(policies, comparison, output, "", ranked, gains)
    return report.write_comparison(policies, comparison, output, document, ranked, gains), output / "metrics.json"


def write_evaluation(evaluated, comparison, command="", suite=None, gain=None, with_video=False):
    """Report and numbers of an evaluation, as the program writes them, and messages about what is missing."""
    from quadruped_env.report.pages import report

    document = report.write_numbers(evaluated, comparison, command, suite, gain)
    page, missing = report.write_report(evaluated, comparison, document, with_video, suite=suite, gain=gain)
    return page, evaluated.output / "metrics.json", missing
