"""The robots of a show: their sources, their ground and their randomization."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from operator import methodcaller
from typing import Final

import mujoco

from quadruped_env.errors import QuadrupedError
from quadruped_env.policies import ControllerSpec
from quadruped_env.report.films.film import size_of
from quadruped_env.robot import Robot
from quadruped_env.simulation import Terrain
from quadruped_env.simulation.built_in_terrains import find_terrain, terrain_scale
from quadruped_env.task import PRESETS, CommandConfig, CommandSection, TaskConfig
from quadruped_env.viewer.viewed_robot import TaskRobot, ViewedRobot

MAX_ROBOTS: Final = 3
LANE: Final = 0.6
"""Distance between robots of size 1 next to each other, m."""
START: Final = "start"
RANDOMIZATIONS: Final[dict[str, Callable[[TaskConfig], TaskConfig]]] = {
    "off": TaskConfig.without_randomization,
    **{START if preset == "none" else preset: methodcaller("randomized", preset) for preset in PRESETS},
    "as trained": lambda config: config,
}
"""Name -> function that gives a source's task this randomization."""

Source = ControllerSpec | Callable[[], ViewedRobot]


@dataclass
class Slot:
    """A robot of a show."""

    robot: ViewedRobot
    clock: float
    """Playback time that the robot has simulated, s."""
    scratch: mujoco.MjData
    """Data for what is computed from a copy of the state."""


class ViewerRobots:
    """Robots side by side, with the arguments of `ViewController`, which locks them: they are not safe for threads.

    Raises:
        QuadrupedError: if a source is unknown or does not fit the robot, or there are too many.
    """

    def __init__(
        self,
        sources: Mapping[str, Source],
        chosen: Sequence[str],
        robot: Robot,
        terrain: Terrain | None,
        terrains: Sequence[Terrain],
    ) -> None:
        if not 1 <= len(chosen) <= MAX_ROBOTS:
            raise QuadrupedError(f"sources: expected 1 to {MAX_ROBOTS} robots; found {len(chosen)}")
        self.all_sources = sources
        self.robot = robot
        self.randomization = "off"
        self.terrains = tuple(terrains)
        self._terrain = terrain
        self.slots: list[Slot] = []
        for index, name in enumerate(chosen):
            self.slots.append(self.slot(index, self.make(name)))

    @property
    def sources(self) -> tuple[str, ...]:
        """The name of each robot's source."""
        return tuple(slot.robot.name for slot in self.slots)

    @property
    def names(self) -> tuple[str, ...]:
        """The name of each robot: its source's, with a number if an earlier robot has the same source."""
        sources = self.sources
        counts = [sources[: i + 1].count(name) for i, name in enumerate(sources)]
        return tuple(name if n == 1 else f"{name} ({n})" for name, n in zip(sources, counts, strict=True))

    @property
    def terrain(self) -> Terrain:
        """The ground of the robots."""
        return self.slots[0].robot.terrain

    @property
    def command_ranges(self) -> CommandSection:
        """The widest ranges of the velocity command, of the default task and those of the robots."""
        own = [slot.robot.task.config.command for slot in self.slots if isinstance(slot.robot, TaskRobot)]
        tasks = [CommandConfig(), *own]
        forward, turn = (
            tuple(end(getattr(task, name)[i] for task in tasks) for i, end in enumerate((min, max)))
            for name in ("forward_velocity", "yaw_rate")
        )
        return CommandConfig(forward_velocity=forward, yaw_rate=turn)

    @property
    def follows_command(self) -> bool:
        """True if the velocity command has an effect on one of the robots."""
        return any(slot.robot.follows_command for slot in self.slots)

    def make(self, name: str) -> ViewedRobot:
        """A new robot of a source, on the ground and with the randomization of the others."""
        if name not in self.all_sources:
            raise QuadrupedError(f"source: there is no {name!r}; there are {', '.join(self.all_sources)}")
        source = self.all_sources[name]
        if not isinstance(source, ControllerSpec):
            return source()
        robot = TaskRobot(source, RANDOMIZATIONS[self.randomization], self.robot, self._terrain)
        self._terrain = robot.terrain
        return robot

    def slot(self, index: int, robot: ViewedRobot, clock: float = 0.0) -> Slot:
        """The slot of a robot at an index, for which a lane is chosen that no other robot has."""
        if isinstance(robot, TaskRobot):
            others = [slot.robot for slot in self.slots[:index] + self.slots[index + 1 :]]
            taken = [other.lane for other in others if isinstance(other, TaskRobot)]
            lanes = (LANE * size_of(self.robot) * side for side in (0.0, 1.0, -1.0))
            robot.lane = next(lane for lane in lanes if lane not in taken)
            robot.reset(0, (0.0, 0.0))
        return Slot(robot, clock, mujoco.MjData(robot.model))

    def check_place(self, index: int, remove: bool) -> None:
        """Raise a QuadrupedError if no robot can be put at an index, or removed from there."""
        last = min(len(self.slots), MAX_ROBOTS - 1)
        if not 0 <= index <= last:
            raise QuadrupedError(
                f"robots: there are {len(self.slots)} of up to {MAX_ROBOTS}; expected an index of 0 to {last}, "
                f"found {index}"
            )
        if remove and not index:
            raise QuadrupedError(f"{self.names[0]}: the first robot cannot be removed; choose another source for it")

    def randomized(self, name: str) -> list[Slot]:
        """New robots of the same sources with another of `RANDOMIZATIONS`; a QuadrupedError if there is no such one."""
        if name not in RANDOMIZATIONS:
            raise QuadrupedError(f"randomization: there is no {name!r}; there are {', '.join(RANDOMIZATIONS)}")
        return self._made_with("randomization", name)

    def on_terrain(self, name: str, level: int | None) -> list[Slot]:
        """New robots of the same sources on another ground; a QuadrupedError if there is no such terrain or level."""
        terrain = find_terrain(name, self.terrains)
        terrain = terrain.variant(self.terrain.seed, level, terrain_scale(terrain, self.robot))
        return self._made_with("_terrain", terrain)

    def _made_with(self, attribute: str, value: object) -> list[Slot]:
        before = getattr(self, attribute)
        setattr(self, attribute, value)
        try:
            return [self.slot(index, self.make(source)) for index, source in enumerate(self.sources)]
        except QuadrupedError:
            setattr(self, attribute, before)
            raise
