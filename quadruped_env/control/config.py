"""The numbers that a policy and a robot share: how an action becomes joint targets, how often, and the commands."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final, Literal, Self

from quadruped_env._plain import PlainFields, is_finite_number
from quadruped_env.errors import QuadrupedError, short

ACTION_MODES: Final = ("position", "residual")

Range = tuple[float, float]


def check(condition: bool, name: str, value: object, rule: str) -> None:
    """Raise a QuadrupedError that names the field, the value and the rule, unless the condition holds."""
    if not condition:
        raise QuadrupedError(f"config: {name} must be {rule}; found {short(value)}")


def check_range(name: str, value: Any) -> None:
    """Raise a QuadrupedError unless a value is a pair (low, high) with low <= high."""
    check(
        isinstance(value, (tuple, list)) and len(value) == 2 and value[0] <= value[1],
        name,
        value,
        "a pair (low, high) with low <= high",
    )


@dataclass(frozen=True)
class ActionConfig(PlainFields):
    """How an action becomes joint targets."""

    mode: Literal["position", "residual"] = "position"
    """`position`: around the stance. `residual`: around the scripted gait, so that a zero action is the gait."""
    position_scale: float = 0.6
    """rad of joint target per unit of action in `position` mode."""
    residual_scale: float = 0.4
    """rad of joint target per unit of action in `residual` mode."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.mode not in ACTION_MODES:
            raise QuadrupedError(
                f"action_mode: {short(self.mode)} is unknown; valid modes are {', '.join(ACTION_MODES)}"
            )
        check(self.position_scale > 0, "action.position_scale", self.position_scale, "positive (rad)")
        check(self.residual_scale > 0, "action.residual_scale", self.residual_scale, "positive (rad)")

    @property
    def scale(self) -> float:
        """Rad of joint target per unit of action, in the mode that is chosen."""
        return self.residual_scale if self.mode == "residual" else self.position_scale


@dataclass(frozen=True)
class Command(PlainFields):
    """One number that is commanded."""

    name: str
    """Also its field in `config["command"]`, which holds its range"""
    unit: str
    range: Range
    """What it may be, (low, high); episodes draw it uniformly from there, together with the velocity command"""
    default: float = 0.0
    """Its value where a command is fixed that does not give it"""

    def __post_init__(self) -> None:
        super().__post_init__()
        check_range(f"command.{self.name}", self.range)


COMMANDS: Final = (
    Command("forward_velocity", "m/s", (-0.3, 0.6)),
    Command("yaw_rate", "rad/s", (-0.8, 0.8)),
)
"""The velocity command, which every task has."""


@dataclass(frozen=True)
class ControlConfig:
    """What a `ControlInterface` needs to know of a task."""

    timestep: float = 0.02
    """s between actions"""
    clock_frequency: float = 2.2
    """Gait cycles per second"""
    action: ActionConfig = field(default_factory=ActionConfig)
    commands: tuple[Command, ...] = COMMANDS
    """The velocity command first"""

    @classmethod
    def of_task(cls, values: Any, commands: Sequence[Command] = COMMANDS) -> Self:
        """From the plain values of a task's config, as a policy's file holds them.

        Args:
            values: `TaskConfig.to_dict`.
            commands: what is commanded; the ranges are those of the values.

        Raises:
            QuadrupedError: if a field is missing or not valid, saying which.
        """
        if not isinstance(values, dict):
            raise QuadrupedError(f"config: expected a mapping of fields; found {short(values)}")
        default = cls()
        decimation, physics_timestep = values.get("decimation", 4), values.get("physics_timestep", 0.005)
        clock_frequency = values.get("clock_frequency", default.clock_frequency)
        check(type(decimation) is int and decimation >= 1, "decimation", decimation, "1 or more")
        for name, number in (("physics_timestep", physics_timestep), ("clock_frequency", clock_frequency)):
            check(is_finite_number(number) and number > 0, name, number, "a positive number")
        try:
            ranges = {command.name: command.range for command in commands} | values.get("command", {})
            return cls(
                timestep=float(physics_timestep * decimation),
                clock_frequency=float(clock_frequency),
                action=ActionConfig(**values.get("action", {})),
                commands=tuple(replace(command, range=ranges[command.name]) for command in commands),
            )
        except TypeError as error:
            raise QuadrupedError(f"config: a field has a value of the wrong kind ({error})") from error
