"""Share of the gaits near a scripted gait that some start leads astray: whether it needs its own numbers exactly."""

from collections.abc import Iterator
from typing import Final

import numpy as np

from quadruped_env.gait import LEG_PHASES, CommandedGait
from quadruped_env.training.gait_trial import many_new_starts, measure, trials
from quadruped_env.training.gait_tuning import candidates_of, gait_targets

VARIANTS: Final = 24
DEVIATION: Final = 0.003
"""Standard deviation of what a variant changes in each number of the straight gait, rad."""
ASTRAY: Final = 0.06
"""Difference of one start's forward velocity from the mean of the starts, m/s, that counts as astray."""
_UNSEEN: Final = 10_000
"""Of the starts: a generation that no search reaches."""


def astray_share(gait: CommandedGait, speed: float, seed: int = 0) -> float:
    """Share of the variants that any of 24 starts leads astray, for the row of a gait's tables at a speed in m/s."""
    rng = np.random.default_rng(seed)
    variants = np.tile(candidates_of(gait)[speed], (VARIANTS, 1, 1, 1))
    variants[:, 0] += rng.normal(0.0, DEVIATION, variants[:, 0].shape)
    phases, starts = LEG_PHASES["trot"], many_new_starts(_UNSEEN)
    targets = gait_targets(variants, np.zeros(VARIANTS), phases)
    got = measure(targets, trials(VARIANTS, starts), gait.angular_frequency, phases, starts)
    return float((got.forward_velocity_spread > ASTRAY).mean())


def sensitivity_table(gait: CommandedGait) -> Iterator[str]:
    """Lines of a Markdown table of `astray_share` at every speed of the gait's tables, as they are measured."""
    yield "| speed m/s | variants astray % |"
    yield "|---|---|"
    for speed in gait.speeds:
        yield f"| {speed:+.3f} | {100.0 * astray_share(gait, speed):.0f} |"
