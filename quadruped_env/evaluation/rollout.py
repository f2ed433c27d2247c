"""Run a controller on fixed commands, many episodes at once, and record the readings that the metrics need."""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, Final, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.policies import Controller
from quadruped_env.progress import Progress
from quadruped_env.robot import Robot
from quadruped_env.simulation import BatchSimulation, Terrain, build_model, flat
from quadruped_env.task import Task, TaskConfig
from quadruped_env.task.quantities import sliding_squared

DEFAULT_SECONDS: Final = 20.0
FIRST_SEED: Final = 1_000_000
"""First seed of an evaluation, far from the small seeds of trainings: no evaluation episode was a training episode."""


@dataclass(frozen=True)
class Rollout:
    """N episodes of T control steps of one controller on a robot with J joints and L legs, each with its command.

    Sample t is the reading after control step t + 1. Readings are float32. Readings after a fall are meaningless;
    `valid` masks them.
    """

    controller: str
    robot: Robot
    timestep: float
    """Time between samples, s"""
    command: NDArray[np.float64]
    """Forward velocity in m/s and yaw rate in rad/s, (N, 2)"""
    seeds: NDArray[np.int64]
    """Seed of each episode (N,)"""
    valid: NDArray[np.bool_]
    """True until the robot falls, (T, N)"""
    base_position: NDArray[np.float32]
    """Position of the base in the world, m (T, N, 3)"""
    orientation: NDArray[np.float32]
    """Quaternion wxyz of the base (T, N, 4)"""
    linear_velocity_b: NDArray[np.float32]
    """Linear velocity of the base in its own frame, m/s (T, N, 3)"""
    yaw_rate: NDArray[np.float32]
    """Angular velocity about the base's own vertical axis, rad/s (T, N)"""
    joint_position: NDArray[np.float32]
    """Joint positions, rad (T, N, J)"""
    joint_velocity: NDArray[np.float32]
    """Joint velocities, rad/s (T, N, J)"""
    joint_torque: NDArray[np.float32]
    """Motor torques in the last physics step of each control step, N m (T, N, J)"""
    contact: NDArray[np.bool_]
    """True for each foot on the ground (T, N, L)"""
    slip_speed: NDArray[np.float32]
    """Sliding speed of the lowest point of each foot on the ground, m/s (T, N, L); 0 for a foot in the air"""
    foot_height: NDArray[np.float32]
    """Height of each sole's lowest point over the ground below it, m (T, N, L); negative where it penetrates it"""
    reward_terms: NDArray[np.float32]
    """Weighted terms of the task's reward (T, N, K)"""
    term_names: tuple[str, ...]
    """Names of the K reward terms"""
    terrain: Terrain = flat
    """Ground of the episodes"""

    @property
    def fallen(self) -> NDArray[np.bool_]:
        """True for episodes that ended in a fall or diverged, (N,)."""
        return ~self.valid[-1]

    @property
    def seconds(self) -> float:
        """Length of an episode that does not end in a fall, s."""
        return len(self.valid) * self.timestep

    def select(self, rows: Any) -> Self:
        """The rollout with some of its episodes, by index or mask (N,)."""
        over_time = {
            f.name: getattr(self, f.name)[:, rows]
            for f in fields(self)
            if f.name not in ("controller", "robot", "timestep", "command", "seeds", "term_names", "terrain")
        }
        return replace(self, command=self.command[rows], seeds=self.seeds[rows], **over_time)


def grid(commands: ArrayLike, seeds: Sequence[int]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Every command (K, 2) with each of S seeds: commands (K * S, 2) and seeds (K * S,), grouped by command."""
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
    rows, robot = len(command), config.robot
    model = build_model(config.physics_timestep, config.motor, config.ground, robot)
    task = Task(BatchSimulation(model, rows, robot=robot), config)
    for start in range(0, rows, len(seeds)):
        block = np.arange(start, start + len(seeds))
        task.reset(block, seeds=[int(s) for s in seed[block]], command=command[start])

    record = _empty_record(robot, steps, rows, len(task.term_names))
    alive = np.ones(rows, dtype=np.bool_)
    observation = task.observe()
    for t in range(steps):
        transition = task.act(controller, observation)
        observation = transition.observation
        alive &= ~transition.terminated
        record["valid"][t] = alive
        record["reward_terms"][t] = transition.terms
        _write(record, t, task)
        if progress is not None:
            progress((t + 1) / steps)
        if not alive.any():
            break
    return Rollout(
        controller.name,
        robot,
        config.control_timestep,
        command,
        seed,
        term_names=task.term_names,
        terrain=config.ground,
        **record,
    )


def _empty_record(robot: Robot, steps: int, rows: int, terms: int) -> dict[str, NDArray[Any]]:
    joints, feet = robot.num_joints, robot.num_legs
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


def _write(record: dict[str, NDArray[Any]], t: int, task: Task) -> None:
    state = task.simulation.readings
    for name in (
        "base_position",
        "orientation",
        "linear_velocity_b",
        "joint_position",
        "joint_velocity",
        "joint_torque",
    ):
        record[name][t] = getattr(state, name)
    record["foot_height"][t] = task.context.sole_height
    record["yaw_rate"][t] = state.angular_velocity_b[:, 2]
    contact = state.foot_force > task.config.reward.contact_threshold
    record["contact"][t] = contact
    radius = task.control.robot.foot_radius
    squared = sliding_squared(state.foot_velocity, state.foot_angular_velocity, np.array([-radius, radius]))
    record["slip_speed"][t] = np.sqrt(squared * contact)
