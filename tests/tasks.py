"""Tasks, environments and random readings that the tests of the task share."""

import dataclasses
import math

import gymnasium
import numpy as np

from quadruped_env.envs import ENV_ID
from quadruped_env.readings import Readings
from quadruped_env.robot import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, load_model
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import (
    OBSERVATION_LAYOUT,
    CommandConfig,
    RandomizationConfig,
    Task,
    TaskConfig,
    TerminationConfig,
    rewards,
)

NEVER_FALLS = TerminationConfig(max_tilt=math.pi, max_trunk_force=1e9)
# Long enough that nothing is drawn anew within a test.
ONE_COMMAND = CommandConfig(resample_interval=(1e3, 1e3))
STILL_START = RandomizationConfig(
    start_joint_position=0.0, start_joint_velocity=0.0, start_base_velocity=0.0, start_tilt=0.0
)


def make_task(rows=3, max_episode_steps=None, fixed_command=None, **config):
    """A task on the batch, reset in every row."""
    task_config = TaskConfig(**config)
    simulation = BatchSimulation(load_model(task_config.physics_timestep), rows, 1)
    task = Task(simulation, task_config, max_episode_steps)
    task.reset(np.arange(rows), list(range(rows)), fixed_command)
    return task


def make_env(fixed_command=None, **config):
    """The single environment, whose MuJoCo data is open, reset."""
    env = gymnasium.make(ENV_ID, config=TaskConfig(**config), disable_env_checker=True).unwrapped
    env.reset(seed=0, options=None if fixed_command is None else {"command": fixed_command})
    return env


def column(name, observation):
    """The columns of one field of the layout."""
    start = 0
    for field in OBSERVATION_LAYOUT:
        if field.name == name:
            return observation[..., start : start + field.width]
        start += field.width
    raise AssertionError(name)


def random_state(rng, rows):
    widths = {
        "orientation": (4,),
        "foot_force": (4,),
        "trunk_force": (5,),
        "foot_position": (4, 3),
        "foot_velocity": (4, 3),
        "foot_angular_velocity": (4, 3),
    }
    values = {}
    for field in dataclasses.fields(Readings):
        width = (8,) if field.name.startswith("joint") else widths.get(field.name, (3,))
        values[field.name] = rng.standard_normal((rows, *width))
    # Around their thresholds.
    values["foot_force"] = rng.uniform(0.0, 2.0, (rows, 4))
    values["trunk_force"] = rng.uniform(0.0, 1.2, (rows, 5))
    values["foot_position"][..., 2] = rng.uniform(0.0, 0.06, (rows, 4))
    values["base_position"][:, 2] = rng.uniform(0.1, 0.2, rows)
    values["joint_position"] = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH, (rows, 8))
    values["up_b"] /= np.linalg.norm(values["up_b"], axis=1, keepdims=True)
    return Readings(**values)


def random_memory(rng, rows):
    command = rng.uniform(-0.5, 0.5, (rows, 2))
    command[::5] = 0.0
    scale, whole = rewards.progress_scale(command)
    return rewards.Memory(
        action=rng.uniform(-1, 1, (rows, 8)),
        last_action=rng.uniform(-1, 1, (rows, 8)),
        joint_offset=rng.standard_normal((rows, 8)),
        command=command,
        progress_scale=scale,
        progress_whole=whole,
        velocity=rng.standard_normal((rows, 2)) * 0.3,
        smooth_velocity=rng.standard_normal((rows, 2)) * 0.3,
        moving=(command != 0).any(axis=1) * 1.0,
        clock_sine=np.sin(rng.uniform(0, math.tau, (rows, 4))),
        fallen=(rng.random(rows) < 0.3) * 1.0,
    )


def convert(batch, function):
    """A Readings or Memory with a function applied to every array."""
    return type(batch)(**{f.name: function(getattr(batch, f.name)) for f in dataclasses.fields(batch)})
