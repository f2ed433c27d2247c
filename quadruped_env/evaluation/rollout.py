"""Run a controller on fixed commands, many episodes at once, and keep what the metrics read."""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, Final, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.policies import Controller
from quadruped_env.progress import Progress
from quadruped_env.robot import FOOT_RADIUS, JOINT_NAMES, LEG_NAMES, load_model
from quadruped_env.simulation import BatchSimulation, State
from quadruped_env.task import Task, TaskConfig
from quadruped_env.task.rewards import foot_slip

DEFAULT_SECONDS: Final = 20.0
FIRST_SEED: Final = 1_000_000
"""Far from the small seeds that people train with: no episode of the evaluation was an episode of the training."""


@dataclass(frozen=True)
class Rollout:
    """What a controller did: N episodes of T control steps, with a command each.

    Sample t is the reading after control step t + 1. Readings are float32. After a row's fall they go on, but mean
    nothing: `valid` says which count.
    """

    controller: str
    timestep: float
    """Time between samples, s"""
    command: NDArray[np.float64]
    """Forward velocity in m/s and yaw rate in rad/s, (N, 2)"""
    seeds: NDArray[np.int64]
    """(N,)"""
    valid: NDArray[np.bool_]
    """Whether the row is still on its feet, (T, N); once False it stays so"""
    base_position: NDArray[np.float32]
    """m, world frame (T, N, 3)"""
    orientation: NDArray[np.float32]
    """Quaternion wxyz of the base (T, N, 4)"""
    linear_velocity_b: NDArray[np.float32]
    """m/s (T, N, 3)"""
    yaw_rate: NDArray[np.float32]
    """Angular velocity about the base's own vertical axis, rad/s (T, N)"""
    joint_position: NDArray[np.float32]
    """rad (T, N, 8)"""
    joint_velocity: NDArray[np.float32]
    """rad/s (T, N, 8)"""
    joint_torque: NDArray[np.float32]
    """N m (T, N, 8), of the control step's last physics substep"""
    contact: NDArray[np.bool_]
    """Whether a foot is on the ground (T, N, 4)"""
    slip_speed: NDArray[np.float32]
    """Sliding speed of the lowest point of each foot on the ground, m/s (T, N, 4); 0 for a foot in the air"""
    foot_height: NDArray[np.float32]
    """Height of each sole's lowest point over flat ground, m (T, N, 4); a sole that is pressed in is under 0"""
    reward_terms: NDArray[np.float32]
    """Weighted terms of the task's reward (T, N, K)"""
    term_names: tuple[str, ...]
    """Of the K terms"""

    @property
    def fallen(self) -> NDArray[np.bool_]:
        """Whether the episode ended in a fall or in a simulation that diverged, (N,)."""
        return ~self.valid[-1]

    @property
    def seconds(self) -> float:
        """Length of an episode that does not end in a fall, s."""
        return len(self.valid) * self.timestep

    def select(self, rows: Any) -> Self:
        """The rollout of some rows only, by index or mask (N,)."""
        over_time = {
            f.name: getattr(self, f.name)[:, rows]
            for f in fields(self)
            if f.name not in ("controller", "timestep", "command", "seeds", "term_names")
        }
        return replace(self, command=self.command[rows], seeds=self.seeds[rows], **over_time)


def grid(commands: ArrayLike, seeds: Sequence[int]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Every command (K, 2) with each of S seeds: commands (K * S, 2) and seeds (K * S,), command by command."""
    commands = np.asarray(commands, dtype=np.float64)
    return np.repeat(commands, len(seeds), axis=0), np.tile(np.asarray(seeds, dtype=np.int64), len(commands))


def roll_out(
    controller: Controller,
    commands: ArrayLike,
    seeds: Sequence[int],
    seconds: float = DEFAULT_SECONDS,
    config: TaskConfig | None = None,
    progress: Progress | None = None,
) -> Rollout:
    """Run a controller on every command with every seed; episodes end at a fall and are not started again.

    A seed gives the same start (attitude, joint positions, velocities) whatever the command and the controller, so
    that differences between controllers are paired.

    Args:
        controller: what to run.
        commands: forward velocity in m/s and yaw rate in rad/s, (K, 2).
        seeds: one episode a command and seed.
        seconds: length of an episode.
        config: the task; the action mode is the controller's own. None takes the defaults.
        progress: is told how far it is.

    Returns:
        A rollout with K * S rows, ordered as `grid` orders them.

    Raises:
        QuadrupedError: if a command is outside the task's ranges, or there is no command, seed or time.
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
    rows = len(command)
    task = Task(BatchSimulation(load_model(config.physics_timestep, config.motor), rows), config)
    for start in range(0, rows, len(seeds)):
        block = np.arange(start, start + len(seeds))
        task.reset(block, seeds=[int(s) for s in seed[block]], command=command[start])

    record = _empty_record(steps, rows, len(task.term_names))
    alive = np.ones(rows, dtype=np.bool_)
    observation = task.observe()
    for t in range(steps):
        transition = controller.step(task, observation)
        observation = transition.observation
        alive &= ~transition.terminated
        record["valid"][t] = alive
        record["reward_terms"][t] = transition.terms
        _write(record, t, task.simulation.state, config.reward.contact_threshold)
        if progress is not None:
            progress((t + 1) / steps)
        if not alive.any():
            break
    return Rollout(controller.name, config.control_timestep, command, seed, term_names=task.term_names, **record)


def _empty_record(steps: int, rows: int, terms: int) -> dict[str, NDArray[Any]]:
    joints, feet = len(JOINT_NAMES), len(LEG_NAMES)
    shapes = {
        "base_position": (3,),
        "orientation": (4,),
        "linear_velocity_b": (3,),
        "yaw_rate": (),
        "joint_position": (joints,),
        "joint_velocity": (joints,),
        "joint_torque": (joints,),
        "slip_speed": (feet,),
        "foot_height": (feet,),
        "reward_terms": (terms,),
    }
    record: dict[str, NDArray[Any]] = {
        name: np.zeros((steps, rows, *tail), np.float32) for name, tail in shapes.items()
    }
    record["valid"] = np.zeros((steps, rows), np.bool_)
    record["contact"] = np.zeros((steps, rows, feet), np.bool_)
    return record


def _write(record: dict[str, NDArray[Any]], t: int, state: State, contact_threshold: float) -> None:
    for name in (
        "base_position",
        "orientation",
        "linear_velocity_b",
        "joint_position",
        "joint_velocity",
        "joint_torque",
    ):
        record[name][t] = getattr(state, name)
    record["foot_height"][t] = state.foot_position[..., 2] - FOOT_RADIUS
    record["yaw_rate"][t] = state.angular_velocity_b[:, 2]
    contact = state.foot_force > contact_threshold
    record["contact"][t] = contact
    # The reward's term sums over a row's feet; here every foot is a row of its own.
    squared = foot_slip(
        contact[..., None], state.foot_velocity[..., None, :], state.foot_angular_velocity[..., None, :]
    )
    record["slip_speed"][t] = np.sqrt(squared)
