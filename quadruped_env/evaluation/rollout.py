"""Run a controller on fixed commands, many episodes at once, and record the readings that the metrics need."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.trace import CommandedTrace, Flag, PerLeg, PerTerm, Recorder
from quadruped_env.policies import Controller
from quadruped_env.robot.motors import MotorConfig
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.simulation import BatchSimulation, Simulation
from quadruped_env.task import Task, TaskConfig, Transition
from quadruped_env.task.quantities import sliding_squared
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.seeds import EVALUATION_SEEDS

DEFAULT_SECONDS: Final = 20.0
FIRST_SEED: Final = EVALUATION_SEEDS.start
"""First seed of an evaluation: no evaluation episode was a training episode."""

BeforeStep = Callable[[Task, int], None]
"""Function (task, number of control steps done) that changes commands or pushes robots before a control step."""

Engine = Callable[[TaskConfig, int], Simulation]
"""Makes N simulated robots for a task."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Rollout(CommandedTrace):
    """N episodes of T control steps of one controller, each with its command.

    Sample t is the reading after control step t + 1. Readings are float32. Readings after a fall are meaningless;
    `valid` masks them.
    """

    controller: str
    motors: MotorConfig
    """Motors that moved the robot"""
    seeds: NDArray[np.int64]
    """Seed of each episode (N,)"""
    valid: Flag
    """True until the robot falls, (T, N)"""
    slip_speed: PerLeg
    """Sliding speed of the lowest point of each foot on the ground, m/s (T, N, L); 0 for a foot in the air"""
    foot_height: PerLeg
    """Height of each sole's lowest point over the ground below it, m (T, N, L); negative where it penetrates it"""
    reward_terms: PerTerm
    """Weighted terms of the task's reward (T, N, K)"""
    term_names: tuple[str, ...]
    """Names of the K reward terms"""

    @property
    def fallen(self) -> NDArray[np.bool_]:
        """True for episodes that ended in a fall or diverged, (N,)."""
        return ~self.valid[-1]

    def select(self, envs: int | Sequence[int] | NDArray[Any]) -> Self:
        """Copy of some of the episodes, by indices or mask (N,); an index alone is `env`."""
        return replace(super().select(envs), seeds=self.seeds[envs])


def grid(commands: ArrayLike, seeds: Sequence[int]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Every command (K, 2) with each of S seeds: commands (K * S, 2) and seeds (K * S,), grouped by command."""
    commands = np.asarray(commands, dtype=np.float64)
    return np.repeat(commands, len(seeds), axis=0), np.tile(np.asarray(seeds, dtype=np.int64), len(commands))


def in_mujoco(config: TaskConfig, num_envs: int) -> Simulation:
    """N robots of a task in MuJoCo, with the task's own model."""
    return BatchSimulation(config.compiled_model(), num_envs, robot=config.robot)


def run_episodes(
    controller: Controller,
    command: NDArray[np.float64],
    seeds: NDArray[np.int64],
    steps: int,
    config: TaskConfig,
    before_step: BeforeStep | None = None,
    tiles: NDArray[np.intp] | None = None,
    engine: Engine = in_mujoco,
) -> Iterator[tuple[Task, Transition]]:
    """Run N episodes at the same time, without restarting any, and yield the task after every control step.

    Commands (N, 2) are in m/s and rad/s. The config has the controller's action mode. `tiles` are kind and level of the
    tile on which each episode starts (N, 2), as in `Task.reset`.
    """
    task = Task(engine(config, len(command)), config)
    # Consecutive episodes with the same command are reset at once.
    changes = np.flatnonzero((np.diff(command, axis=0) != 0.0).any(axis=1)) + 1
    for block in np.split(np.arange(len(command)), changes):
        task.reset(
            block,
            seeds=[int(seed) for seed in seeds[block]],
            command=command[block[0]],
            tiles=None if tiles is None else tiles[block],
        )
    observation = task.observe()
    for step in range(steps):
        if before_step is not None:
            before_step(task, step)
        transition = task.act(controller, observation)
        observation = transition.observation
        yield task, transition


def roll_out(
    controller: Controller,
    commands: ArrayLike,
    seeds: Sequence[int],
    seconds: float = DEFAULT_SECONDS,
    config: TaskConfig | None = None,
    progress: Progress | None = None,
    before_step: BeforeStep | None = None,
    engine: Engine = in_mujoco,
) -> Rollout:
    """Run a controller on every command with every seed; an episode ends at a fall and is not restarted.

    A seed gives the same start (attitude, joint positions, velocities) for every command and controller, so that
    differences between controllers are paired.

    Args:
        controller: controller to run.
        commands: forward velocity in m/s and yaw rate in rad/s, (K, 2).
        seeds: one episode per command and seed.
        seconds: length of an episode, s.
        config: task configuration, with its robot; the action mode is the controller's. None takes the defaults.
        progress: called with the fraction done.
        before_step: called before every control step; it may change commands or push robots.
        engine: simulates the robots.

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
    command, seed = grid(commands, seeds)
    if command.ndim != 2 or command.shape[1] != 2 or not len(command):
        raise QuadrupedError(f"roll_out: commands must have shape (K, 2); found {np.shape(commands)}")
    robot = config.robot
    recorder = Recorder(Rollout, robot, steps, np.float32)
    alive = np.ones(len(command), dtype=np.bool_)
    commanded = np.broadcast_to(command, (steps, *command.shape))
    if before_step is not None:
        commanded = commanded.copy()
    term_names: tuple[str, ...] = ()
    for task, transition in run_episodes(controller, command, seed, steps, config, before_step, engine=engine):
        if before_step is not None:
            commanded[recorder.written :] = task.command
        alive &= ~transition.terminated
        readings, contact = task.simulation.readings, task.context.foot_contact
        slip = sliding_squared(readings.foot_velocity, readings.foot_angular_velocity, robot.foot_radius)
        recorder.write(
            readings,
            valid=alive,
            contact=contact,
            slip_speed=np.sqrt(slip * contact),
            foot_height=task.context.sole_height,
            reward_terms=transition.terms,
        )
        term_names = task.term_names
        if progress is not None:
            progress(recorder.written / steps)
        if not alive.any():
            break
    return recorder.trace(
        controller=controller.name,
        motors=config.motor,
        timestep=config.control_timestep,
        command=commanded,
        seeds=seed,
        term_names=term_names,
        terrain=config.ground,
        first_stamp=round(config.control_timestep * NS_PER_SECOND),
    )
