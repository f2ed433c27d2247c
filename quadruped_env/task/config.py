"""The task in numbers: frozen dataclasses of plain values, validated, printable, saved with every run."""

import dataclasses
import functools
import math
import sys
import types
import typing
from dataclasses import dataclass, field
from typing import Any, Final, Literal, Self

import numpy as np
from numpy.typing import NDArray

from quadruped_env._plain import PlainFields, plain
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot import MotorConfig

ACTION_MODES: Final = ("position", "residual")

Range = tuple[float, float]

REWARD_WEIGHTS: Final = types.MappingProxyType(
    {
        "track_forward_velocity": 6.0,
        "track_yaw_rate": 3.0,
        "forward_progress": 4.0,
        "turn_progress": 2.0,
        "gait_clock": 5.0,
        "upright": -2.0,
        "base_height": -20.0,
        "vertical_velocity": -0.5,
        "roll_pitch_rate": -0.03,
        "lateral_velocity": -0.5,
        "action_rate": -0.08,
        "mechanical_power": -0.005,
        "foot_slip": -0.3,
        "stand_still": -1.0,
        "joint_speed": -1.0,
        "fall": -50.0,
    }
)
"""Weight of every reward term, per second"""


def _check(condition: bool, name: str, value: object, rule: str) -> None:
    if not condition:
        raise QuadrupedError(f"config: {name} must be {rule}; found {short(value)}")


def _check_range(name: str, value: Range) -> None:
    _check(len(value) == 2 and value[0] <= value[1], name, value, "a pair (low, high) with low <= high")


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
        _check(self.position_scale > 0, "action.position_scale", self.position_scale, "positive (rad)")
        _check(self.residual_scale > 0, "action.residual_scale", self.residual_scale, "positive (rad)")


@dataclass(frozen=True)
class CommandConfig(PlainFields):
    """Which velocities are asked for."""

    forward_velocity: Range = (-0.3, 0.6)
    """m/s"""
    yaw_rate: Range = (-0.8, 0.8)
    """rad/s"""
    standing_fraction: float = 0.1
    """Share of commands that are exactly zero."""
    straight_fraction: float = 0.4
    """Share of commands with a yaw rate of exactly zero."""
    resample_interval: Range = (3.0, 6.0)
    """s between new commands within an episode."""

    @functools.cached_property
    def bounds(self) -> NDArray[np.float64]:
        """Lowest and highest forward velocity (m/s) and yaw rate (rad/s), (2, 2)."""
        return np.array([self.forward_velocity, self.yaw_rate]).T

    def __post_init__(self) -> None:
        super().__post_init__()
        _check_range("command.forward_velocity", self.forward_velocity)
        _check_range("command.yaw_rate", self.yaw_rate)
        _check_range("command.resample_interval", self.resample_interval)
        _check(self.resample_interval[0] > 0, "command.resample_interval", self.resample_interval, "positive (s)")
        shares = self.standing_fraction + self.straight_fraction
        _check(self.standing_fraction >= 0, "command.standing_fraction", self.standing_fraction, "at least 0")
        _check(self.straight_fraction >= 0, "command.straight_fraction", self.straight_fraction, "at least 0")
        _check(shares <= 1, "command.standing_fraction + straight_fraction", shares, "at most 1")


@dataclass(frozen=True)
class RewardConfig(PlainFields):
    """Weight of every reward term, per second, and the shapes of the terms. Penalties have negative weights."""

    weights: dict[str, float] = field(default_factory=lambda: dict(REWARD_WEIGHTS))
    forward_velocity_std: float = 0.1
    """m/s; width of the tracking kernel exp(-(error / std)^2)"""
    yaw_rate_std: float = 0.25
    """rad/s; likewise"""
    velocity_time_constant: float = 0.2
    """s; the tracking terms see velocities through a first-order filter, because every gait sways within its cycle"""
    base_height: float = 0.175
    """m; the height that `base_height` asks for"""
    foot_lift: float = 0.02
    """m; the sole's height in the swing at which `gait_clock` is satisfied"""
    joint_speed_margin: float = 1.0
    """rad/s below the motors' top speed at which `joint_speed` begins; a motor at its top speed has no torque left"""
    contact_threshold: float = 1.0
    """N; a foot that presses harder than this is in contact"""

    @functools.cached_property
    def velocity_std(self) -> NDArray[np.float64]:
        """The two widths as an array (2,)."""
        return np.array([self.forward_velocity_std, self.yaw_rate_std])

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("forward_velocity_std", "yaw_rate_std", "velocity_time_constant", "base_height", "foot_lift"):
            _check(getattr(self, name) > 0, f"reward.{name}", getattr(self, name), "positive")
        for name in sorted(set(self.weights) ^ set(REWARD_WEIGHTS)):
            raise QuadrupedError(
                f"config: reward.weights: {name!r} is {'unknown' if name in self.weights else 'missing'}; "
                f"the terms are {', '.join(REWARD_WEIGHTS)}"
            )
        for name, weight in self.weights.items():
            _check(math.isfinite(weight), f"reward.weights[{name!r}]", weight, "finite")


@dataclass(frozen=True)
class TerminationConfig(PlainFields):
    """When an episode is lost."""

    max_tilt: float = 1.0
    """rad between the base's up axis and the world's"""
    max_trunk_force: float = 1.0
    """N on the base or a hip"""

    def __post_init__(self) -> None:
        super().__post_init__()
        _check(0 < self.max_tilt <= math.pi, "termination.max_tilt", self.max_tilt, "in (0, pi] (rad)")
        _check(self.max_trunk_force >= 0, "termination.max_trunk_force", self.max_trunk_force, "at least 0 (N)")


@dataclass(frozen=True)
class RandomizationConfig(PlainFields):
    """What differs from episode to episode. Each draw is uniform and comes from the row's own generator."""

    start_joint_position: float = 0.1
    """rad around the stance, each joint"""
    start_joint_velocity: float = 0.5
    """rad/s around zero, each joint"""
    start_base_velocity: float = 0.2
    """m/s and rad/s around zero, each axis"""
    start_tilt: float = 0.05
    """rad of roll and of pitch around level"""
    friction: Range | None = None
    """Sliding friction between foot and ground; None leaves the model's"""
    payload: Range | None = None
    """kg added to the base; None adds nothing"""
    push_velocity: float = 0.0
    """m/s; the base is pushed sideways and lengthways by up to this much"""
    push_interval: Range = (4.0, 8.0)
    """s between pushes"""
    observation_noise: float = 0.0
    """Share of each observation field's noise amplitude (see `OBSERVATION_LAYOUT`); 1 is a real robot's"""

    @functools.cached_property
    def start_scale(self) -> NDArray[np.float64]:
        """Largest start offsets: joints (8,), joint velocities (8,), base velocity (6,), roll, pitch and yaw: (25,)."""
        tilts = [self.start_tilt, self.start_tilt, math.pi]
        counts = ((self.start_joint_position, 8), (self.start_joint_velocity, 8), (self.start_base_velocity, 6))
        return np.concatenate([np.full(count, value) for value, count in counts] + [tilts])

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("start_joint_position", "start_joint_velocity", "start_base_velocity", "start_tilt"):
            _check(getattr(self, name) >= 0, f"randomization.{name}", getattr(self, name), "at least 0")
        _check(self.push_velocity >= 0, "randomization.push_velocity", self.push_velocity, "at least 0 (m/s)")
        _check(self.observation_noise >= 0, "randomization.observation_noise", self.observation_noise, "at least 0")
        _check_range("randomization.push_interval", self.push_interval)
        _check(self.push_interval[0] > 0, "randomization.push_interval", self.push_interval, "positive (s)")
        for name in ("friction", "payload"):
            value = getattr(self, name)
            if value is not None:
                _check_range(f"randomization.{name}", value)
        if self.friction is not None:
            _check(self.friction[0] > 0, "randomization.friction", self.friction, "positive")
        if self.payload is not None:
            _check(self.payload[0] > -1.0, "randomization.payload", self.payload, "over -1 kg")


@dataclass(frozen=True)
class TaskConfig(PlainFields):
    """Everything that defines the task."""

    decimation: int = 4
    """Physics steps per control step."""
    physics_timestep: float = 0.005
    """s"""
    clock_frequency: float = 2.2
    """Gait cycles per second, of the clock in the observation and of the scripted gait in residual mode"""
    action: ActionConfig = field(default_factory=ActionConfig)
    command: CommandConfig = field(default_factory=CommandConfig)
    reward: RewardConfig = field(default_factory=RewardConfig)
    termination: TerminationConfig = field(default_factory=TerminationConfig)
    randomization: RandomizationConfig = field(default_factory=RandomizationConfig)
    motor: MotorConfig = field(default_factory=MotorConfig)
    """The robot's own, or what `evaluate/identify.py` found on another"""

    def __post_init__(self) -> None:
        super().__post_init__()
        _check(isinstance(self.decimation, int) and self.decimation >= 1, "decimation", self.decimation, "1 or more")
        _check(self.physics_timestep > 0, "physics_timestep", self.physics_timestep, "positive (s)")
        _check(self.clock_frequency > 0, "clock_frequency", self.clock_frequency, "positive (Hz)")

    @property
    def control_timestep(self) -> float:
        """Time between actions, s."""
        return self.physics_timestep * self.decimation

    def to_dict(self) -> dict[str, Any]:
        """Plain nested values, as `from_dict` and JSON take them."""
        return dataclasses.asdict(self)

    @classmethod
    def from_dict(cls, values: dict[str, Any]) -> Self:
        """A config from nested values, NumPy's included; what is left out keeps its default.

        Raises:
            QuadrupedError: if a field is unknown or a value of the wrong kind, saying which and what is valid.
        """
        return _build(cls, plain(values), "config")


_type_hints = functools.cache(typing.get_type_hints)


def _build(kind: type, values: Any, path: str) -> Any:
    """An instance of a config dataclass from nested plain values; `path` names it in errors."""
    if not isinstance(values, dict):
        raise QuadrupedError(f"{path}: expected a mapping of fields; found {short(values)}")
    hints = _type_hints(kind)
    unknown = sorted(set(values) - set(hints))
    if unknown:
        raise QuadrupedError(f"{path}: unknown field {short(unknown[0])}; valid fields are {', '.join(hints)}")
    return kind(**{name: _convert(hints[name], value, f"{path}.{name}") for name, value in values.items()})


def _convert(hint: Any, value: Any, path: str) -> Any:
    if dataclasses.is_dataclass(hint):
        assert isinstance(hint, type)
        return _build(hint, value, path)
    origin = typing.get_origin(hint)
    if origin in (typing.Union, types.UnionType):
        if value is None:
            return None
        return _convert(typing.get_args(hint)[0], value, path)
    if origin is tuple:
        if not isinstance(value, (list, tuple)) or len(value) != 2:
            raise QuadrupedError(f"{path}: expected a pair (low, high); found {short(value)}")
        return tuple(_convert(float, item, path) for item in value)
    if origin is dict:
        if not isinstance(value, dict):
            raise QuadrupedError(f"{path}: expected a mapping of terms to weights; found {short(value)}")
        unknown = sorted(set(value) - set(REWARD_WEIGHTS))
        if unknown:
            raise QuadrupedError(
                f"{path}: unknown reward term {short(unknown[0])}; valid terms are {', '.join(REWARD_WEIGHTS)}"
            )
        return dict(REWARD_WEIGHTS) | {
            name: _convert(float, weight, f"{path}[{name!r}]") for name, weight in value.items()
        }
    if origin is Literal:
        return value
    if isinstance(value, bool) or not isinstance(value, (int, float)) or (hint is int and not isinstance(value, int)):
        raise QuadrupedError(
            f"{path}: expected {'a whole number' if hint is int else 'a number'}; found {short(value)}"
        )
    # Not math.isfinite, which raises for whole numbers that no float holds.
    if not abs(value) <= sys.float_info.max:
        raise QuadrupedError(f"{path}: expected a finite number; found {short(value)}")
    return hint(value)
