"""Run a controller, many episodes at once, and record the readings that the measures need."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Final, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.trace import Array, CommandedTrace, Recorder
from quadruped_env.policies import Controller
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.simulation import BatchSimulation, Simulation
from quadruped_env.task import Task, TaskConfig
from quadruped_env.task.quantities import electrical_power, mean_over_steps, mechanical_power, sliding_squared
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.seeds import EVALUATION_SEEDS

DEFAULT_SECONDS: Final = 20.0
FIRST_SEED: Final = EVALUATION_SEEDS.start
"""First seed of an evaluation: no evaluation episode was a training episode."""

BeforeStep = Callable[[Task, int], None]
"""Function (task, number of control steps done) that changes commands or pushes robots before a control step."""

Engine = Callable[[TaskConfig, int], Simulation]
"""Makes N simulated robots for a task."""


class PhysicsSamples(NamedTuple):
    """K physics steps of N robots with L feet and J joints: the same number of steps for each control step."""

    height: NDArray[Any]
    """Height of each sole's lowest point over the ground below it, m (K, N, L); negative where it penetrates it."""
    rise: NDArray[Any]
    """Upward velocity of each sole, m/s (K, N, L)."""
    force: NDArray[Any]
    """Normal force on each foot, N (K, N, L)."""
    slip: NDArray[Any]
    """Horizontal velocity of each sole's lowest point, m/s (K, N, L)."""
    torque: NDArray[Any]
    """Motor torques, N m (K, N, J)."""

    @classmethod
    def of(cls, task: Task) -> Self:
        """Read the physics steps of a task's latest control step."""
        now, radius = task.context.substeps, task.config.robot.foot_radius
        return cls(
            now.foot_position[..., 2] - radius - task.context.ground_height(now.foot_position),
            now.foot_velocity[..., 2],
            now.foot_force,
            np.sqrt(sliding_squared(now.foot_velocity, now.foot_angular_velocity, radius)),
            now.joint_torque,
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class Rollout(CommandedTrace):
    """N episodes of T control steps of one controller, each with its command.

    Sample t is the reading after control step t + 1, and the command that was in force during it. Readings are float32.
    Readings after a fall are meaningless, unless the robot began again; `valid` masks them.
    """

    controller: str
    seeds: tuple[int, ...]
    """Seed of each of the N episodes"""
    fell: NDArray[np.bool_]
    """True where the robot fell in the control step, (T, N)"""
    electrical_power: Array
    """Mechanical power of the motors and heat in their windings, mean over the control step, W (T, N)"""
    mechanical_power: Array
    """Positive mechanical power of the motors, mean over the control step, W (T, N)"""
    base_height: Array
    """Height of the base's centre over the ground below it, m (T, N)"""
    reward_terms: Array
    """Weighted terms of the task's reward (T, N, K)"""
    term_names: tuple[str, ...]
    """Names of the K reward terms"""
    physics: PhysicsSamples | None = None
    """Every physics step; None: not recorded"""

    @cached_property
    def valid(self) -> NDArray[np.bool_]:
        """True until the robot falls, (T, N), or (T,) for one episode."""
        return ~np.logical_or.accumulate(self.fell, axis=0)

    @property
    def fallen(self) -> NDArray[np.bool_]:
        """True for episodes in which the robot fell or diverged, (N,)."""
        return ~self.valid[-1]

    def select(self, envs: int | Sequence[int] | NDArray[Any]) -> Self:
        """Copy some of the episodes, by indices or mask (N,); an index alone is `env`."""
        physics = None if self.physics is None else PhysicsSamples(*(values[:, envs] for values in self.physics))
        seeds = np.atleast_1d(np.array(self.seeds)[envs]).tolist()
        return replace(super().select(envs), seeds=tuple(seeds), physics=physics)


def grid(commands: ArrayLike, seeds: Sequence[int]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Combine every command (K, V) with each of S seeds: commands (K * S, V) and seeds (K * S,), grouped by command."""
    commands = np.asarray(commands, dtype=np.float64)
    return np.repeat(commands, len(seeds), axis=0), np.tile(np.asarray(seeds, dtype=np.int64), len(commands))


def in_mujoco(config: TaskConfig, num_envs: int) -> Simulation:
    """Simulate N robots of a task in MuJoCo, with the task's own model."""
    return BatchSimulation(config.compiled_model(), num_envs, robot=config.robot)


def roll_out(
    controller: Controller,
    commands: ArrayLike | None,
    seeds: Sequence[int],
    seconds: float = DEFAULT_SECONDS,
    config: TaskConfig | None = None,
    progress: Progress | None = None,
    before_step: BeforeStep | None = None,
    engine: Engine = in_mujoco,
    tiles: NDArray[np.intp] | None = None,
    physics: bool = False,
    restart: bool = False,
) -> Rollout:
    """Run a controller on every command with every seed.

    A seed gives the same start (attitude, joint positions, velocities) for every command and controller, so that
    differences between controllers are paired.

    Args:
        controller: controller to run.
        commands: forward velocity in m/s and yaw rate in rad/s, (K, 2), for robots that move sideways also the lateral
            velocity in m/s, (K, 3); None: one episode per seed, in which the task draws the commands.
        seeds: one episode per command and seed.
        seconds: length of an episode, s.
        config: task configuration, with its robot; the action mode is the controller's. None takes the defaults.
        progress: called with the fraction done.
        before_step: called before every control step; it may change commands or push robots.
        engine: simulates the robots.
        tiles: kind and level of the tile on which each episode starts (K * S, 2), as in `Task.reset`.
        physics: record every physics step, which the measures of the gait need.
        restart: begin a new episode after a fall, as in training. Otherwise the episode ends.

    Returns:
        A rollout with K * S episodes, in the order of `grid`.

    Raises:
        QuadrupedError: if a command is outside the task's ranges, there is no command or seed, or `seconds` is shorter
            than a control step.
    """
    config = task_config(controller.action_mode, config)
    steps = round(seconds / config.control_timestep)
    if steps < 1 or len(seeds) < 1:
        raise QuadrupedError(
            f"roll_out: expected at least one seed and {config.control_timestep:g} s; "
            f"found {len(seeds)} seeds and {seconds:g} s"
        )
    robot, velocities = config.robot, config.control.num_velocities
    command, seed = None, np.array(seeds, np.int64)
    if commands is not None:
        command, seed = grid(commands, seeds)
        if command.ndim != 2 or not 2 <= command.shape[1] <= velocities or not len(command):
            raise QuadrupedError(f"roll_out: commands must have shape (K, {velocities}); found {np.shape(commands)}")
    coefficient = config.motor.joule_coefficients(robot.joint_kinds)
    task = Task(engine(config, len(seed)), config)
    _reset(task, command, seed, tiles)
    observation, term_names = task.observe(), task.term_names
    recorder = Recorder(robot, steps, np.float32)
    ended = np.zeros(len(seed), dtype=np.bool_)
    fixed = command is not None and before_step is None
    commanded = np.broadcast_to(task.command, (steps, *task.command.shape))
    commanded = commanded if fixed else commanded.copy()
    samples: PhysicsSamples | None = None
    for step in range(steps):
        if before_step is not None:
            before_step(task, step)
        if not fixed:
            commanded[step:] = task.command
        transition = task.act(controller, observation)
        observation, substeps = transition.observation, task.context.substeps
        torque, speed = substeps.joint_torque, substeps.joint_velocity
        if physics:
            latest = PhysicsSamples.of(task)
            count = len(latest.force)
            samples = samples or PhysicsSamples(*(np.zeros((steps * count, *v.shape[1:]), np.float32) for v in latest))
            for array, values in zip(samples, latest, strict=True):
                array[step * count :][:count] = values
        recorder.write(
            task.simulation.readings,
            fell=transition.terminated & ~ended,
            contact=task.context.foot_contact,
            electrical_power=mean_over_steps(electrical_power(torque, speed, coefficient)),
            mechanical_power=mean_over_steps(mechanical_power(torque, speed)),
            base_height=task.context.base_height,
            reward_terms=transition.terms,
        )
        if progress is not None:
            progress((step + 1) / steps)
        if restart and transition.terminated.any():
            task.reset(np.flatnonzero(transition.terminated))
            observation = task.observe()
        ended |= transition.terminated & (not restart)
        if ended.all():
            break
    return Rollout(
        robot=robot,
        **recorder.arrays(),
        controller=controller.name,
        timestep=config.control_timestep,
        command=commanded,
        seeds=tuple(seed.tolist()),
        term_names=term_names,
        terrain=config.ground,
        first_stamp=round(config.control_timestep * NS_PER_SECOND),
        physics=samples,
    )


def _reset(
    task: Task, command: NDArray[np.float64] | None, seed: NDArray[np.int64], tiles: NDArray[np.intp] | None
) -> None:
    """Begin all episodes (N,), consecutive ones with the same command (N, V) at once."""
    new = np.zeros(len(seed) - 1, np.bool_) if command is None else (np.diff(command, axis=0) != 0.0).any(axis=1)
    for block in np.split(np.arange(len(seed)), np.flatnonzero(new) + 1):
        task.reset(
            block,
            seeds=seed[block].tolist(),
            command=None if command is None else command[block[0]],
            tiles=None if tiles is None else tiles[block],
        )
