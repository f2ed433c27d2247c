"""State machine of the live controller. It does no I/O: times and measurements are passed in.

    waiting --fresh states--> ramping --at the stance--> walking
    ramping, walking --no state for 0.2 s--> holding --for 1 s--> limp --> waiting
    ramping, walking --this process was blocked for 1 s--> limp
    ramping, walking --fallen, or joint targets invalid for 0.2 s--> limp
    any --emergency stop--> limp --released, and a velocity command--> waiting
    holding --fresh states--> ramping

While walking, the robot follows the velocity command. Without a command, or after 0.5 s without a new one, it stands.

Control ticks have the period that the policy was trained with, whatever the rate of the states: each uses the newest
one. A tick waits for a state that is due with it. Up to three ticks that were missed are made up for.
"""

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Final, NamedTuple, Self

import numpy as np

from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.control_interface import ControlInterface, Controller
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.joint_command import LIMP, MAX_MEASURED, Target, TargetGate, limited
from quadruped_env.control.observations import OBSERVATIONS
from quadruped_env.control.stand_up import StandUp
from quadruped_env.control.timestamp_filter import TimestampFilter
from quadruped_env.control.velocity_command import out_of_range
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.readings import Readings
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of, scaled
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.rotations import rotate_inverse

_ENV_IDS: Final = np.zeros(1, dtype=np.intp)
_MAX_LATE: Final = 2.5
"""Delay in control steps beyond which control ticks are left out instead of made up for."""
_ROUNDING: Final = 1e-6
"""Tolerance of rounding errors, s."""
_CLIPPED_PERIOD: Final = 1.0
"""Time without a command out of range after which the next one is logged again, s."""
_EARLY_TOLERANCE: Final = 0.25
"""Fraction of a control step by which a state may precede its tick: timestamps of real robots jitter."""
_LATE_TOLERANCE: Final = 0.5
"""Fraction of a control step for which a tick waits for its state."""


@dataclass(frozen=True)
class Safety:
    """Conditions under which the controller starts and stops moving the robot."""

    fresh_states: int = 20
    """Consecutive fresh states of an upright robot at rest that are needed before it is moved."""
    rest_tolerance: float = 0.03
    """Maximum motion of a joint during these states, rad."""
    sinking_after: float = 1.0
    """Time upright, with fresh states, after which `sinking_tolerance` applies: a limp robot may sink for 10 s, s."""
    sinking_tolerance: float = 0.15
    """Maximum motion of a joint during the fresh states of a robot that sinks, rad."""
    hold_after: float = 0.2
    """Time without a state after which the robot holds its joint targets, s."""
    limp_after: float = 1.0
    """Time without a state after which the robot goes limp, s."""
    command_timeout: float = 0.5
    """Time after which a velocity command expires, s."""
    ramp_speed: float = 1.5
    """Mean speed of the joint that moves farthest on a ramp, rad/s."""
    min_ramp_time: float = 1.0
    """Minimum duration of a ramp from one pose to the next, s."""
    settle: float = 0.5
    """Time in the stance before walking, s."""
    max_tilt: float = 1.0
    """Angle between the base's up axis and the world's above which the robot counts as fallen, rad."""

    @classmethod
    def of(cls, robot: Robot) -> Self:
        """The defaults for a robot: its motion follows its size, and times without messages do not."""
        units = {"ramp_speed": "rad/s", "min_ramp_time": "s", "settle": "s"}
        return cls(**{name: scaled(getattr(cls, name), scale_of(unit, robot)) for name, unit in units.items()})


class Mode(Enum):
    """State of the live controller."""

    WAITING = "waiting for fresh states"
    RAMPING = "going to the stance"
    WALKING = "following the command"
    HOLDING = "holding: no states come"
    LIMP = "limp"


class Measurement(NamedTuple):
    """Sensor readings of the robot at one time, with joints in this robot's order."""

    stamp: int
    """Timestamp, ns."""
    positions: Floats
    """Joint positions (J,), rad."""
    velocities: Floats
    """Joint velocities (J,), rad/s; NaN where unknown, if the controller does not need them."""
    orientation: Floats
    """Unit quaternion wxyz of the base (4,)."""
    angular_velocity: Floats
    """Angular velocity in the base frame (3,), rad/s."""


class JointCommand(NamedTuple):
    """Joint targets for the robot, or `LIMP`."""

    stamp: int
    """Timestamp of the state from which it was computed, ns."""
    target: Target


class LiveController:
    """Drives one robot with one controller.

    Args:
        controller: computes the joint targets while walking.
        safety: conditions for moving and stopping. None: the defaults.
        say: called with a line of text at every change of mode, and when a command is clipped.
        robot: the robot that is driven. None: the policy's, or the built-in one for other controllers.

    Raises:
        QuadrupedError: if the controller's policy is for another robot, or it observes something that the robot does
            not measure.
    """

    def __init__(
        self,
        controller: Controller,
        safety: Safety | None = None,
        say: Callable[[str], None] = lambda text: None,
        robot: Robot | None = None,
    ) -> None:
        policy = controller.policy if isinstance(controller, PolicyController) else None
        if policy is None:
            robot = robot or MINI_QUADRUPED
            config = ControlConfig.of_task({}, robot)
        else:
            robot, config = robot or policy.robot, policy.control
            policy.check_is_data("live controller")
            # Here, not when it acts: by then the robot would be on its feet.
            policy.check_fits(robot, config)
        self.safety = safety or Safety.of(robot)
        self.mode = Mode.WAITING
        self._say = say
        self._controller = controller
        self.robot = robot
        """The robot that is driven."""
        self._readings = Readings.of_a_real_robot(robot)
        self._control = ControlInterface(robot, config, fields=OBSERVATIONS if policy is None else policy.fields)
        self.needs_velocities = policy is not None and self._observes_velocities()
        """True if the policy observes joint velocities."""
        self._check_observation()
        self._commands = config.commands[: config.num_velocities]
        self._defaults = np.array([entry.default for entry in config.commands])
        self.period = config.timestep
        """Time between commands, s."""
        self._step = round(self.period * NS_PER_SECOND)
        self._timestamps = TimestampFilter("/joint_states", self._on_lag_changed)
        self._gate = TargetGate(robot.joint_names, say)
        self._fresh = 0
        self._rest, self._rest_stamp = robot.stance, 0
        self._obstacle = ""
        self._stopped = False
        """True from an emergency stop to its release."""
        self._awaits_command = False
        """True from that release to a velocity command."""
        self._fallen = False
        """True if the robot went limp because it had fallen."""
        self._upright_since: int | None = None
        """Timestamp since which all states have been fresh and the robot upright, ns."""
        self._heard = self._command_at = self._clipped_at = -math.inf
        self._stamp, self._silent_due = 0, 0.0
        self._intervals: deque[int] = deque(maxlen=3)
        """Last times between two states, ns."""
        self._due: int | None = None
        """Timestamp of the next control tick, ns."""
        self._command = np.zeros(len(self._commands))
        self._last = robot.stance.copy()
        self._stand_up = StandUp.plan(robot, robot.stance, self.safety.ramp_speed, self.safety.min_ramp_time)
        self._stand_up_time = 0.0
        """Elapsed time on the stand-up trajectory, s."""

    def command(self, velocity: Sequence[float], now: float) -> None:
        """Set the velocity command, clipped to the controller's ranges.

        Args:
            velocity: forward velocity in m/s, yaw rate in rad/s and lateral velocity in m/s. What is left out is zero,
                and what the robot has not is ignored.
            now: time of receipt, s.

        Raises:
            QuadrupedError: if it is not finite; the previous command stays in effect until it expires.
        """
        requested = np.zeros(len(self._commands))
        requested[: len(velocity)] = velocity[: len(requested)]
        if not np.isfinite(requested).all():
            raise QuadrupedError(f"/cmd_vel: {requested.tolist()} is not finite; send finite numbers")
        low, high = np.transpose([entry.range for entry in self._commands])
        self._command = requested.clip(low, high)
        if outside := out_of_range(requested, self._commands):
            if now - self._clipped_at > _CLIPPED_PERIOD:
                self._say(f"/cmd_vel: {outside}, and is clipped to it")
            self._clipped_at = now
        self._command_at = now
        # An idle joystick or keyboard sends zero, which is no request to move.
        self._awaits_command &= not requested.any()

    @property
    def waiting_for(self) -> str:
        """Condition that is missing before the robot is moved; empty while it is moved."""
        if self._stopped:
            return "the release of the emergency stop"
        if self._awaits_command:
            return "a velocity command other than zero (/cmd_vel), after the emergency stop"
        return "" if self.mode in (Mode.RAMPING, Mode.WALKING) else self._obstacle or "fresh states"

    @property
    def fault(self) -> str:
        """Why joint targets could not be sent; empty once the controller gives valid ones again."""
        return self._gate.fault

    def fail(self, why: str) -> JointCommand:
        """Let the robot go limp, since its joint targets cannot be sent. Returns the command to send."""
        self._gate.fault = why
        self._go_limp(why)
        return JointCommand(self._stamp, LIMP)

    def restart(self, why: str) -> None:
        """Wait for fresh states as at the start, as after the clock was set back; the robot keeps its last targets."""
        self._timestamps = TimestampFilter("/joint_states", self._on_lag_changed)
        self._gate = TargetGate(self.robot.joint_names, self._say)
        self._heard = self._command_at = self._clipped_at = -math.inf
        self._fallen = False
        self._reset_count()
        self._enter(Mode.WAITING, why)

    def emergency_stop(self, stopped: bool) -> JointCommand | None:
        """Let the robot go limp until the stop is released and a velocity command comes; then stand up as at the start.

        Returns:
            Command to send, or None if nothing changes.
        """
        if stopped == self._stopped:
            return None
        self._stopped = stopped
        if not stopped:
            self._awaits_command = True
            self.restart("emergency stop released")
            return None
        self._go_limp("emergency stop")
        return JointCommand(self._stamp, LIMP)

    def moving(self, now: float) -> bool:
        """True if a velocity command is in effect at a time in s."""
        return now - self._command_at <= self.safety.command_timeout

    def measured(self, measurement: Measurement, now: float) -> JointCommand | None:
        """Process a measurement that was received at a time in s; return the command to send, or None if none is due.

        Raises:
            QuadrupedError: if the measurement is rejected, with the reason; it is then ignored.
        """
        if self._moving and now - self._heard > self.safety.limp_after:
            # This process was blocked for so long that the robot's own watchdog has disabled the motors.
            return self._time_out()
        self._check_measured(measurement)
        refusal = self._timestamps.refusal(measurement.stamp, now, self._moving)
        if refusal:
            self._obstacle = f"fresh states: {refusal}"
            raise QuadrupedError(refusal)
        self._intervals.append(measurement.stamp - self._stamp)
        self._heard, self._stamp = now, measurement.stamp
        self._take_in(measurement)
        if self.mode in (Mode.WAITING, Mode.HOLDING, Mode.LIMP) and not (self._stopped or self._awaits_command):
            self._qualify(measurement, now)
        if self.mode not in (Mode.RAMPING, Mode.WALKING):
            return None
        if not self._upright:
            self._go_limp("the robot has fallen; put it on its feet")
            self._fallen = True
            return JointCommand(measurement.stamp, LIMP)
        return self._act_until(self._stamp, _EARLY_TOLERANCE * self._step, now)

    def silent(self, now: float) -> JointCommand | None:
        """Command to send when no measurement has arrived, or None; call it at every pass of the loop."""
        silence = now - self._heard
        if self.mode is Mode.WAITING:
            if silence > self.safety.limp_after:
                self._reset_qualification()
            return None
        if self.mode is Mode.LIMP:
            if silence > self.safety.limp_after:
                self._reset_qualification()
                self._enter(Mode.WAITING, "")
            return None
        if silence > self.safety.limp_after:
            return self._time_out()
        if self.mode is not Mode.HOLDING:
            if silence <= self.safety.hold_after:
                return self._act_until(self._timestamps.stamp_at(now), -self._patience, now)
            self._enter(Mode.HOLDING, f"no state for {self.safety.hold_after:g} s")
            self._reset_count()
            self._silent_due = now
        if now < self._silent_due:
            return None
        self._silent_due += self.period
        return JointCommand(self._stamp, self._last)

    def remaining(self, now: float) -> float:
        """Time until `silent` performs a control tick unless a measurement comes, s; infinite while there are none."""
        if self._due is None or self.mode not in (Mode.RAMPING, Mode.WALKING):
            return math.inf
        return (self._due + self._patience - self._timestamps.stamp_at(now)) / NS_PER_SECOND

    @property
    def _patience(self) -> float:
        """Time for which the next tick waits for a state, ns: 0 if the next state is due only after it."""
        assert self._due is not None
        # The shortest interval, since timestamps jitter and states are lost.
        due_with_state = self._stamp + min(self._intervals) <= self._due + _EARLY_TOLERANCE * self._step
        return _LATE_TOLERANCE * self._step if due_with_state else 0.0

    def _act_until(self, stamp: int, tolerance: float, now: float) -> JointCommand | None:
        """Perform the control ticks that are due at a timestamp, up to `tolerance` later (ns); the last one's command.

        Each advances the clock and the observation history by one step.
        """
        if self._due is None or stamp > self._due + _MAX_LATE * self._step:
            self._due = stamp
        command = None
        while self._due <= stamp + tolerance and self.mode in (Mode.RAMPING, Mode.WALKING):
            self._due += self._step
            command = self._act(now)
        return command

    def _qualify(self, measurement: Measurement, now: float) -> None:
        if self._fresh == 0:
            self._rest, self._rest_stamp = measurement.positions, measurement.stamp
        self._fresh += 1
        if not self._upright:
            tilt = math.degrees(math.acos(max(-1.0, float(self._readings.up_b[0, 2]))))
            self._obstacle = f"an upright robot: tilted by {tilt:.0f} degrees"
            self._fresh, self._upright_since = 0, None
            return
        if self._upright_since is None:
            self._upright_since = measurement.stamp
        # After a fall a person puts the robot back on its feet: do not move it before its legs are at rest.
        upright_for = (measurement.stamp - self._upright_since) / NS_PER_SECOND
        sinking = not self._fallen and upright_for > self.safety.sinking_after
        tolerance = self.safety.sinking_tolerance if sinking else self.safety.rest_tolerance
        moved = np.abs(measurement.positions - self._rest)
        if moved.max() > tolerance:
            joint = int(moved.argmax())
            speed = moved[joint] * NS_PER_SECOND / (measurement.stamp - self._rest_stamp)
            self._obstacle = f"a robot at rest: {self.robot.joint_names[joint]} moves at {speed:.1f} rad/s"
            self._fresh = 0
        if self._fresh < self.safety.fresh_states:
            return
        # Clipped, because the duration of a ramp from far outside the joints' ranges would be unbounded.
        self._last = np.clip(measurement.positions, self.robot.joint_position_low, self.robot.joint_position_high)
        self._stand_up = StandUp.plan(self.robot, self._last, self.safety.ramp_speed, self.safety.min_ramp_time)
        self._stand_up_time, self._due = -self.period, None
        self._fallen = False
        self._enter(Mode.RAMPING, f"{self._stand_up.duration:.1f} s")

    def _act(self, now: float) -> JointCommand:
        if self.mode is Mode.RAMPING:
            target = self._ramp()
        else:
            before = self._control.memory.get_state(0)
            self._follow(self._command if self.moving(now) else np.zeros(len(self._commands)))
            self._control.approach_requested()
            observation = self._control.observe(self._readings)
            self._control.advance()
            try:
                target = self._controller.act(observation, self._control)[0]
                if not self._gate.passes(target, now):
                    # Otherwise NaN would stay in the last action and in the observation history.
                    self._control.memory.set_state(0, before)
                    target = self._last
            except QuadrupedError as error:
                return self.fail(str(error))
        self._last = limited(self.robot, target, self._last, self.period)
        return JointCommand(self._stamp, self._last)

    def _follow(self, velocity: Floats) -> None:
        """Set a velocity command (V,), in m/s and rad/s, if it has changed."""
        if not np.array_equal(velocity, self._control.requested[0]):
            command = np.concatenate([velocity, self._defaults[len(velocity) :]])
            self._control.set_command(_ENV_IDS, command[None])

    def _check_measured(self, measurement: Measurement) -> None:
        """Refuse values that are not finite, or too large: NaN would reach the observation history."""
        _, positions, velocities, orientation, angular_velocity = measurement
        for one in (positions, orientation, angular_velocity, *[velocities] * self.needs_velocities):
            if not (np.abs(one) <= MAX_MEASURED).all():
                raise QuadrupedError(
                    f"the measurement holds {one.tolist()}; expected finite numbers of at most {MAX_MEASURED:g} rad "
                    f"and rad/s: check the driver, and --map"
                )

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

    def _observes_velocities(self) -> bool:
        velocities = self._readings.joint_velocity
        known = velocities.copy()
        velocities[:] = np.nan
        observed = self._control.observe(self._readings)
        velocities[:] = known
        return bool(np.isnan(observed).any())

    def _check_observation(self) -> None:
        observation = self._control.observe(self._readings)[0]
        for name, columns in self._control.layout.slices.items():
            if not np.isfinite(observation[columns]).all():
                raise QuadrupedError(
                    f"policy: it observes {name}, which the robot does not measure: it measures joint positions and "
                    f"velocities, attitude and angular velocity; train a policy without {name}"
                )

    def _ramp(self) -> Floats:
        self._stand_up_time += self.period
        if self._stand_up_time >= self._stand_up.duration + self.safety.settle - _ROUNDING:
            self._control.reset(_ENV_IDS)
            self._follow(np.zeros(len(self._commands)))
            self._enter(Mode.WALKING, "")
        return self._stand_up.positions(self._stand_up_time)

    @property
    def _moving(self) -> bool:
        """True if joint targets are being sent."""
        return self.mode in (Mode.RAMPING, Mode.WALKING, Mode.HOLDING)

    def _time_out(self) -> JointCommand:
        self._go_limp(f"no state for {self.safety.limp_after:g} s")
        return JointCommand(self._stamp, LIMP)

    def _on_lag_changed(self, change: float) -> None:
        """The expected lag of the states changed: earlier states no longer count."""
        self._reset_count()
        if change > 0.0:
            self._say(f"all states arrive {change:.2f} s later than before; this lag is now taken as normal")

    def _go_limp(self, why: str) -> None:
        self._enter(Mode.LIMP, why)
        self._reset_qualification()

    def _reset_qualification(self) -> None:
        self._timestamps.reset()
        self._reset_count()

    def _reset_count(self) -> None:
        """Discard the count of fresh states: earlier states no longer tell whether the robot may be moved."""
        self._fresh, self._upright_since = 0, None

    def _enter(self, mode: Mode, why: str) -> None:
        self.mode = mode
        self._obstacle = ""
        self._say(f"{mode.value}{f' ({why})' if why else ''}")
