"""Tasks, environments and random readings that the tests of the task share."""

import dataclasses
import math

import gymnasium
import numpy as np
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW

from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.envs import ENV_ID
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.readings import Readings
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import CommandConfig, RandomizationConfig, Task, TaskConfig, TaskContext, TerminationConfig
from quadruped_env.task.reward_function import RewardFunction
from quadruped_env.task.rewards import REWARDS

LAYOUT = ObservationLayout(MINI_QUADRUPED)
FRAME_WIDTH = LAYOUT.width
"""Width of the observation of one step."""
OBSERVATION_WIDTH = TaskConfig().observation_history * FRAME_WIDTH
"""Width of the default task's observation."""
NOISE = np.concatenate([np.full(field.width(MINI_QUADRUPED), field.noise) for field in LAYOUT.fields])
"""Amplitude of the noise per column of the observation."""
ACTION_WIDTH = MINI_QUADRUPED.num_joints

NEVER_FALLS = TerminationConfig(max_tilt=math.pi, max_trunk_force=1e9)
# Long enough that nothing is drawn again within a test.
ONE_COMMAND = CommandConfig(resample_interval=(1e3, 1e3))
STILL_START = RandomizationConfig(
    start_joint_position=0.0, start_joint_velocity=0.0, start_base_velocity=0.0, start_base_rotation=0.0, start_tilt=0.0
)


def make_task(rows=3, max_episode_steps=None, fixed_command=None, **config):
    """A task on the batch simulation, with every env reset."""
    task_config = TaskConfig(**config)
    simulation = BatchSimulation(task_config.compiled_model(), rows, 1)
    task = Task(simulation, task_config, max_episode_steps)
    task.reset(np.arange(rows), list(range(rows)), fixed_command)
    return task


def make_env(fixed_command=None, **config):
    """The single environment after a reset, unwrapped for access to its MuJoCo data."""
    env = gymnasium.make(ENV_ID, config=TaskConfig(**config), disable_env_checker=True).unwrapped
    env.reset(seed=0, options=None if fixed_command is None else {"command": fixed_command})
    return env


def column(name, observation):
    """The columns of one field of the layout."""
    return observation[..., LAYOUT.slices[name]]


def random_readings(rng, num_envs):
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
        values[field.name] = rng.standard_normal((num_envs, *width))
    # Around their thresholds.
    values["foot_force"] = rng.uniform(0.0, 2.0, (num_envs, 4))
    values["trunk_force"] = rng.uniform(0.0, 1.2, (num_envs, 5))
    values["foot_position"][..., 2] = rng.uniform(0.0, 0.06, (num_envs, 4))
    values["base_position"][:, 2] = rng.uniform(0.1, 0.2, num_envs)
    values["joint_position"] = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH, (num_envs, 8))
    values["up_b"] /= np.linalg.norm(values["up_b"], axis=1, keepdims=True)
    return Readings(**values)


class Terms:
    """The built-in reward terms, unweighted, on readings and commands that the test sets."""

    def __init__(self, readings, config=None):
        self.config = config or TaskConfig()
        self.control = ControlInterface(MINI_QUADRUPED, self.config.control, len(readings.up_b))
        reward = self.config.reward
        self.context = TaskContext(readings, self.control, reward.velocity_time_constant, reward.contact_threshold)
        weights = dict.fromkeys(reward.weights, 1.0 / self.context.timestep)
        self.function = RewardFunction(REWARDS, reward.replace(weights=weights), self.context)

    def set_command(self, command):
        """Commands (N, 2) that hold at once."""
        self.control.reset(np.arange(len(command)), self.control.phase.copy(), command)

    def randomize(self, rng):
        """Set random actions, commands, velocities, clocks and falls."""
        n = self.control.num_envs
        command = rng.uniform(-0.5, 0.5, (n, 2))
        command[::5] = 0.0
        self.set_command(command)
        self.control.action[:], self.control.previous_action[:] = rng.uniform(-1, 1, (2, n, ACTION_WIDTH))
        self.control.phase[:] = rng.uniform(0, math.tau, n)
        self.context.velocity[:], self.context.smooth_velocity[:] = 0.3 * rng.standard_normal((2, n, 2))
        self.context.tracking_error[:] = self.context.smooth_velocity - command
        self.context.fallen[:] = rng.random(n) < 0.3
        self.context._airborne[:] = rng.random((n, 4)) < 0.5
        return self

    def values(self):
        """Name -> (N,), with the readings of the only physics step."""
        self.context.read()
        self.context._contacts()
        return dict(zip(self.function.names, self.function(self.context), strict=True))
