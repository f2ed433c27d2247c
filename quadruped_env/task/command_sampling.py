"""Commands: their part of the config, and their random sampling."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from quadruped_env.control.control_config import Command, CommandRate
from quadruped_env.task.randomization.draws import Purposes
from quadruped_env.task.randomization.randomization import between
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.fields import Range, Section, check
from quadruped_env.utils.parameters import Parameter

Share = Annotated[float, Parameter(low=0.0)]


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class CommandSection(Section, CommandRate, path="config.command"):
    """Distribution of the commands; the range of each further component of a task is a field of its name, too."""

    forward_velocity: Annotated[Range, Parameter("m/s")] = (-0.3, 0.6)
    yaw_rate: Annotated[Range, Parameter("rad/s")] = (-0.8, 0.8)
    standing_fraction: Share = 0.1
    """Share of commands to stand."""
    straight_fraction: Share = 0.25
    """Share of commands without a yaw rate."""
    turning_fraction: Share = 0.15
    """Share of commands to turn on the spot."""
    resample_interval: Annotated[Range, Parameter.positive("s")] = (1.0, 5.0)
    """Time until the next command, s."""

    def __post_init__(self) -> None:
        super().__post_init__()
        share = self.standing_fraction + self.straight_fraction + self.turning_fraction
        check(share <= 1, f"{self.path}.standing_fraction + straight_fraction + turning_fraction", share, "at most 1")


class CommandSampler:
    """Samples commands.

    Args:
        commands: components of the command (C,), the velocities first.
        config: ranges, fractions of standing, straight and turning commands, and time between commands.
    """

    def __init__(self, commands: Sequence[Command], config: CommandSection) -> None:
        self._config = config
        names = [command.name for command in commands]
        self.purposes = Purposes({"command/kind": 1, **{f"command/{name}": 1 for name in names}, "command/interval": 1})
        ranges = np.array([config[name] for name in names])
        self._low, self._high = ranges[:, 0], ranges[:, 1]

    def sample(self, draws: Floats) -> tuple[Floats, Floats]:
        """Return commands (R, C) and times until the next ones (R,) in s, from uniform draws (R, 2 + C) in [0, 1)."""
        kind, config = draws[:, 0], self._config
        interval = between(config.resample_interval, draws[:, -1])
        command = self._low + (self._high - self._low) * draws[:, 1:-1]
        standing = config.standing_fraction
        straight = standing + config.straight_fraction
        turning = (kind >= straight) & (kind < straight + config.turning_fraction)
        np.copyto(command[:, 1], 0.0, where=kind < straight)
        np.copyto(command[:, 0], 0.0, where=(kind < standing) | turning)
        return command, interval
