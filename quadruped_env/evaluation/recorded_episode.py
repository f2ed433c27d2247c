"""Single-robot episodes: joint targets of a scripted gait, and the recording of a controller that runs in simulation.

Every recording begins identically: the robot is at rest on its feet and faces along x, without randomization. A
controller begins in the stance, a recorded trajectory in its own first row. The motion therefore depends on the
controller alone, and a replay of the same joint targets is bit-identical.
"""

import math
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.conditions import Command
from quadruped_env.evaluation.measures import TILTED
from quadruped_env.evaluation.trace import Recorder, Trace
from quadruped_env.gait import SinusoidalGait
from quadruped_env.policies import Controller, TrajectoryController
from quadruped_env.robot import MINI_QUADRUPED, MotorConfig, Robot
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.simulation import SingleSimulation, Terrain, flat, highest_ground
from quadruped_env.task import Task, TaskConfig
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.rotations import tilt

MAX_RATE: Final = 1000.0
"""Maximum rate of joint targets, Hz."""
MAX_SECONDS: Final = 6 * 3600.0
"""Maximum duration, s. A longer recording more likely has a timestamp from another clock (a first timestamp of 0)."""

_ROW: Final = np.zeros(1, dtype=np.intp)


@dataclass(frozen=True, kw_only=True, eq=False)
class Recording(Trace):
    """Trace of one robot from its start: K + 1 samples for K control steps.

    The recording continues after a fall and stops if the simulation diverges.
    """

    controller: str
    fell_at: float | None
    """Time of the fall from the start, s; None without a fall"""

    @property
    def stayed_on_its_feet(self) -> bool:
        """True without a fall and without a tilt of more than `measures.TILTED`."""
        return self.fell_at is None and not (tilt(self.orientation) > TILTED).any()

    def outcome(self) -> str:
        """Return the outcome in one sentence: fall, tilt or neither, and displacement."""
        x, y = (self.base_pose[-1, :2] - self.base_pose[0, :2]).round(2)
        lean = tilt(self.orientation)
        fate = "stayed on its feet"
        if self.fell_at is not None:
            fate = f"fell at {self.fell_at:.2f} s"
        elif not self.stayed_on_its_feet:
            fate = (
                f"did not fall, but was tilted by more than {math.degrees(TILTED):.0f} degrees for "
                f"{(lean > TILTED).sum() * self.timestep:.2f} s (up to {np.degrees(lean.max()):.0f} degrees)"
            )
        return (
            f"In {self.joints.duration:g} s the robot {fate} and got {abs(x):.2f} m "
            f"{'ahead' if x >= 0 else 'back'} and {abs(y):.2f} m to the {'left' if y >= 0 else 'right'}."
        )


def publish(gait: SinusoidalGait, seconds: float, rate: float) -> JointTrajectory:
    """Compute the joint targets of a gait publisher: positions and velocities at t = 0, 1 / rate, ... to `seconds`.

    Raises:
        QuadrupedError: if `seconds` or `rate` is out of range.
    """
    if not 0.0 < rate <= MAX_RATE:
        raise QuadrupedError(f"rate: expected over 0 and up to {MAX_RATE:g} Hz; found {rate:g}")
    if not 0.0 < seconds <= MAX_SECONDS:
        raise QuadrupedError(f"seconds: expected over 0 and up to {MAX_SECONDS:g} s; found {seconds:g}")
    # Multiplied by 1 / rate, so that 50 Hz gives exactly the times and positions of a gait on the task's clock.
    times = np.arange(math.floor(seconds * rate + 1e-6) + 1) * (1.0 / rate)
    stamps = np.rint(times * NS_PER_SECOND).astype(np.int64)
    return JointTrajectory(stamps, gait.robot.joint_names, gait.positions(times), gait.velocities(times))


def play(
    trajectory: JointTrajectory,
    name: str = "recording",
    progress: Progress | None = None,
    motors: MotorConfig | None = None,
    robot: Robot = MINI_QUADRUPED,
    terrain: str | Terrain | None = None,
) -> Recording:
    """Play joint positions as motor targets, with gravity and ground, and record the motion.

    The robot starts on its feet in the positions of the first row. The recording has the trajectory's first timestamp.

    Args:
        trajectory: all joints; joints that the robot does not have are ignored.
        name: name in reports.
        progress: called with the fraction done.
        motors: motors to use instead of the robot's.
        robot: robot that plays them.
        terrain: a terrain, or the name of a built-in one; None is level ground.

    Raises:
        QuadrupedError: if a joint or the terrain is unknown, a joint is missing, or the trajectory is too long.
    """
    if trajectory.duration > MAX_SECONDS:
        gap = int(np.argmax(np.diff(trajectory.stamps))) + 1
        raise QuadrupedError(
            f"{trajectory.source.name}: lasts {trajectory.duration:g} s, over {MAX_SECONDS:g} s; its longest gap, "
            f"{trajectory.times[gap] - trajectory.times[gap - 1]:g} s, ends at {trajectory.source.row(gap)}; "
            f"cut it there, or fix the timestamps"
        )
    targets, config = trajectory.in_joint_order(robot), TaskConfig().for_robot(robot).on_terrain(terrain or flat)
    return record(
        TrajectoryController(targets, name),
        targets.duration,
        config=config if motors is None else replace(config, motor=motors),
        first_stamp=int(targets.stamps[0]),
        progress=progress,
        start=targets.positions[0],
    )


def record(
    controller: Controller,
    seconds: float,
    command: Command = (0.0, 0.0),
    config: TaskConfig | None = None,
    first_stamp: int = 0,
    progress: Progress | None = None,
    start: NDArray[np.float64] | None = None,
) -> Recording:
    """Run a controller on one robot from the common start of all recordings.

    Args:
        controller: controller to run.
        seconds: duration, s; the last control step may end later.
        command: forward velocity in m/s, yaw rate in rad/s, and for robots that move sideways lateral velocity in m/s.
        config: task configuration, with its robot; its randomization is ignored, and its action mode is the
            controller's.
        first_stamp: timestamp of the start, ns.
        progress: called with the fraction done.
        start: initial joint positions (J,), rad; None is the stance.

    Raises:
        QuadrupedError: if the command is outside the task's ranges.
    """
    config = task_config(controller.action_mode, config).without_randomization()
    robot = config.robot
    model = config.compiled_model()
    task = Task(SingleSimulation(model, robot), config)
    task.reset(_ROW, seeds=[0], command=command)
    qpos = _start(robot, start)
    qpos[2] += highest_ground(task.simulation, qpos[:2])
    task.place(_ROW, qpos[None], np.zeros((1, robot.num_velocities)))

    steps = math.ceil(seconds / config.control_timestep - 1e-6)
    recorder = Recorder(robot, steps + 1)
    observation = task.observe()
    fell_at = None
    recorder.write(task.simulation.readings, contact=task.context.foot_contact)
    for step in range(1, steps + 1):
        transition = task.act(controller, observation)
        observation = transition.observation
        if fell_at is None and transition.terminated[0]:
            fell_at = step * config.control_timestep
        if transition.diverged[0]:
            break
        recorder.write(task.simulation.readings, contact=task.context.foot_contact)
        if progress is not None:
            progress(step / steps)
    recording = Recording(
        robot=robot,
        **recorder.arrays(),
        controller=controller.name,
        timestep=config.control_timestep,
        terrain=config.ground,
        first_stamp=first_stamp,
        fell_at=fell_at,
    )
    return recording.env(0).window(stop=recorder.written)


def _start(robot: Robot, positions: NDArray[np.float64] | None) -> NDArray[np.float64]:
    """Return the generalized coordinates (7 + J,) of a robot at rest on its feet."""
    if positions is None:
        return np.array([0.0, 0.0, robot.stance_height, 1.0, 0.0, 0.0, 0.0, *robot.stance])
    within = positions.clip(robot.joint_position_low, robot.joint_position_high)
    return np.concatenate([robot.skeleton.resting_pose(within), within])
