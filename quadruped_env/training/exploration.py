"""Exploration that swings with the gait clock.

White noise at 50 Hz shakes the joints, whose motors follow up to about 9 Hz, but does not lengthen the strides. Noise
that is correlated in time does: Hollenstein et al. 2024, https://arxiv.org/abs/2312.11091. Here a part of the noise has
the rhythm of the gait, so that learning tries out whole strides instead of single steps of 0.02 s.
"""

import math
from typing import Final

import torch

from quadruped_env.control.control_interface import ControlInterface

_KEPT: Final = 0.98
"""Correlation of a wave with itself one control step later: it lasts for about a second, two strides."""


class ClockNoise:
    """Standard normal noise (N, J), of which a part is a wave a cos(phase) + b sin(phase) for each joint of each robot.

    The distribution of each number stays standard normal, as learning assumes. A policy without a gait gets the most
    waves. Their share falls as the policy's own actions swing more, because such noise disturbs an existing gait.
    Robots that are commanded to stand get white noise.

    Args:
        share: largest share of the waves in the variance, 0 to below 1.
        control: the gait clocks and commands of the N robots.
    """

    def __init__(self, share: float, control: ControlInterface) -> None:
        self._largest_share, self._control = share, control
        shape = control.action.shape
        self._waves = torch.randn(2, *shape)
        self._share = torch.zeros(shape[1])
        self._means: list[torch.Tensor] = []

    def draw(self, means: torch.Tensor) -> torch.Tensor:
        """Noise (N, J) of one control step, for the policy's mean actions (N, J)."""
        self._means.append(means)
        phase, moving = (torch.from_numpy(part).float() for part in (self._control.phase, self._control.moving))
        share = self._share * moving[:, None]
        cosine, sine = self._waves
        wave = cosine * phase.cos()[:, None] + sine * phase.sin()[:, None]
        noise = torch.randn_like(means).mul_((1.0 - share).sqrt()).add_(share.sqrt() * wave)
        self._waves.mul_(_KEPT).add_(torch.randn_like(self._waves), alpha=math.sqrt(1.0 - _KEPT**2))
        return noise

    def end_rollout(self, deviation: torch.Tensor) -> None:
        """Set the share of the waves from the mean actions since the last rollout.

        Args:
            deviation: standard deviation of the noise (J,).
        """
        variance = deviation.square()
        swing = torch.stack(self._means).var(dim=(0, 1))
        self._share = self._largest_share * variance / (variance + swing)
        self._means.clear()
