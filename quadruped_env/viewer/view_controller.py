"""The viewer's logic without the browser: robots, their command, a clock, and all user actions.

Every method may be called from any thread.
"""

import copy
import math
import threading
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

import mujoco

from quadruped_env.control.control_config import Command as Component
from quadruped_env.control.control_config import velocity_commands
from quadruped_env.control.steering import key_steps, next_step
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.conditions import Command, full_command
from quadruped_env.gait.gait_settings import GaitSettings
from quadruped_env.policies import ControllerSpec
from quadruped_env.report.films.film import size_of
from quadruped_env.robot import MINI_QUADRUPED, Robot
from quadruped_env.simulation import TERRAINS, Terrain
from quadruped_env.simulation.built_in_terrains import find_terrain, terrain_scale
from quadruped_env.simulation.push_limit import PushLimit
from quadruped_env.viewer.snapshot import View, robot_view
from quadruped_env.viewer.viewed_robot import LANE, RANDOMIZATIONS, Offered, TaskRobot, ViewedRobot
from quadruped_env.viewer.viewer_recording import MAX_SECONDS, RESULTS, RecordingSaver, ViewerRecording

SPEEDS: Final = (0.1, 4.0)
"""Range of the playback speed, as a multiple of real time."""
MAX_PUSH: Final = 1.5
"""Maximum velocity change by a push, m/s."""
MAX_ROBOTS: Final = 3
RESTART_AFTER: Final = 2.0
"""Time after a fall until the robot restarts, s."""
_MAX_LAG: Final = 0.25
"""Maximum playback time that is caught up after a delay, s; the rest is skipped."""

Source = ControllerSpec | Callable[[], ViewedRobot]


class ViewController:
    """Robots that follow the same velocity command.

    Args:
        sources: selectable sources by name: controllers of a simulated robot, or functions that create another kind of
            robot.
        chosen: names of the initial sources, one per robot.
        results: directory for recordings.
        robot: description of the robots.
        terrain: initial ground of all simulated robots; None: the ground of the first robot's task.
        terrains: terrains that can be chosen.

    Raises:
        QuadrupedError: if a source is unknown or does not fit the robot.
    """

    def __init__(
        self,
        sources: Mapping[str, Source],
        chosen: Sequence[str],
        results: Path = RESULTS,
        robot: Robot = MINI_QUADRUPED,
        terrain: Terrain | None = None,
        terrains: Sequence[Terrain] = TERRAINS,
    ) -> None:
        self.sources = sources
        self.robot = robot
        self.available = Offered()
        """Controls that have an effect on at least one kind of robot here, and readings that exist."""
        self.terrains = tuple(terrains)
        self._lock = threading.RLock()
        self._messages: deque[str] = deque(maxlen=20)
        self._saver = RecordingSaver(results, self._messages.append)
        self._time = self._budget = 0.0
        self._seed = 0
        self._paused = False
        self._speed = 1.0
        self._command: Command = full_command((), robot)
        self._push_limit = PushLimit("push")
        self._watched = 0
        self.restart_after_fall = True
        self._recording: ViewerRecording | None = None
        self._terrain, self._randomization = terrain, "off"
        self._robots: list[ViewedRobot] = []
        try:
            if not 1 <= len(chosen) <= MAX_ROBOTS:
                raise QuadrupedError(f"sources: expected 1 to {MAX_ROBOTS} robots; found {len(chosen)}")
            for name in chosen:
                self._robots.append(self._made(name, self._robots))
        except Exception:
            self._saver.close()
            raise
        self.command_ranges = self._widest_ranges()
        """Of the robots at the start; one that is added later clips commands to its own."""

    # --- the robots

    @property
    def robots(self) -> tuple[str, ...]:
        """The name of each robot's source."""
        return tuple(robot.name for robot in self._robots)

    @property
    def names(self) -> tuple[str, ...]:
        """The name of each robot: its source's, with a number if an earlier robot has the same source."""
        sources = self.robots
        counts = [sources[: i + 1].count(name) for i, name in enumerate(sources)]
        return tuple(name if n == 1 else f"{name} ({n})" for name, n in zip(sources, counts, strict=True))

    @property
    def offered(self) -> Offered:
        """The controls that have an effect on the current robots, and their readings."""
        follows = any(robot.follows_command for robot in self._robots)
        return replace(self.available, command=self.available.command and follows)

    def set_source(self, index: int, name: str | None) -> None:
        """Change the source of a robot and restart it; None removes the robot. The index after the last robot adds one.

        Raises:
            QuadrupedError: if there is no such robot or source, or it does not fit the robot. Nothing changes then.
        """
        with self._lock:
            last = min(len(self._robots), MAX_ROBOTS - 1)
            if not 0 <= index <= last:
                raise QuadrupedError(
                    f"robots: there are {len(self._robots)} of up to {MAX_ROBOTS}; expected an index of 0 to {last}, "
                    f"found {index}"
                )
            if name is None and not index:
                raise QuadrupedError(
                    f"{self.names[0]}: the first robot cannot be removed; choose another source for it"
                )
            others = self._robots[:index] + self._robots[index + 1 :]
            robot = None if name is None else self._made(name, others)
            if index == self._watched:
                self.stop_recording()
            if robot is None:
                del self._robots[index : index + 1]
                self.watch(min(self._watched, len(self._robots) - 1))
                return
            robot.clock = self._time
            robot.reset(self._seed, self._command)
            self._robots[index : index + 1] = [robot]

    def watch(self, index: int) -> None:
        """Select the robot for plots, camera, gait settings and recordings."""
        with self._lock:
            if not 0 <= index < len(self._robots):
                raise QuadrupedError(f"watch: expected an index of 0 to {len(self._robots) - 1}; found {index}")
            if index != self._watched:
                self.stop_recording()
            self._watched = index

    def set_gait(self, settings: GaitSettings) -> None:
        """Change the scripted gait of the watched robot; a QuadrupedError if it has none."""
        with self._lock:
            self._watched_robot.gait = settings

    @property
    def gait(self) -> GaitSettings | None:
        """The settings of the watched robot's scripted gait, or None."""
        with self._lock:
            return self._watched_robot.gait

    @property
    def randomization(self) -> str:
        """The randomization, a key of `viewed_robot.RANDOMIZATIONS`."""
        return self._randomization

    def set_randomization(self, name: str) -> None:
        """Choose the randomization, a key of `viewed_robot.RANDOMIZATIONS`, and restart all robots.

        Raises:
            QuadrupedError: if there is no such one, or a robot cannot have it. Nothing changes then.
        """
        if name not in RANDOMIZATIONS:
            raise QuadrupedError(f"randomization: there is no {name!r}; there are {', '.join(RANDOMIZATIONS)}")
        with self._lock:
            self._make_all_again("_randomization", name)

    @property
    def terrain(self) -> Terrain:
        """The ground of the robots."""
        return self._robots[0].terrain

    def set_terrain(self, name: str, level: int | None = None) -> None:
        """Choose the ground of all simulated robots by its name and level (None: its default shape), and restart them.

        Raises:
            QuadrupedError: if there is no such terrain or level. Nothing changes then.
        """
        with self._lock:
            terrain = find_terrain(name, self.terrains)
            terrain = terrain.variant(self.terrain.seed, level, terrain_scale(terrain, self.robot))
            self._make_all_again("_terrain", terrain)

    # --- the command and the clock

    @property
    def command(self) -> Command:
        """Velocity command of all robots: a number for each of the `velocity_commands`, m/s and rad/s."""
        return self._command

    def set_command(self, *command: float) -> Command:
        """Set the velocity command of all robots, m/s and rad/s, clipped to its ranges; what is left out is 0.

        Raises:
            QuadrupedError: if a number is not finite.
        """
        if not all(map(math.isfinite, command)):
            raise QuadrupedError(f"command: expected finite numbers; found {' and '.join(map(str, command))}")
        wanted = full_command(command, self.robot)
        with self._lock:
            self._command = tuple(_cut(v, entry.range) for v, entry in zip(wanted, self.command_ranges, strict=True))
            for robot in self._robots:
                robot.set_command(self._command)
            return self._command

    def nudge(self, *steps: int) -> Command:
        """Change each velocity by a number of steps, like a key press; the result is a multiple of the step."""
        with self._lock:
            changes = zip(self._command, key_steps(self.robot), full_command(steps, self.robot), strict=True)
            return self.set_command(*(next_step(v, size, int(count)) for v, size, count in changes))

    def set_speed(self, speed: float) -> None:
        """Set the playback speed, as a multiple of real time."""
        with self._lock:
            self._speed = _cut(speed, SPEEDS)

    @property
    def paused(self) -> bool:
        """True if playback is paused."""
        return self._paused

    @paused.setter
    def paused(self, paused: bool) -> None:
        with self._lock:
            self._paused = bool(paused)
            self._budget = 0.0

    def toggle_pause(self) -> bool:
        """Pause or resume playback. Returns True if it is now paused."""
        with self._lock:
            self.paused = not self.paused
            return self.paused

    def reset(self) -> None:
        """Reset all robots and the clock."""
        with self._lock:
            self.stop_recording()
            self._seed += 1
            self._push_limit = PushLimit("push")
            self._time = self._budget = 0.0
            for robot in self._robots:
                robot.reset(self._seed, self._command)
                robot.clock = 0.0

    def step(self) -> None:
        """Advance by one control step and pause."""
        with self._lock:
            self.paused = True
            self._tick()

    def advance(self, elapsed: float) -> int:
        """Advance playback by the real time since the last call, s. Returns the number of control steps."""
        with self._lock:
            if self._paused:
                return 0
            self._budget += elapsed * self._speed
            self._budget = min(self._budget, _MAX_LAG * max(1.0, self._speed))
            steps = int(self._budget / self._timestep + 1e-9)
            self._budget -= steps * self._timestep
            for _ in range(steps):
                self._tick()
            return steps

    def push(self, direction: float, strength: float) -> None:
        """Push all robots by up to `MAX_PUSH` m/s, in a direction relative to the heading (rad, positive to the left).

        Raises:
            QuadrupedError: if it is too large together with other pushes, see `PushLimit`.
        """
        velocity = _vector(direction, _cut(strength, (0.0, MAX_PUSH)))
        with self._lock:
            self._push_limit.check(velocity, self._time)
            for robot in self._robots:
                robot.push(velocity)

    # --- recordings

    def start_recording(self) -> None:
        """Start recording the watched robot, unless there is a recording."""
        with self._lock:
            if self._recording is None:
                robot = self._watched_robot
                follows_command = robot.follows_command and self.available.command
                name, motion = self.names[self._watched], self.available.motion
                self._recording = ViewerRecording(name, [robot.history[-1]], follows_command, motion)

    def stop_recording(self) -> None:
        """End the current recording, if any, and save it in the background."""
        with self._lock:
            recording, self._recording = self._recording, None
            if recording is not None:
                self._saver.save(recording)

    @property
    def saving(self) -> bool:
        """True during a recording and until it is saved."""
        return self._recording is not None or self._saver.busy

    def messages(self) -> list[str]:
        """Return messages for the user since the last call."""
        return [self._messages.popleft() for _ in range(len(self._messages))]

    def close(self) -> None:
        """End the recording and wait until it is saved."""
        self.stop_recording()
        self._saver.close()

    # --- snapshots

    def view(self) -> View:
        """Return a snapshot of everything that is drawn."""
        with self._lock:
            return View(
                self._time,
                self.paused,
                self._speed,
                tuple(robot_view(robot, name) for robot, name in zip(self._robots, self.names, strict=True)),
                self.terrain,
                self._watched,
                None if self._recording is None else self._recording.seconds,
                self.offered,
            )

    def model(self) -> mujoco.MjModel:
        """Return a copy of the robots' MuJoCo model."""
        with self._lock:
            return copy.copy(self._robots[0].model)

    # --- inside

    def _made(self, name: str, others: Sequence[ViewedRobot]) -> ViewedRobot:
        """Return a new robot of a source, on the ground of the others and in a lane that none of them has."""
        if name not in self.sources:
            raise QuadrupedError(f"source: there is no {name!r}; there are {', '.join(self.sources)}")
        source = self.sources[name]
        if not isinstance(source, ControllerSpec):
            return source()
        lanes = (LANE * size_of(self.robot) * side for side in (0.0, 1.0, -1.0))
        lane = next(lane for lane in lanes if lane not in [other.lane for other in others])
        robot = TaskRobot(source, RANDOMIZATIONS[self._randomization], self.robot, self._terrain, lane)
        self._terrain = robot.terrain
        return robot

    def _make_all_again(self, attribute: str, value: object) -> None:
        """Replace all robots by new ones of their sources, with another value of an attribute of this controller."""
        before, made = getattr(self, attribute), list[ViewedRobot]()
        setattr(self, attribute, value)
        try:
            for name in self.robots:
                made.append(self._made(name, made))
        except QuadrupedError:
            setattr(self, attribute, before)
            raise
        self._robots = made
        self.reset()

    def _widest_ranges(self) -> tuple[Component, ...]:
        """Return the velocity command with its widest ranges, of the robot's default task and of the robots' tasks.

        They are whole hundredths, so that sliders with steps of 0.01 show such numbers, and reach 0.
        """
        entries = velocity_commands(self.robot)
        ranges = [[entry.range for entry in entries]]
        ranges += [
            [entry.range for entry in robot.task.config.commands]
            for robot in self._robots
            if isinstance(robot, TaskRobot)
        ]
        return tuple(
            replace(entry, range=(_hundredths(min(low for low, _ in own)), _hundredths(max(high for _, high in own))))
            for entry, own in zip(entries, zip(*ranges, strict=False), strict=False)
        )

    @property
    def _watched_robot(self) -> ViewedRobot:
        return self._robots[self._watched]

    @property
    def _timestep(self) -> float:
        return self._robots[0].timestep

    def _tick(self) -> None:
        self._time += self._timestep
        for index, robot in enumerate(self._robots):
            while robot.clock + robot.timestep <= self._time + 1e-9:
                robot.clock += robot.timestep
                self._step(index, robot)

    def _step(self, index: int, robot: ViewedRobot) -> None:
        moment = robot.step()
        if index == self._watched and self._recording is not None:
            self._recording.samples.append(moment)
            if self._recording.seconds >= MAX_SECONDS:
                self._messages.append(f"The recording has ended: the maximum is {MAX_SECONDS:g} s; record again")
                self.stop_recording()
        fallen_for = 0.0 if robot.fell_at is None else float(moment.time) - robot.fell_at
        if robot.diverged or (self.restart_after_fall and fallen_for >= RESTART_AFTER):
            if index == self._watched:
                self.stop_recording()
            robot.reset(self._seed, self._command)


def _vector(direction: float, length: float) -> tuple[float, float]:
    """Return the vector (forwards, left) of a length in a direction, rad, positive to the left."""
    return length * math.cos(direction), length * math.sin(direction)


def _hundredths(value: float) -> float:
    """Return a value rounded towards zero to a multiple of 0.01."""
    return math.trunc(round(100.0 * value, 6)) / 100.0


def _cut(value: float, bounds: tuple[float, float]) -> float:
    return min(max(float(value), bounds[0]), bounds[1])
