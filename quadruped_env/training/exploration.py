"""Exploration that swings with the gait clock.

White noise at 50 Hz shakes the joints, whose motors follow up to about 9 Hz, but does not lengthen the strides. Noise
that is correlated in time does: Hollenstein et al. 2024, https://arxiv.org/abs/2312.11091. Here a part of the noise has
the rhythm of the gait, so that learning tries out whole strides instead of single steps of 0.02 s.
"""

import math
from typing import Final

import torch

_KEPT: Final = 0.98
"""Correlation of a wave with itself one control step later: it lasts for about a second, two strides."""


class ClockNoise:
    """Standard normal noise (N, J), of which a part is a wave a cos(phase) + b sin(phase) for each joint of each robot.

    The distribution of each number stays standard normal, as learning assumes. A policy without a gait gets the most
    waves. Their share falls as the policy's own actions swing more, because such noise disturbs an existing gait.
    Robots that are commanded to stand get white noise.

    Args:
        share: largest share of the waves in the variance, 0 to below 1.
        num_envs: number of robots, N.
        joints: number of joints, J.
    """

    def __init__(self, share: float, num_envs: int, joints: int) -> None:
        self._largest_share = share
        self._waves = torch.randn(2, num_envs, joints)
        self._share = torch.zeros(joints)

    def set_share(self, mean_actions: torch.Tensor, deviation: torch.Tensor) -> None:
        """Set the share of the waves from the actions of a rollout.

        Args:
            mean_actions: the policy's actions without noise (steps, N, J).
            deviation: standard deviation of the noise (J,).
        """
        variance = deviation.square()
        self._share = self._largest_share * variance / (variance + mean_actions.var(dim=(0, 1)))

    def mix_into(self, white: torch.Tensor, phase: torch.Tensor, moving: torch.Tensor) -> None:
        """Mix the waves into white noise, in place, and advance them by a control step.

        Args:
            white: standard normal numbers (N, J).
            phase: phase of each robot's gait clock (N,), rad.
            moving: 1 where a motion is commanded, else 0, (N,).
        """
        share = self._share * moving[:, None]
        cosine, sine = self._waves
        wave = cosine * phase.cos()[:, None] + sine * phase.sin()[:, None]
        white.mul_((1.0 - share).sqrt()).add_(share.sqrt() * wave)
        self._waves.mul_(_KEPT).add_(torch.randn_like(self._waves), alpha=math.sqrt(1.0 - _KEPT**2))
