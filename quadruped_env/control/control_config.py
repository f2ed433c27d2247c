"""Configuration that training and a real robot share: action scaling, control rate and commands."""

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated, Final, Literal, Self

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.gait import CLOCK_FREQUENCY, SINUSOID, CommandedGait
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of, scaled
from quadruped_env.utils.fields import Fields, Range, converted, hints_of, with_values
from quadruped_env.utils.parameters import Parameter
from quadruped_env.utils.plain import Plain

ACTION_MODES: Final = ("position", "residual")


@dataclass(frozen=True)
class ActionConfig(Fields, path="config.action"):
    """Conversion of an action to joint targets."""

    mode: Literal["position", "residual"] = "position"
    """`position`: relative to the stance. `residual`: relative to the scripted gait: a zero action is the gait."""
    position_scale: Annotated[float, Parameter.positive("rad")] = 0.6
    """Change of the joint target per unit of action in `position` mode, rad."""
    residual_scale: Annotated[float, Parameter.positive("rad")] = 0.4
    """Change of the joint target per unit of action in `residual` mode, rad."""
    gait: Literal["sinusoid", "tuned", "crouched", "low", "fast"] = "sinusoid"
    """Scripted gait of the `residual` mode: the trot in closed form, or one that a search found. `crouched` bends its
    legs further, the steps of `low` are low and quick, `fast` takes longer strides; they need gait clocks of their own
    frequencies, 3.6, 5 and 3.2 Hz."""

    @property
    def scale(self) -> float:
        """Change of the joint target per unit of action in the selected mode, rad."""
        return self.residual_scale if self.mode == "residual" else self.position_scale

    def scripted_gait(self, robot: Robot, clock: float) -> CommandedGait | None:
        """Gait to which the actions of a robot with a clock of a frequency in Hz are added; None in `position` mode."""
        if self.mode != "residual":
            return None
        return CommandedGait.preset(self.gait, robot, clock if self.gait == SINUSOID else None)


@dataclass(frozen=True)
class Command:
    """One component of the command."""

    name: str
    """Name of the component, and of its field in `config["command"]`, which holds the range."""
    unit: str
    range: Range
    """Valid range (low, high). Episodes draw the component uniformly from it, together with the velocity command."""
    default: float = 0.0
    """Value for a fixed command that leaves this component out."""

    def __post_init__(self) -> None:
        path = f"config.command.{self.name}"
        object.__setattr__(self, "range", converted(self.range, Range, path))
        object.__setattr__(self, "default", converted(self.default, float, path))


COMMANDS: Final = (
    Command("forward_velocity", "m/s", (-0.3, 0.6)),
    Command("yaw_rate", "rad/s", (-0.8, 0.8)),
)
"""The velocity command, which every task has."""
VELOCITIES: Final = (*COMMANDS, Command("lateral_velocity", "m/s", (-0.2, 0.2)))
"""The same, and the velocity to the left of robots that move sideways."""


def clock_frequency(robot: Robot) -> float:
    """Default frequency of a robot's gait clock, Hz."""
    return float(scaled(CLOCK_FREQUENCY, scale_of("Hz", robot)))


def commands_for(robot: Robot, commands: Sequence[Command]) -> tuple[Command, ...]:
    """Return a task's commands that a robot has; the ranges of the built-in ones follow its size."""
    return tuple(
        replace(entry, range=scaled(entry.range, scale_of(entry.unit, robot)))
        if any(entry is other for other in VELOCITIES)
        else entry
        for entry in commands
        if robot.moves_sideways or entry is not VELOCITIES[-1]
    )


@functools.lru_cache(maxsize=64)
def velocity_commands(robot: Robot) -> tuple[Command, ...]:
    """Return the velocity command of a robot: the `VELOCITIES` that it has."""
    return commands_for(robot, VELOCITIES)


COMMAND_RATE: Final = (1.0, 4.0, 1.0)
"""Largest rate of change of each of the `VELOCITIES`, m/s^2 and rad/s^2, for the built-in robot."""
ACCELERATIONS: Final = ("forward_acceleration", "yaw_acceleration", "lateral_acceleration")
"""Fields of `config["command"]` with these rates."""
Acceleration = Annotated[float, Parameter.positive("m/s^2")]


def command_rate(robot: Robot) -> tuple[float, ...]:
    """Return the default of the largest rate of change of each of a robot's `velocity_commands`, m/s^2 and rad/s^2."""
    rates = zip(velocity_commands(robot), COMMAND_RATE, strict=False)
    return tuple(float(scaled(rate, scale_of(f"{entry.unit}^2", robot))) for entry, rate in rates)


ClockFrequency = Annotated[float, Parameter.positive("Hz")]


@dataclass(frozen=True)
class LoopConfig(Fields):
    """Fields of a task's config that a real robot needs, too, but for the command."""

    decimation: Annotated[int, Parameter(low=1, high=1000)] = 4
    """Physics steps per control step."""
    physics_timestep: Annotated[float, Parameter("s", 1e-5, 1.0)] = 0.005
    """Physics time step, s."""
    clock_frequency: ClockFrequency = CLOCK_FREQUENCY
    """Frequency of the gait clock and, in residual mode, of the scripted gait, Hz."""
    observation_history: Annotated[int, Parameter(low=1, high=1000)] = 3
    """Number of control steps whose observations are stacked into one, the latest first; 1: only the present one."""
    action: ActionConfig = field(default_factory=ActionConfig)

    @property
    def control_timestep(self) -> float:
        """Time between actions, s."""
        return self.physics_timestep * self.decimation


@dataclass(frozen=True)
class ControlConfig:
    """Configuration of a `ControlInterface`."""

    timestep: float = 0.02
    """Time between actions, s."""
    clock_frequency: float = CLOCK_FREQUENCY
    """Frequency of the gait clock, cycles per second."""
    observation_history: int = 3
    """Control steps whose observations a policy gets at once."""
    action: ActionConfig = field(default_factory=ActionConfig)
    command_rate: tuple[float, ...] = COMMAND_RATE[:2]
    """Largest rate at which each commanded velocity changes, m/s^2 or rad/s^2."""
    commands: tuple[Command, ...] = COMMANDS
    """Components of the command, the velocity command first."""

    @property
    def num_velocities(self) -> int:
        """Number of velocities, which come first in the command: 2, or 3 for a robot that moves sideways."""
        return len(self.command_rate)

    @classmethod
    def of(cls, loop: LoopConfig, section: Mapping[str, Plain], robot: Robot, commands: Sequence[Command]) -> Self:
        """Return the part of a task's config that control needs.

        `section` is the section `command`, with ranges and rates of the commands; missing ones are the robot's.
        """
        own = [replace(entry, range=section.get(entry.name, entry.range)) for entry in commands_for(robot, commands)]
        rates = [
            converted(section.get(name, rate), Acceleration, f"config.command.{name}")
            for name, rate in zip(ACCELERATIONS, command_rate(robot), strict=False)
        ]
        history, timestep = loop.observation_history, loop.control_timestep
        return cls(timestep, loop.clock_frequency, history, loop.action, tuple(rates), tuple(own))

    @classmethod
    def of_task(cls, values: Plain, robot: Robot, commands: Sequence[Command] = VELOCITIES) -> Self:
        """Create a config from the plain values of a task's config, as stored in a policy's file.

        Args:
            values: result of `TaskConfig.to_dict`; missing fields have the robot's defaults.
            robot: robot of the task.
            commands: components of the command; their ranges are replaced by those in `values`.

        Raises:
            QuadrupedError: if a field is not valid; the message names the field.
        """
        section = values.get("command", {}) if isinstance(values, dict) else values
        if not isinstance(section, dict):
            raise QuadrupedError(f"config: expected a mapping of fields; found {short(section)}")
        default = LoopConfig(clock_frequency=clock_frequency(robot))
        of_loop = {name: value for name, value in values.items() if name in hints_of(LoopConfig)}
        return cls.of(with_values(default, of_loop, "config"), section, robot, commands)
