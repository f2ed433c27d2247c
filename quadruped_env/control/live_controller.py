"""State machine of the live controller. Pure logic: times and measurements are passed in.

    waiting --fresh states--> ramping --at the stance--> walking
    ramping, walking --no state for 0.2 s--> holding --for 1 s--> limp --> waiting
    ramping, walking --this process was held up for 1 s--> limp
    ramping, walking --fallen--> limp
    holding --fresh states--> ramping

Walking is following the command, which is to stand where there is none, or none newer than 0.5 s.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.config import ControlConfig
from quadruped_env.control.controllers import Controller, PolicyController
from quadruped_env.control.interface import ControlInterface
from quadruped_env.control.joint_command import LIMP, Target, limited
from quadruped_env.control.observations import OBSERVATIONS
from quadruped_env.control.stand_up import StandUp
from quadruped_env.control.timestamp_filter import TimestampFilter
from quadruped_env.control.velocity_command import VELOCITY
from quadruped_env.errors import QuadrupedError
from quadruped_env.readings import Readings
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot
from quadruped_env.rotations import rotate_inverse
from quadruped_env.timestamps import NS_PER_SECOND

_ROW: Final = np.zeros(1, dtype=np.intp)
_LONGEST_STEP: Final = 2.5
"""Control steps that the way to the stance goes on in one, where states between were lost"""
_ROUNDING: Final = 1e-6
"""s"""
_EARLY: Final = 0.25
"""of a control step; by which a state may come before its tick and still be it, as stamps of real robots jitter"""


@dataclass(frozen=True)
class Safety:
    """When the controller moves the robot, and when it stops."""

    fresh_states: int = 20
    """in a row, of an upright robot at rest, before it is moved"""
    rest_way: float = 0.03
    """rad that a joint may move meanwhile"""
    sinks_after: float = 1.0
    """s of fresh states of an upright robot, after which it need not be at rest: limp, it may sink for 10 s"""
    sinks_way: float = 0.15
    """rad that a joint may move meanwhile then"""
    hold_after: float = 0.2
    """s without a state"""
    limp_after: float = 1.0
    """s without a state"""
    command_lasts: float = 0.5
    """s that a velocity command is followed"""
    ramp_speed: float = 1.5
    """rad/s; mean speed of the joint that has the longest way"""
    ramp_least: float = 1.0
    """s; the shortest ramp from one pose to the next"""
    settle: float = 0.5
    """s in the stance before walking"""
    max_tilt: float = 1.0
    """rad between the base's up axis and the world's, beyond which the robot counts as fallen"""


class Mode(Enum):
    """What the controller is about."""

    WAITING = "waiting for fresh states"
    RAMPING = "going to the stance"
    WALKING = "following the command"
    HOLDING = "holding: no states come"
    LIMP = "limp"


class Measurement(NamedTuple):
    """What the robot measured at one time, in this robot's order of joints."""

    stamp: int
    """ns"""
    positions: NDArray[np.float64]
    """rad (8,)"""
    velocities: NDArray[np.float64]
    """rad/s (8,)"""
    orientation: NDArray[np.float64]
    """Unit quaternion wxyz (4,)"""
    angular_velocity: NDArray[np.float64]
    """rad/s in the base's axes (3,)"""


class Answer(NamedTuple):
    """A command to the robot."""

    stamp: int
    """ns of the state that it answers"""
    target: Target


class LiveController:
    """Drives one robot with one controller.

    Args:
        controller: computes the joint targets while walking.
        config: time step, clock and commands; None takes a policy's own, and the defaults for other controllers.
        safety: when to stop.
        say: called with every change of mode, in words.
        robot: that is driven.

    Raises:
        QuadrupedError: if the controller's policy observes something that the robot does not measure.
    """

    def __init__(
        self,
        controller: Controller,
        config: ControlConfig | None = None,
        safety: Safety | None = None,
        say: Callable[[str], None] = lambda text: None,
        robot: Robot = MINI_QUADRUPED,
    ) -> None:
        policy = controller.policy if isinstance(controller, PolicyController) else None
        if config is None:
            config = ControlConfig() if policy is None else policy.control
        self.safety = safety or Safety()
        self.mode = Mode.WAITING
        self._say = say
        self._controller = controller
        self._robot = robot
        self._readings = Readings.of_a_real_robot(robot)
        self._control = ControlInterface(robot, config, fields=OBSERVATIONS if policy is None else policy.fields)
        self._check_observation()
        self._ranges = [entry.range for entry in config.commands[:VELOCITY]]
        self._defaults = np.array([entry.default for entry in config.commands])
        self.period = config.timestep
        """s between commands"""
        self._step = round(self.period * NS_PER_SECOND)
        self._timestamps = TimestampFilter("/joint_states", self._relearned)
        self._fresh = 0
        self._rest = robot.stance
        self._fallen = False
        """Whether it was let go limp because it had fallen"""
        self._upright_since: int | None = None
        """ns; stamp from which on all states were fresh, and the robot upright"""
        self._heard = -math.inf
        self._stamp = 0
        self._due: int | None = None
        self._silent_due = 0.0
        self._command = np.zeros(2)
        self._command_at = -math.inf
        self._last = robot.stance.copy()
        self._rise = StandUp.plan(robot.stance, self.safety.ramp_speed, self.safety.ramp_least)
        self._risen = 0.0
        """s of the rise that are done"""
        self._rise_at = 0, 0.0
        """Stamp in ns and time in s of the state that it last answered"""

    def command(self, forward_velocity: float, yaw_rate: float, now: float) -> None:
        """Take a velocity command, m/s and rad/s, within what the controller was made for.

        Raises:
            QuadrupedError: if it is not finite; the one before goes on, for as long as it lasts.
        """
        asked = np.array([forward_velocity, yaw_rate])
        if not np.isfinite(asked).all():
            raise QuadrupedError(f"/cmd_vel: {asked.tolist()} is not finite; send finite numbers")
        self._command = np.array([min(max(v, low), high) for v, (low, high) in zip(asked, self._ranges, strict=True)])
        self._command_at = now

    def moving(self, now: float) -> bool:
        """Whether a velocity command is in force."""
        return now - self._command_at <= self.safety.command_lasts

    def measured(self, measurement: Measurement, now: float) -> Answer | None:
        """Take a measurement; the command that it calls for, if one is due.

        Args:
            measurement: what came.
            now: when it was taken, s.

        Raises:
            QuadrupedError: if the measurement is not fit to act on, saying why; it counts as none.
        """
        if self._moving and now - self._heard > self.safety.limp_after:
            # This process was held up for so long that the robot's own watchdog has let the motors go.
            return self._let_go()
        refusal = self._timestamps.refusal(measurement.stamp, now, self._moving)
        if refusal:
            raise QuadrupedError(refusal)
        self._heard, self._stamp = now, measurement.stamp
        self._take_in(measurement)
        if self.mode in (Mode.WAITING, Mode.HOLDING, Mode.LIMP):
            self._qualify(measurement, now)
        if self.mode not in (Mode.RAMPING, Mode.WALKING):
            return None
        if not self._upright:
            self._go_limp("the robot has fallen; put it on its feet")
            self._fallen = True
            return Answer(measurement.stamp, LIMP)
        if self._due is None or self._stamp > self._due + self._step:
            # The first one, or so many were missed that the grid begins anew here.
            self._due = self._stamp
        if self._stamp < self._due - _EARLY * self._step:
            return None
        self._due += self._step
        return self._act(now)

    def silent(self, now: float) -> Answer | None:
        """What to command when no measurement comes; to be called often."""
        silence = now - self._heard
        if self.mode is Mode.WAITING:
            if silence > self.safety.limp_after:
                self._begin_anew()
            return None
        if self.mode is Mode.LIMP:
            if silence > self.safety.limp_after:
                self._begin_anew()
                self._enter(Mode.WAITING, "")
            return None
        if silence <= self.safety.hold_after:
            return None
        if silence > self.safety.limp_after:
            return self._let_go()
        if self.mode is not Mode.HOLDING:
            self._enter(Mode.HOLDING, f"no state for {self.safety.hold_after:g} s")
            self._count_anew()
            self._silent_due = now
        if now < self._silent_due:
            return None
        self._silent_due += self.period
        return Answer(self._stamp, self._last)

    def _qualify(self, measurement: Measurement, now: float) -> None:
        if self._fresh == 0:
            self._rest = measurement.positions
        self._fresh += 1
        if not self._upright:
            self._fresh, self._upright_since = 0, None
            return
        if self._upright_since is None:
            self._upright_since = measurement.stamp
        # A robot that fell is being put on its feet by somebody, and left alone until its legs are at rest.
        upright_for = (measurement.stamp - self._upright_since) / NS_PER_SECOND
        sinks = not self._fallen and upright_for > self.safety.sinks_after
        way = self.safety.sinks_way if sinks else self.safety.rest_way
        if np.abs(measurement.positions - self._rest).max() > way:
            self._fresh = 0
        if self._fresh < self.safety.fresh_states:
            return
        # From beyond the range the way would have no bound.
        self._last = np.clip(measurement.positions, self._robot.joint_position_low, self._robot.joint_position_high)
        self._rise = StandUp.plan(self._last, self.safety.ramp_speed, self.safety.ramp_least)
        self._risen, self._rise_at = 0.0, (measurement.stamp, now)
        self._due = None
        self._fallen = False
        self._enter(Mode.RAMPING, f"{self._rise.duration:.1f} s")

    def _act(self, now: float) -> Answer:
        if self.mode is Mode.RAMPING:
            target = self._ramp(now)
        else:
            self._follow(self._command if self.moving(now) else np.zeros(VELOCITY))
            observation = self._control.observe(self._readings)
            self._control.advance()
            target = self._controller.act(observation, self._control)[0]
        self._last = limited(target, self._last, self.period)
        return Answer(self._stamp, self._last)

    def _follow(self, velocity: NDArray[np.float64]) -> None:
        """Command a velocity (2,), in m/s and rad/s, where it is another than before."""
        command = np.concatenate([velocity, self._defaults[VELOCITY:]])
        if not np.array_equal(command, self._control.commands[0]):
            self._control.set_command(_ROW, command[None])

    def _take_in(self, measurement: Measurement) -> None:
        readings = self._readings
        readings.joint_position[0] = measurement.positions
        readings.joint_velocity[0] = measurement.velocities
        readings.orientation[0] = measurement.orientation
        readings.up_b[0] = rotate_inverse(measurement.orientation, [0.0, 0.0, 1.0])
        readings.angular_velocity_b[0] = measurement.angular_velocity

    @property
    def _upright(self) -> bool:
        return float(self._readings.up_b[0, 2]) > math.cos(self.safety.max_tilt)

    def _check_observation(self) -> None:
        observation = self._control.observe(self._readings)[0]
        for name, columns in self._control.layout.slices.items():
            if not np.isfinite(observation[columns]).all():
                raise QuadrupedError(
                    f"policy: it observes {name}, which the robot does not measure: it measures joint positions and "
                    f"velocities, attitude and angular velocity; train a policy without {name}"
                )

    def _ramp(self, now: float) -> NDArray[np.float64]:
        stamp, then = self._rise_at
        # After a delay the robot is not hurried to where it would have been, nor by a clock that is set ahead.
        self._risen += min((self._stamp - stamp) / NS_PER_SECOND, now - then, _LONGEST_STEP * self.period)
        self._rise_at = self._stamp, now
        if self._risen >= self._rise.duration + self.safety.settle - _ROUNDING:
            self._control.reset(_ROW)
            self._follow(np.zeros(VELOCITY))
            self._enter(Mode.WALKING, "")
        return self._rise.positions(self._risen)

    @property
    def _moving(self) -> bool:
        """Whether the robot is commanded to anywhere."""
        return self.mode in (Mode.RAMPING, Mode.WALKING, Mode.HOLDING)

    def _let_go(self) -> Answer:
        self._go_limp(f"no state for {self.safety.limp_after:g} s")
        return Answer(self._stamp, LIMP)

    def _relearned(self, change: float) -> None:
        """What was learned of the states' lag was wrong: those that came before count no more."""
        self._count_anew()
        if change > 0.0:
            self._say(f"all states come {change:.2f} s later than before; that is taken as normal from here on")

    def _go_limp(self, why: str) -> None:
        self._enter(Mode.LIMP, why)
        self._begin_anew()

    def _begin_anew(self) -> None:
        self._timestamps.reset()
        self._count_anew()

    def _count_anew(self) -> None:
        """States that came before say no more whether the robot may be moved."""
        self._fresh, self._upright_since = 0, None

    def _enter(self, mode: Mode, why: str) -> None:
        self.mode = mode
        self._say(f"{mode.value}{f' ({why})' if why else ''}")
