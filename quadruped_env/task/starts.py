"""How episodes begin: initial states, gait phases, commands, and the times of the first events."""

import math
from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env import rotations
from quadruped_env.arrays import NUMPY
from quadruped_env.control.config import Range
from quadruped_env.simulation import Simulation, highest_ground
from quadruped_env.task.commands import CommandSampler
from quadruped_env.task.draws import Draws, Keys, Purposes, uniform
from quadruped_env.task.event import Event
from quadruped_env.task.randomization import Active, between
from quadruped_env.task.sensors import Sensors

Floats = NDArray[np.float64]
EnvIds = NDArray[np.intp]

_CLEARANCE: Final = 0.01
"""Height of the stance above the ground below it at the start, so that randomized legs do not penetrate it, m."""


class Start(NamedTuple):
    """How the episodes of some envs (R,) begin."""

    qpos: Floats
    """Base pose and joint positions in MuJoCo's order, (R, 7 + J)."""
    qvel: Floats
    """Base and joint velocities in MuJoCo's order, (R, 6 + J)."""
    phase: Floats
    """Phase of the gait clock (R,), rad."""
    command: Floats
    """Command (R, C)."""
    waits: Floats
    """Time until each recurring randomization applies, and last until the next command, (R, number of those + 1), s."""


class Starts:
    """Draws how the episodes of N envs begin.

    NumPy draws for many envs in little more time than for one. So the starts of the next episodes are drawn ahead, if
    every randomization of a start is pure and all episodes begin at the origin.

    Args:
        simulation: simulation of N robots.
        draws: source of random numbers.
        commands: samples the commands.
        randomizations: randomizations of a start, in the order in which they apply.
        intervals: range of the time between two applications of each recurring randomization, by its name, s.
        sensors: errors of the sensors; None if they have none.
        at_origin: True if all episodes begin at the origin.
    """

    def __init__(
        self,
        simulation: Simulation,
        draws: Draws,
        commands: CommandSampler,
        randomizations: Sequence[Active],
        intervals: dict[str, Range],
        sensors: Sensors | None,
        at_origin: bool,
    ) -> None:
        self._simulation, self._draws, self._sensors = simulation, draws, sensors
        self._commands, self._randomizations, self._intervals = commands, randomizations, intervals
        robot, n = simulation.robot, simulation.num_envs
        own = Purposes({r.name: r.randomization.draws(robot) for r in randomizations})
        times = Purposes({"phase": 1, **{f"{name}/interval": 1 for name in intervals}})
        self._purposes = own + times + commands.purposes
        columns = self._purposes.slices
        self._command_columns = slice(columns["command/kind"].start, columns["command/interval"].stop)
        moved = {"start_joint_position", "start_tilt"}
        self._height = robot.stance_height + (_CLEARANCE if any(r.name in moved for r in randomizations) else 0.0)
        pure = all(r.randomization.pure for r in randomizations)
        self._are_ahead = pure and at_origin and n > 1 and simulation.xp is NUMPY
        self._next: Start | None = None
        """Starts of all envs that were drawn ahead."""
        self._next_key: Keys = np.zeros(n, np.uint64)
        """Key of the episode for which each of them was drawn, (N,)."""

    @property
    def straight_only(self) -> bool:
        """See `CommandSampler`."""
        return self._commands.straight_only

    @straight_only.setter
    def straight_only(self, straight_only: bool) -> None:
        self._commands.straight_only = straight_only
        self._next_key[:] = 0

    def of(self, env_ids: EnvIds, place: Floats | None = None) -> Start:
        """Starts of the present episodes of some envs (R,).

        Args:
            env_ids: indices of the envs.
            place: position (R, 2) of each start, m; None: the origin.
        """
        key = self._draws.episode_key
        if not self._are_ahead:
            return self._drawn(env_ids, key[env_ids], place)
        if (self._next_key[env_ids] != key[env_ids]).any():
            self._draw_ahead(env_ids)
        assert self._next is not None
        return Start(*(values[env_ids] for values in self._next))

    def _draw_ahead(self, env_ids: EnvIds) -> None:
        """Draw the starts of the present episodes of some envs, and of the next episodes of all others."""
        keys = self._draws.next_episode_key()
        keys[env_ids] = self._draws.episode_key[env_ids]
        missing = np.flatnonzero(keys != self._next_key)
        drawn = self._drawn(missing, keys[missing])
        if self._next is None:
            self._next = Start(*(np.empty((len(keys), *values.shape[1:])) for values in drawn))
        for values, new in zip(self._next, drawn, strict=True):
            values[missing] = new
        self._next_key[:] = keys

    def _drawn(self, env_ids: EnvIds, keys: Keys, place: Floats | None = None) -> Start:
        """Starts of some envs (R,), for the episodes with these keys (R,)."""
        xp, robot, rows = self._simulation.xp, self._simulation.robot, len(env_ids)
        draws = uniform(self._purposes, keys, xp.zeros(rows, np.int64))
        event = Event(
            self._simulation,
            robot,
            env_ids,
            qpos=xp.zeros((rows, robot.num_positions)),
            qvel=xp.zeros((rows, robot.num_velocities)),
            tilt=xp.zeros((rows, 3)),
            sensors=self._sensors,
        )
        event.qpos[:, 2] = self._height
        event.qpos[:, 7:] = robot.stance
        if place is not None:
            event.qpos[:, :2] = place
        columns = self._purposes.slices
        for randomization in self._randomizations:
            randomization.carry_out(event, draws[:, columns[randomization.name]])
        event.qpos[:, 2] += highest_ground(self._simulation, event.qpos[:, :2])
        event.qpos[:, 3:7] = rotations.from_roll_pitch_yaw(event.tilt)
        command, until_next = self._commands.sample(draws[:, self._command_columns])
        waits = xp.zeros((rows, len(self._intervals) + 1))
        for i, (name, interval) in enumerate(self._intervals.items()):
            waits[:, i] = between(interval, draws[:, columns[f"{name}/interval"].start])
        waits[:, -1] = until_next
        return Start(event.qpos, event.qvel, math.tau * draws[:, columns["phase"].start], command, waits)
