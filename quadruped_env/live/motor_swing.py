"""Moves one motor of a hanging robot out and back, while the others hold their positions."""

import math
import time
from collections import deque
from collections.abc import Callable
from typing import Final, NamedTuple

import numpy as np

from quadruped_env.control.joint_command import MAX_MEASURED
from quadruped_env.control.live_controller import Safety
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.command_publisher import CommandPublisher
from quadruped_env.live.emergency_stop import EmergencyStop
from quadruped_env.live.messages.joint_messages import JointMerger, JointReader
from quadruped_env.live.middleware.topics import JOINT_STATES
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session
from quadruped_env.ros import Qos
from quadruped_env.utils.arrays import Floats

PERIOD: Final = 0.02
"""Time between commands, s."""
ANGLE: Final = 0.15
"""Amplitude of a swing, rad."""
SPEED: Final = 0.3
"""Peak speed of a swing, rad/s."""
_PAUSES: Final = 0.5, 1.0
"""Time at the end of a swing and at its start, s."""
_SWING_TIME: Final = 1.5 * ANGLE / SPEED
"""Time of the way out, of which the peak speed is 1.5 times the mean, s."""
_MAX_ERROR: Final = 1.5
"""Distance of a motor from its target, in amplitudes of the swing, above which the robot goes limp."""
_QOS: Final = Qos(depth=50, reliable=False)


class Motors(NamedTuple):
    """Motors as the driver names them."""

    joint_names: tuple[str, ...]
    unit: float
    """Unit of their positions, rad."""

    @property
    def limits(self) -> dict[str, float]:
        """Largest accepted positions, in the motors' unit; their velocities are not used."""
        return {"position": MAX_MEASURED / self.unit, "velocity": math.inf}


class MotorSwing:
    """Swings the motors of one robot. It goes limp at the end of each swing, and when something is wrong.

    Args:
        motors: the motors (D,).
    """

    def __init__(self, session: Session, motors: Motors) -> None:
        self._states = session.node.subscribe(JOINT_STATES, _QOS, read=JointReader(motors, states=True))
        self._merger = JointMerger(motors, velocities=False)
        self._publisher = CommandPublisher(session, motors)
        self._stops = EmergencyStop(session)
        session.every_turn.append(self._take)
        self._session, self._motors = session, motors
        self._recent: deque[Floats] = deque(maxlen=Safety.fresh_states)
        """The last positions (D,), in the motors' unit."""
        self._stamp = 0
        self._heard = -math.inf

    def _take(self) -> None:
        for received, joints in self._states.messages(self._session.refuse):
            state = self._merger.add(joints)
            if state is not None and state.positions is not None:
                if received.taken - self._heard > Safety.hold_after:
                    self._recent.clear()
                self._recent.append(state.positions)
                self._stamp, self._heard = state.stamp, received.taken

    def positions(self) -> Floats:
        """Return the mean of the last positions (D,), in the motors' unit, once they are fresh and the motors at rest.

        Raises:
            QuadrupedError: if the session ends.
        """
        for _ in self._session.turns():
            missing = self._missing()
            self._session.wait_for(missing)
            if not missing:
                return np.mean(self._recent, axis=0)
        raise QuadrupedError("ended before the motors were at rest; nothing more was moved")

    def _missing(self) -> str:
        """Return the condition that is missing before a motor is moved; empty if there is none."""
        if self._stops.stopped:
            return f"the release of the emergency stop ({self._stops.name})"
        if time.monotonic() - self._heard > Safety.hold_after or len(self._recent) < Safety.fresh_states:
            return self._merger.missing or f"fresh states on {JOINT_STATES.name}"
        spans = np.ptp(self._recent, axis=0) * self._motors.unit
        worst = int(spans.argmax())
        if spans[worst] > Safety.rest_tolerance:
            return f"motors at rest: {self._motors.joint_names[worst]} moved by {spans[worst]:.2f} rad"
        return ""

    def swing(self, motor: int, direction: float, stop: Callable[[], bool]) -> str:
        """Move a motor out and back again and again until `stop`, then let the robot go limp.

        Args:
            motor: its index.
            direction: 1 or -1, of the way out.
            stop: called at every step.

        Returns:
            Reason if it ended for another one than `stop`, otherwise an empty string.
        """
        start = target = self.positions()
        elapsed, pace, before = 0.0, Pace(PERIOD), time.monotonic()
        watched = _SWING_TIME + 0.5 * _PAUSES[0]
        try:
            for _ in self._session.turns(lambda: pace.remaining):
                now = time.monotonic()
                if stop():
                    return ""
                if reason := self._danger(now, now - before, target):
                    return reason
                if not pace.tick():
                    continue
                # Without states it holds, as the controller does.
                step = min(now - before, 2.0 * PERIOD) if now - self._heard <= Safety.hold_after else 0.0
                if elapsed < watched <= elapsed + step:
                    self._report(motor, start)
                elapsed, before = elapsed + step, now
                target = start.copy()
                target[motor] += direction * self._offset(elapsed)
                self._publisher.send(self._stamp, target)
        except QuadrupedError as error:
            return str(error)
        finally:
            self._publisher.let_go()
        return "the session ended"

    def _offset(self, elapsed: float) -> float:
        """Return the distance from the start, in the motors' unit, at a time in s."""
        out = _SWING_TIME
        at = elapsed % (2.0 * out + sum(_PAUSES))
        share = min(at / out, 1.0, max(0.0, (2.0 * out + _PAUSES[0] - at) / out))
        return ANGLE / self._motors.unit * share * share * (3.0 - 2.0 * share)

    def _danger(self, now: float, since: float, target: Floats) -> str:
        """Return why the robot must not be moved, or an empty text. `since`: time since the last command, s."""
        if self._stops.stopped:
            return f"emergency stop ({self._stops.name})"
        if max(now - self._heard, since) > Safety.limp_after:
            return f"no state for {Safety.limp_after:g} s"
        errors = np.abs(self._recent[-1] - target) * self._motors.unit
        worst = int(errors.argmax())
        if errors[worst] <= _MAX_ERROR * ANGLE:
            return ""
        return f"{self._motors.joint_names[worst]} is {errors[worst]:.2f} rad away from its target"

    def _report(self, motor: int, start: Floats) -> None:
        """Log motors that do not move as they should at the end of the way out."""
        moved = (self._recent[-1] - start) * self._motors.unit
        for index, name in enumerate(self._motors.joint_names):
            if (abs(moved[index]) > 0.5 * ANGLE) != (index == motor):
                self._session.say(
                    f"{name} moved by {moved[index]:.2f} rad; expected {ANGLE if index == motor else 0:g}: "
                    f"a stop in its way ('other' tries the other direction), no power, or another unit (--unit)?"
                )
