"""Random sampling of commands."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_config import Command
from quadruped_env.task.config_sections import Section
from quadruped_env.task.randomization.draws import Purposes
from quadruped_env.task.randomization.randomization import between

Floats = NDArray[np.float64]


class CommandSampler:
    """Samples commands.

    Args:
        commands: components of the command (C,), the velocities first.
        config: ranges, fractions of standing, straight and turning commands, and time between commands.
    """

    def __init__(self, commands: Sequence[Command], config: Section) -> None:
        self._config = config
        names = [command.name for command in commands]
        self.purposes = Purposes({"command/kind": 1, **{f"command/{name}": 1 for name in names}, "command/interval": 1})
        ranges = np.array([config[name] for name in names])
        self._low, self._high = ranges[:, 0], ranges[:, 1]

    def sample(self, draws: Floats) -> tuple[Floats, Floats]:
        """Commands (R, C) and times until the next command (R,) in s, from uniform draws (R, 2 + C) in [0, 1)."""
        kind, config = draws[:, 0], self._config
        interval = between(config.resample_interval, draws[:, -1])
        command = self._low + (self._high - self._low) * draws[:, 1:-1]
        standing = config.standing_fraction
        straight = standing + config.straight_fraction
        turning = (kind >= straight) & (kind < straight + config.turning_fraction)
        np.copyto(command[:, 1], 0.0, where=kind < straight)
        np.copyto(command[:, 0], 0.0, where=(kind < standing) | turning)
        return command, interval
