"""Configuration that training and a real robot share: action scaling, control rate and commands."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Final, Literal, Self

from quadruped_env.control.clock import Frequency, frequency_of, middle_frequency
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.gait import CLOCK_FREQUENCY, COMMANDED, SINUSOID, CommandedGait
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of, scaled
from quadruped_env.utils.parameters import LARGEST, SMALLEST, is_quantity
from quadruped_env.utils.plain import Plain, PlainFields

ACTION_MODES: Final = ("position", "residual")
MAX_DECIMATION: Final = 1000
"""Maximum number of physics steps per control step."""
PHYSICS_TIMESTEPS: Final = (1e-5, 1.0)
"""Shortest and longest physics time step, s."""
MAX_HISTORY: Final = 1000
"""Maximum number of control steps that a policy observes at once."""

Range = tuple[float, float]


def check(condition: bool, name: str, value: object, rule: str) -> None:
    """Raise a QuadrupedError that names the field, the value and the rule, unless the condition holds."""
    if not condition:
        raise QuadrupedError(f"config: {name} must be {rule}; found {short(value)}")


def check_history(history: Plain) -> None:
    """Raise a QuadrupedError unless a value is a number of control steps."""
    rule = f"a whole number of control steps, 1 or more (1: only the present observation), at most {MAX_HISTORY}"
    check(type(history) is int and 1 <= history <= MAX_HISTORY, "observation_history", history, rule)


def check_rates(decimation: Plain, physics_timestep: Plain) -> None:
    """Raise a QuadrupedError unless two values are a number of physics steps per control step and a time step in s."""
    valid = type(decimation) is int and 1 <= decimation <= MAX_DECIMATION
    check(valid, "decimation", decimation, f"1 or more, at most {MAX_DECIMATION}")
    low, high = PHYSICS_TIMESTEPS
    check(
        is_quantity(physics_timestep, low, high),
        "physics_timestep",
        physics_timestep,
        f"positive, {low:g} to {high:g} (s)",
    )


def check_range(name: str, value: Plain) -> None:
    """Raise a QuadrupedError unless a value is a pair (low, high) with low <= high, each at most `LARGEST` in size."""
    rule = "a pair (low, high) with low <= high"
    check(isinstance(value, (tuple, list)) and len(value) == 2, name, value, rule)
    check(all(map(is_quantity, value)), name, value, f"{rule}, each from {-LARGEST:g} to {LARGEST:g}")
    check(value[0] <= value[1], name, value, rule)


@dataclass(frozen=True)
class ActionConfig(PlainFields):
    """Conversion of an action to joint targets."""

    mode: Literal["position", "residual"] = "position"
    """`position`: relative to the stance. `residual`: relative to the scripted gait: a zero action is the gait."""
    position_scale: float = 0.6
    """Change of the joint target per unit of action in `position` mode, rad."""
    residual_scale: float = 0.4
    """Change of the joint target per unit of action in `residual` mode, rad."""
    gait: Literal["sinusoid", "tuned", "crouched", "low", "fast"] = "sinusoid"
    """Scripted gait of the `residual` mode: the trot in closed form, or one that a search found. `crouched` bends its
    legs further, the steps of `low` are low and quick, `fast` takes longer strides; they need gait clocks of their own
    frequencies, 3.6, 5 and 3.2 Hz."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.mode not in ACTION_MODES:
            raise QuadrupedError(
                f"action_mode: {short(self.mode)} is unknown; valid modes are {', '.join(ACTION_MODES)}"
            )
        for name in ("position_scale", "residual_scale"):
            value = getattr(self, name)
            check(is_quantity(value, SMALLEST), f"action.{name}", value, f"positive (rad), at most {LARGEST:g}")
        check(self.gait in tuple(COMMANDED), "action.gait", self.gait, f"one of {', '.join(COMMANDED)}")

    @property
    def scale(self) -> float:
        """Change of the joint target per unit of action in the selected mode, rad."""
        return self.residual_scale if self.mode == "residual" else self.position_scale

    def scripted_gait(self, robot: Robot, clock: Frequency) -> CommandedGait | None:
        """Gait of a robot with a clock to which actions are added; None in `position` mode."""
        if self.mode != "residual":
            return None
        if self.gait == SINUSOID:
            return CommandedGait.sinusoid(robot, middle_frequency(clock))
        return CommandedGait.preset(self.gait, robot)


@dataclass(frozen=True)
class Command(PlainFields):
    """One component of the command."""

    name: str
    """Name of the component, and of its field in `config["command"]`, which holds the range."""
    unit: str
    range: Range
    """Valid range (low, high). Episodes draw the component uniformly from it, together with the velocity command."""
    default: float = 0.0
    """Value for a fixed command that leaves this component out."""

    def __post_init__(self) -> None:
        super().__post_init__()
        check_range(f"command.{self.name}", self.range)


COMMANDS: Final = (
    Command("forward_velocity", "m/s", (-0.3, 0.6)),
    Command("yaw_rate", "rad/s", (-0.8, 0.8)),
)
"""The velocity command, which every task has."""


def clock_frequency(robot: Robot) -> float:
    """Default frequency of a robot's gait clock, Hz."""
    return float(scaled(CLOCK_FREQUENCY, scale_of("Hz", robot)))


def commands_for(robot: Robot, commands: Sequence[Command] = COMMANDS) -> tuple[Command, ...]:
    """Commands of a robot; the ranges of the built-in ones follow its size."""
    return tuple(
        replace(entry, range=scaled(entry.range, scale_of(entry.unit, robot)))
        if any(entry is other for other in COMMANDS)
        else entry
        for entry in commands
    )


COMMAND_RATE: Final[Mapping[str, float]] = {"forward_acceleration": 1.0, "yaw_acceleration": 4.0}
"""Fields of `config["command"]` with the largest rate of change of the velocity command, for the built-in robot."""
COMMAND_RATE_UNITS: Final = ("m/s^2", "rad/s^2")


def command_rate(robot: Robot) -> tuple[float, float]:
    """Default of the largest rate of change of a robot's forward velocity and yaw rate commands, m/s^2 and rad/s^2."""
    rates = zip(COMMAND_RATE.values(), COMMAND_RATE_UNITS, strict=True)
    forward, turn = (float(scaled(rate, scale_of(unit, robot))) for rate, unit in rates)
    return forward, turn


@dataclass(frozen=True)
class ControlConfig:
    """Fields of a task's config that a `ControlInterface` needs."""

    timestep: float = 0.02
    """Time between actions, s."""
    clock_frequency: Frequency = CLOCK_FREQUENCY
    """Frequency of the gait clock, cycles per second; constant, or a function of the command."""
    observation_history: int = 3
    """Control steps whose observations a policy gets at once."""
    action: ActionConfig = field(default_factory=ActionConfig)
    command_rate: tuple[float, float] = (COMMAND_RATE["forward_acceleration"], COMMAND_RATE["yaw_acceleration"])
    """Largest rate at which the commanded forward velocity (m/s^2) and yaw rate (rad/s^2) change."""
    commands: tuple[Command, ...] = COMMANDS
    """Components of the command, the velocity command first."""

    @classmethod
    def of_robot(cls, robot: Robot) -> Self:
        """The defaults for a robot."""
        return cls(
            clock_frequency=clock_frequency(robot), command_rate=command_rate(robot), commands=commands_for(robot)
        )

    @classmethod
    def of_task(cls, values: Plain, commands: Sequence[Command] = COMMANDS) -> Self:
        """Create a config from the plain values of a task's config, as stored in a policy's file.

        Args:
            values: result of `TaskConfig.to_dict`.
            commands: components of the command; their ranges are replaced by those in `values`.

        Raises:
            QuadrupedError: if a field is missing or not valid; the message names the field.
        """
        if not isinstance(values, dict):
            raise QuadrupedError(f"config: expected a mapping of fields; found {short(values)}")
        default = cls()
        decimation, physics_timestep = values.get("decimation", 4), values.get("physics_timestep", 0.005)
        check_rates(decimation, physics_timestep)
        history = values.get("observation_history", default.observation_history)
        check_history(history)
        try:
            section = values.get("command", {})
            ranges = {command.name: command.range for command in commands} | section
            rates = {**COMMAND_RATE} | {name: section[name] for name in COMMAND_RATE if name in section}
            for name, rate in rates.items():
                check(is_quantity(rate, SMALLEST), f"command.{name}", rate, f"positive, at most {LARGEST:g}")
            return cls(
                timestep=float(physics_timestep * decimation),
                clock_frequency=frequency_of(values.get("clock_frequency", default.clock_frequency)),
                observation_history=history,
                action=ActionConfig(**values.get("action", {})),
                command_rate=(rates["forward_acceleration"], rates["yaw_acceleration"]),
                commands=tuple(replace(command, range=ranges[command.name]) for command in commands),
            )
        except TypeError as error:
            raise QuadrupedError(f"config: a field has a value of the wrong type ({error})") from error
