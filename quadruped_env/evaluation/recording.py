"""One robot's joints over time: what a scripted gait asks for, and what a controller made of it.

Every recording begins alike: the robot at rest on its feet, facing along x, and nothing in it is random. A controller
begins in the stance, recorded joint positions in their own first row. So the motion is a function of the controller
alone, and a replay of the same joint targets repeats it to the last bit.
"""

import math
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import SinusoidalGait
from quadruped_env.policies import Controller, TrajectoryController
from quadruped_env.progress import Progress
from quadruped_env.robot import (
    JOINT_NAMES,
    JOINT_POSITION_HIGH,
    JOINT_POSITION_LOW,
    LEG_NAMES,
    STANCE,
    STANCE_HEIGHT,
    MotorConfig,
    load_model,
    resting_pose,
)
from quadruped_env.simulation import SingleSimulation
from quadruped_env.task import RandomizationConfig, Task, TaskConfig
from quadruped_env.timestamps import NS_PER_SECOND
from quadruped_env.trajectory import JointTrajectory

MAX_RATE: Final = 1000.0
"""Hz"""
MAX_SECONDS: Final = 6 * 3600.0
"""A longer recording is more likely a stamp from another clock (a first stamp of 0, say) than a walk."""

_ROW: Final = np.zeros(1, dtype=np.intp)
STILL: Final = RandomizationConfig(
    start_joint_position=0.0, start_joint_velocity=0.0, start_base_velocity=0.0, start_tilt=0.0
)
"""Nothing random"""


@dataclass(frozen=True)
class Recording:
    """What a robot did, from its start: K + 1 rows for K control steps.

    It goes on after a fall, but not after the simulation diverged.
    """

    controller: str
    joints: JointTrajectory
    """Measured positions, velocities and motor torques"""
    base_pose: NDArray[np.float64]
    """Position in m and quaternion wxyz of the base in the world (K + 1, 7)"""
    velocity: NDArray[np.float64]
    """Forward velocity in m/s and yaw rate in rad/s, in the body frame (K + 1, 2)"""
    contact: NDArray[np.bool_]
    """Whether each foot is on the ground (K + 1, 4)"""
    fell_at: float | None
    """s from the start, or None for a robot that stayed on its feet"""

    def outcome(self) -> str:
        """How it ended, in a sentence."""
        x, y = (self.base_pose[-1, :2] - self.base_pose[0, :2]).round(2)
        fate = "stayed on its feet" if self.fell_at is None else f"fell at {self.fell_at:.2f} s"
        return (
            f"In {self.joints.duration:g} s the robot {fate} and got {abs(x):.2f} m "
            f"{'ahead' if x >= 0 else 'back'} and {abs(y):.2f} m to the {'left' if y >= 0 else 'right'}."
        )


def publish(gait: SinusoidalGait, seconds: float, rate: float) -> JointTrajectory:
    """What a publisher of a gait sends: positions and velocities at t = 0, 1 / rate, ... up to `seconds`.

    Args:
        gait: what to publish.
        seconds: until when.
        rate: Hz.

    Raises:
        QuadrupedError: if the time or the rate makes no sense.
    """
    if not 0.0 < rate <= MAX_RATE:
        raise QuadrupedError(f"rate: expected over 0 and up to {MAX_RATE:g} Hz; found {rate:g}")
    if not 0.0 < seconds <= MAX_SECONDS:
        raise QuadrupedError(f"seconds: expected over 0 and up to {MAX_SECONDS:g} s; found {seconds:g}")
    # In this way 50 Hz gives the very times, and so the very positions, of a gait that runs on the task's clock.
    times = np.arange(math.floor(seconds * rate + 1e-6) + 1) * (1.0 / rate)
    return JointTrajectory(_stamps(times), JOINT_NAMES, gait.positions(times), gait.velocities(times))


def play(
    trajectory: JointTrajectory,
    name: str = "recording",
    progress: Progress | None = None,
    motors: MotorConfig | None = None,
) -> Recording:
    """Play joint positions through the motors, with gravity and ground, and record it.

    The robot starts in the first row's positions, on its feet; the recording's first stamp is the trajectory's.

    Args:
        trajectory: all eight joints; another that the robot does not have is left out.
        name: what reports call it.
        progress: is told how far it is.
        motors: other motors than the model file's.

    Raises:
        QuadrupedError: if a joint is unknown or missing, or the trajectory is too long.
    """
    if trajectory.duration > MAX_SECONDS:
        gap = int(np.argmax(np.diff(trajectory.stamps))) + 1
        raise QuadrupedError(
            f"{trajectory.source.name}: lasts {trajectory.duration:g} s, over {MAX_SECONDS:g} s; its longest gap, "
            f"{trajectory.times[gap] - trajectory.times[gap - 1]:g} s, ends at {trajectory.source.row(gap)}; "
            f"cut it there, or mend the stamps"
        )
    return record(
        TrajectoryController(trajectory, name),
        trajectory.duration,
        config=TaskConfig() if motors is None else TaskConfig(motor=motors),
        first_stamp=int(trajectory.stamps[0]),
        progress=progress,
        start=trajectory.positions_at(0.0),
    )


def record(
    controller: Controller,
    seconds: float,
    command: tuple[float, float] = (0.0, 0.0),
    config: TaskConfig | None = None,
    first_stamp: int = 0,
    progress: Progress | None = None,
    start: NDArray[np.float64] | None = None,
) -> Recording:
    """Run a controller on one robot from the start that every recording has.

    Args:
        controller: what to run.
        seconds: for how long; the last control step may end later.
        command: forward velocity in m/s and yaw rate in rad/s.
        config: the task, of which the randomization is left out; the action mode is the controller's own.
        first_stamp: ns, of the start.
        progress: is told how far it is.
        start: joint positions (8,) in rad to start in; None is the stance.

    Raises:
        QuadrupedError: if the command is outside the task's ranges.
    """
    config = replace(task_config(controller.action_mode, config), randomization=STILL)
    task = Task(SingleSimulation(load_model(config.physics_timestep, config.motor)), config)
    task.reset(_ROW, seeds=[0], command=command)
    # An episode begins facing anywhere; this one begins facing along x.
    task.simulation.reset(_ROW, _start(start)[None], np.zeros((1, 14)))

    steps = math.ceil(seconds / config.control_timestep - 1e-6)
    position, velocity, torque = np.empty((3, steps + 1, len(JOINT_NAMES)))
    base_pose, velocity_b = np.empty((steps + 1, 7)), np.empty((steps + 1, 2))
    contact = np.empty((steps + 1, len(LEG_NAMES)), np.bool_)
    state = task.simulation.state

    def keep(row: int) -> None:
        position[row], velocity[row], torque[row] = state.joint_position, state.joint_velocity, state.joint_torque
        base_pose[row, :3], base_pose[row, 3:] = state.base_position, state.orientation
        velocity_b[row] = state.linear_velocity_b[0, 0], state.angular_velocity_b[0, 2]
        contact[row] = state.foot_force > config.reward.contact_threshold

    observation = task.observe()
    rows, fell_at = 1, None
    keep(0)
    for step in range(1, steps + 1):
        transition = controller.step(task, observation)
        observation = transition.observation
        if fell_at is None and transition.terminated[0]:
            fell_at = step * config.control_timestep
        if transition.diverged[0]:
            break
        keep(step)
        rows += 1
        if progress is not None:
            progress(step / steps)
    stamps = first_stamp + _stamps(np.arange(rows) * config.control_timestep)
    joints = JointTrajectory(stamps, JOINT_NAMES, position[:rows], velocity[:rows], torque[:rows])
    return Recording(controller.name, joints, base_pose[:rows], velocity_b[:rows], contact[:rows], fell_at)


def _start(positions: NDArray[np.float64] | None) -> NDArray[np.float64]:
    """All coordinates (15,) of the robot at rest on its feet."""
    if positions is None:
        return np.array([0.0, 0.0, STANCE_HEIGHT, 1.0, 0.0, 0.0, 0.0, *STANCE])
    within = positions.clip(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)
    return np.concatenate([resting_pose(within), within])


def _stamps(times: NDArray[np.floating[Any]]) -> NDArray[np.int64]:
    return np.rint(times * NS_PER_SECOND).astype(np.int64)
