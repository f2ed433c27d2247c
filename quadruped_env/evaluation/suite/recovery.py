"""Recovery of limp robots that were dropped or have fallen, by the live controller's stand-up."""

import math
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.live_controller import LiveController, Measurement, Mode
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.confidence import bootstrap_mean, proportion
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import Recovery, Release
from quadruped_env.robot import Robot
from quadruped_env.robot.motors import servo_target
from quadruped_env.robot.units import scale_of
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.simulation import BatchSimulation
from quadruped_env.utils import rotations
from quadruped_env.utils.progress import Progress

Floats = NDArray[np.float64]

_MAX_TILT: Final = 1.0
"""Tilt above which a robot is not on its feet, rad, as in the built-in terminations."""
_MAX_TRUNK_FORCE: Final = 1.0
"""Force on the trunk above which a robot is not on its feet, N, as in the built-in terminations."""


def run(part: Recovery, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """Recoveries of every release: name -> plain values.

    A controller that no real robot can run recovers nowhere; `refused` then holds the reason.
    """
    robot = measured.robot
    starts = np.concatenate([start_poses(robot, release, part.seeds) for release in part.releases])
    refused: dict[str, str] = {}
    try:
        times = recover(part, measured, starts, progress)
    except QuadrupedError as error:
        times, refused = np.full(len(starts), np.nan), {"refused": str(error)}
    return {
        release.name: {
            "recovered": proportion(np.isfinite(seconds)).to_dict(),
            "time": bootstrap_mean(seconds).to_dict(),
            **refused,
        }
        for release, seconds in zip(part.releases, times.reshape(-1, part.num_seeds), strict=True)
    }


def start_poses(robot: Robot, release: Release, seeds: range) -> Floats:
    """Poses in which the robots are released (S, 7 + J), as MuJoCo's `qpos`; heights follow the robot's stance.

    The numbers of a seed come from `numpy.random.default_rng(seed)`, in this order: direction of the axis of the tilt,
    heading, joint positions.
    """
    poses = []
    for seed in seeds:
        generator = np.random.default_rng(seed)
        direction, heading = generator.uniform(-math.pi, math.pi, 2)
        joints = generator.uniform(robot.joint_position_low, robot.joint_position_high)
        axis = [math.cos(direction), math.sin(direction), 0.0]
        orientation = rotations.multiply(
            rotations.from_axis_angle(axis, math.radians(release.tilt)), rotations.from_yaw(heading)
        )
        position = joints if release.random_joints else robot.stance
        height = release.height * scale_of("m", robot)
        poses.append(np.concatenate([[0.0, 0.0, height], orientation, position]))
    return np.array(poses)


def recover(
    part: Recovery, measured: MeasuredController, starts: Floats, progress: Progress | None = None
) -> NDArray[np.float64]:
    """Time from the start of the live controller until each robot (N,) is on its feet and stays there, s.

    NaN for a robot that does not recover. `starts` are the initial `qpos` (N, 7 + J).

    Raises:
        QuadrupedError: if the controller observes something that a real robot does not measure.
    """
    config = measured.task([part.command])
    robot, dt, substeps = config.robot, config.control_timestep, config.decimation
    simulation = BatchSimulation(config.compiled_model(), len(starts), robot=robot)
    everyone = np.arange(len(starts))
    simulation.reset(everyone, starts, np.zeros((len(starts), robot.num_velocities)))
    controller = measured.controller
    control = None if isinstance(controller, PolicyController) else config.control
    robots = [LiveController(controller, control, robot=robot) for _ in starts]
    readings = simulation.readings
    limp = np.ones(len(starts), dtype=np.bool_)
    targets = starts[:, 7:].copy()
    play, servo_errors = targets.copy(), config.motor.servo_errors(robot.joint_kinds)
    on_feet_since = np.full(len(starts), np.nan)
    recovered = np.full(len(starts), np.nan)
    wait, steps = round(part.limp_seconds / dt), round((part.limp_seconds + part.seconds) / dt)
    for step in range(steps):
        if step >= wait:
            _act(robots, simulation, part.command, step, dt, limp, targets)
        for _ in range(substeps):
            position = readings.joint_position
            np.copyto(play, position, where=limp[:, None])
            pursued = servo_target(targets, position, play, *servo_errors)
            # With its own position as target, a position servo applies only its damping, as a limp motor does.
            simulation.step(np.where(limp[:, None], position, pursued), 1)
        if step < wait:
            continue
        now = (step - wait + 1) * dt
        walking = np.array([live.mode is Mode.WALKING for live in robots])
        on_feet = (
            walking
            & (readings.up_b[:, 2] >= math.cos(_MAX_TILT))
            & (readings.trunk_force <= _MAX_TRUNK_FORCE).all(axis=1)
            & ~simulation.diverged()
        )
        on_feet_since = np.where(on_feet, np.where(np.isnan(on_feet_since), now, on_feet_since), np.nan)
        done = np.isnan(recovered) & (now - on_feet_since >= part.walk_seconds - 1e-9)
        recovered[done] = on_feet_since[done]
        if progress is not None:
            progress((step + 1) / steps)
        if np.isfinite(recovered).all():
            break
    return recovered


def _act(
    robots: list[LiveController],
    simulation: BatchSimulation,
    command: tuple[float, float],
    step: int,
    dt: float,
    limp: NDArray[np.bool_],
    targets: Floats,
) -> None:
    """Give every live controller the measurement of its robot, and take over its joint targets in place."""
    readings, now = simulation.readings, step * dt
    for i, live in enumerate(robots):
        if live.mode is Mode.WALKING:
            live.command(*command, now)
        measurement = Measurement(
            round(now * NS_PER_SECOND),
            readings.joint_position[i].copy(),
            readings.joint_velocity[i].copy(),
            readings.orientation[i].copy(),
            readings.angular_velocity_b[i].copy(),
        )
        try:
            answer = live.measured(measurement, now)
        except QuadrupedError:
            continue  # a measurement that the controller rejects, as one of a robot that diverged
        if answer is None:
            continue
        limp[i] = answer.target is LIMP
        if answer.target is not LIMP:
            targets[i] = answer.target
