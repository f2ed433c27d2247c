"""The simulated robot with motors that follow commands, and a watchdog as in a real motor driver."""

import math
from typing import Final

import numpy as np

from quadruped_env.control.joint_command import LIMP, Target
from quadruped_env.live.middleware.topics import PUSH
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.motors import servo_target
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation import SingleSimulation, Terrain, build_model, flat, highest_ground
from quadruped_env.simulation.push_limit import PushLimit
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.rotations import from_yaw, yaw

TIMESTEP: Final = 0.005
"""Duration of a physics step, s."""
WATCHDOG: Final = 1.0
"""Time without a command after which commanded motors go limp, s."""
_MAX_OVERTRAVEL: Final = 0.5
"""Angle of a joint beyond its range above which the simulation has diverged, rad; hard impacts reach 0.01 rad."""
_MAX_OVERSPEED: Final = 20.0
"""The same for its speed, relative to the motor's maximum; hard impacts reach 8."""
_ROW: Final = np.zeros(1, dtype=np.intp)


class SimulatedRobot:
    """One robot on its terrain, initially standing.

    Args:
        seed: seed of the initial heading.
        terrain: the ground.
        robot: the robot.
    """

    def __init__(self, seed: int = 0, terrain: Terrain = flat, robot: Robot = MINI_QUADRUPED) -> None:
        self.robot = robot
        self._simulation = SingleSimulation(build_model(TIMESTEP, terrain=terrain, robot=robot), robot)
        self.state = self._simulation.readings
        self._generator = np.random.default_rng(seed)
        self.target = robot.stance.copy()
        """Joint targets, within the joints' range, rad (J,)."""
        self._servo_errors = robot.motors.servo_errors(robot.joint_kinds)
        self._play = robot.stance[None].copy()
        self.limp = False
        """True if the motors are disabled: they only brake, like motors with shorted windings."""
        self._commanded_for: float | None = None
        """Time since the last command, s; None before the first."""
        self._time = 0.0
        self._push_limit = PushLimit(PUSH.name)
        self.reset()

    def reset(self) -> None:
        """Put the robot on its feet at the origin, with a random heading."""
        heading = from_yaw(self._generator.uniform(-math.pi, math.pi))
        start = np.zeros(2)
        self.put(np.concatenate([start, [self._standing_height(start)], heading, self.robot.stance]))

    def put(self, qpos: Floats) -> None:
        """Set the robot's pose, at rest, with motors enabled as at the start.

        Args:
            qpos: base position in m, base quaternion wxyz, and joint positions in rad (7 + J,).
        """
        self._simulation.reset(_ROW, qpos[None], np.zeros((1, self.robot.num_velocities)))
        self.target = qpos[7:].copy()
        self._play[:] = qpos[7:]
        self._commanded_for = None
        self.limp = False

    def command(self, target: Target) -> None:
        """Apply a command from the next physics step on; targets are clipped to the joints' range."""
        self._commanded_for = 0.0
        if target is LIMP:
            self.limp = True
            return
        self.target = np.clip(target, self.robot.joint_position_low, self.robot.joint_position_high)
        self.limp = False

    def pick_up(self) -> None:
        """Put the robot on its feet at its current position, with motors enabled."""
        place, heading = self.state.base_position[0, :2], from_yaw(yaw(self.state.orientation[0]))
        self.put(np.concatenate([place, [self._standing_height(place)], heading, self.robot.stance]))

    def _standing_height(self, place: Floats) -> float:
        """Return the height of the base's centre in the stance, over the highest ground around a position (2,), m."""
        return self.robot.stance_height + float(highest_ground(self._simulation, place))

    def push(self, velocity: Floats) -> None:
        """Add a velocity (3,) in the world frame, m/s, to the base's velocity.

        Raises:
            QuadrupedError: if it is not finite, or too large together with other pushes, see `PushLimit`.
        """
        self._push_limit.check(velocity, self._time)
        self._simulation.push(_ROW, velocity[None])

    def step(self) -> bool:
        """Advance by one physics step. Returns True if the watchdog disabled the motors in it."""
        watchdog_tripped = False
        self._time += TIMESTEP
        if self._commanded_for is not None:
            self._commanded_for += TIMESTEP
            watchdog_tripped = not self.limp and self._commanded_for > WATCHDOG
            if watchdog_tripped:
                self.limp = True
        position = self.state.joint_position
        if self.limp:
            self._play[:] = position
        # With its own position as target, a position servo applies only its damping.
        pursued = position if self.limp else servo_target(self.target, position, self._play, *self._servo_errors)
        self._simulation.step(pursued, 1)
        return watchdog_tripped

    @property
    def diverged(self) -> bool:
        """True if the simulation has diverged: its state is not one of a robot."""
        robot, position, velocity = self.robot, self.state.joint_position[0], self.state.joint_velocity[0]
        beyond = position - np.clip(position, robot.joint_position_low, robot.joint_position_high)
        possible = (np.abs(beyond) <= _MAX_OVERTRAVEL) & (np.abs(velocity) <= _MAX_OVERSPEED * robot.velocity_limit)
        return bool(self._simulation.diverged()[0]) or not possible.all()

    @property
    def fallen(self) -> bool:
        """True if the robot is tilted by more than 1 rad, from which it cannot recover."""
        return bool(self.state.up_b[0, 2] < np.cos(1.0))
