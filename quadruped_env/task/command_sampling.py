"""Commands: their part of the config, and their random sampling."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Final

import numpy as np

from quadruped_env.control.control_config import COMMAND_RATE, Acceleration, Command
from quadruped_env.task.randomization.draws import Purposes
from quadruped_env.task.randomization.randomization import between
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.fields import Range, Section, check
from quadruped_env.utils.parameters import Parameter

_SHARES: Final = ("standing_fraction", "straight_fraction", "turning_fraction", "sideways_fraction")
Share = Annotated[float, Parameter(low=0.0)]


SIDEWAYS: Final = (("lateral_acceleration", Acceleration, COMMAND_RATE[2]), ("sideways_fraction", Share, 0.15))
"""Fields that the section has, too, for robots that move sideways: name, annotation, default for the built-in robot."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class CommandSection(Section, path="config.command"):
    """Distribution of the commands; the range of each further component of a task is a field of its name, too."""

    forward_acceleration: Acceleration = COMMAND_RATE[0]
    """Largest rate of change of the commanded forward velocity, m/s^2."""
    yaw_acceleration: Annotated[float, Parameter.positive("rad/s^2")] = COMMAND_RATE[1]
    """The same of the yaw rate, rad/s^2."""
    forward_velocity: Annotated[Range, Parameter("m/s")] = (-0.3, 0.6)
    yaw_rate: Annotated[Range, Parameter("rad/s")] = (-0.8, 0.8)
    standing_fraction: Share = 0.1
    """Share of commands to stand."""
    straight_fraction: Share = 0.25
    """Share of commands to walk straight ahead or back."""
    turning_fraction: Share = 0.15
    """Share of commands to turn on the spot."""
    resample_interval: Annotated[Range, Parameter.positive("s")] = (1.0, 5.0)
    """Time until the next command, s."""

    def __post_init__(self) -> None:
        super().__post_init__()
        share = sum(self.shares.values())
        check(share <= 1, f"{self.path}.{' + '.join(self.shares)}", share, "at most 1")

    @property
    def shares(self) -> dict[str, float]:
        """Shares of commands with none of the velocities, and with each of them alone; the others have all."""
        return {name: self[name] for name in _SHARES if name in self}


class CommandSampler:
    """Samples commands of C components, the velocities first."""

    def __init__(self, commands: Sequence[Command], config: CommandSection) -> None:
        self._interval = config.resample_interval
        names = [command.name for command in commands]
        self.purposes = Purposes({"command/kind": 1, **{f"command/{name}": 1 for name in names}, "command/interval": 1})
        ranges = np.array([config[name] for name in names])
        self._low, self._high = ranges[:, 0], ranges[:, 1]
        self._until = np.cumsum(list(config.shares.values()))
        each = np.eye(len(self._until) - 1)
        # A command to stand, one for each velocity alone, and those with all of them.
        self._none = np.vstack([np.zeros_like(each[:1]), each, np.ones_like(each[:1])]) == 0.0
        """True for each velocity that is zero in commands of a kind (kinds, V)."""

    def sample(self, draws: Floats) -> tuple[Floats, Floats]:
        """Return commands (R, C) and times until the next ones (R,) in s, from uniform draws (R, 2 + C) in [0, 1)."""
        kind, interval = draws[:, 0], between(self._interval, draws[:, -1])
        command = self._low + (self._high - self._low) * draws[:, 1:-1]
        none = self._none[np.searchsorted(self._until, kind, side="right")]
        np.copyto(command[:, : none.shape[1]], 0.0, where=none)
        return command, interval
