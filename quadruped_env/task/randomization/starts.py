"""Starts of episodes: initial states, gait phases, commands, and the times of the first events."""

import math
from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.units import scale_of
from quadruped_env.simulation import Simulation, highest_ground
from quadruped_env.task.command_sampling import CommandSampler
from quadruped_env.task.randomization.draws import Draws, Purposes
from quadruped_env.task.randomization.event import Event
from quadruped_env.task.randomization.randomization import Active, between, in_steps
from quadruped_env.task.randomization.sensor_errors import Sensors
from quadruped_env.task.randomization.servo_errors import ServoErrors
from quadruped_env.utils import rotations
from quadruped_env.utils.fields import Range

Floats = NDArray[np.float64]
EnvIds = NDArray[np.intp]

_CLEARANCE: Final = 0.01
"""Height of the stance above the ground below it at the start, so that randomized legs do not penetrate it; of the
built-in robot, m."""


class Start(NamedTuple):
    """Starts of the episodes of some envs (R,)."""

    qpos: Floats
    """Base pose and joint positions in MuJoCo's order, (R, 7 + J)."""
    qvel: Floats
    """Base and joint velocities in MuJoCo's order, (R, 6 + J)."""
    phase: Floats
    """Phase of the gait clock (R,), rad."""
    command: Floats
    """Command (R, C)."""
    waits: NDArray[np.int64]
    """Control steps until each recurring randomization applies, and last until the next command, (R, number of those +
    1)."""


class Starts:
    """Draws the starts of N envs' episodes.

    Args:
        simulation: simulation of N robots.
        draws: source of random numbers.
        commands: samples the commands.
        randomizations: randomizations of a start, in the order in which they apply.
        intervals: range of the time between two applications of each recurring randomization, by its name, s.
        sensors: errors of the sensors; None if they have none.
        servos: errors of the servos; None if they have none.
        timestep: control step, s.
    """

    def __init__(
        self,
        simulation: Simulation,
        draws: Draws,
        commands: CommandSampler,
        randomizations: Sequence[Active],
        intervals: dict[str, Range],
        sensors: Sensors | None,
        servos: ServoErrors | None,
        timestep: float,
    ) -> None:
        self._simulation, self._draws, self._sensors, self._servos = simulation, draws, sensors, servos
        self._commands, self._randomizations, self._intervals = commands, randomizations, list(intervals.values())
        self._timestep = timestep
        robot = simulation.robot
        own = {r.name: r.randomization.draws(robot) for r in randomizations}
        times = {"phase": 1, **{f"{name}/interval": 1 for name in intervals}}
        self._purposes = Purposes({**own, **times, **commands.purposes.widths})
        columns = self._purposes.slices
        self._columns = [columns[r.name] for r in randomizations]
        self._phase_column = columns["phase"].start
        self._interval_columns = [columns[f"{name}/interval"].start for name in intervals]
        self._command_columns = slice(columns["command/kind"].start, columns["command/interval"].stop)
        moved = {"start_joint_position", "start_tilt"}
        self._height = robot.stance_height + (
            _CLEARANCE * scale_of("m", robot) if any(r.name in moved for r in randomizations) else 0.0
        )

    def of(self, env_ids: EnvIds, place: Floats | None = None) -> Start:
        """Starts of the present episodes of some envs (R,).

        Args:
            env_ids: indices of the envs.
            place: position (R, 2) of each start, m; None: the origin.
        """
        robot, rows = self._simulation.robot, len(env_ids)
        draws = self._draws.uniform(self._purposes, env_ids, np.zeros_like(env_ids))
        event = Event(
            self._simulation,
            robot,
            env_ids,
            qpos=np.zeros((rows, robot.num_positions)),
            qvel=np.zeros((rows, robot.num_velocities)),
            tilt=np.zeros((rows, 3)),
            sensors=self._sensors,
            servos=self._servos,
        )
        event.qpos[:, 2] = self._height
        event.qpos[:, 7:] = robot.stance
        if place is not None:
            event.qpos[:, :2] = place
        for randomization, columns in zip(self._randomizations, self._columns, strict=True):
            randomization.apply(event, randomization.values(draws[:, columns]))
        event.qpos[:, 2] += highest_ground(self._simulation, event.qpos[:, :2])
        event.qpos[:, 3:7] = rotations.from_roll_pitch_yaw(event.tilt)
        command, until_next = self._commands.sample(draws[:, self._command_columns])
        waits = np.zeros((rows, len(self._intervals) + 1))
        for i, (interval, column) in enumerate(zip(self._intervals, self._interval_columns, strict=True)):
            waits[:, i] = between(interval, draws[:, column])
        waits[:, -1] = until_next
        phase = math.tau * draws[:, self._phase_column]
        return Start(event.qpos, event.qvel, phase, command, in_steps(waits, self._timestep))
