"""The gait over time."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.report.palette import leg_colours
from quadruped_env.report.plots.canvas import draw_figure, label, shown_samples


def gait_diagram(comparison: Comparison, command: int, seconds: float = 2.0) -> str:
    """Gait diagram: the times at which each foot is on the ground, for every controller except the zero action."""
    shown = [name for name in comparison.rollouts if name != "zero"]

    def draw(axes: Any) -> None:
        for ax, controller in zip(axes[:, 0], shown, strict=True):
            one = comparison.rollouts[controller].select([comparison.episode(command, controller)])
            samples = shown_samples(one.valid, one.timestep, seconds)
            for leg, colour in enumerate(leg_colours(one.robot).values()):
                spans = _spans(one.contact[samples, 0, leg])
                start = (samples[0] if len(samples) else 0) * one.timestep
                ax.broken_barh(
                    [(start + begin * one.timestep, length * one.timestep) for begin, length in spans],
                    (leg - 0.36, 0.72),
                    color=colour,
                )
            ax.set_yticks(range(one.robot.num_legs), one.robot.leg_names)
            ax.set_ylim(one.robot.num_legs - 0.4, -0.6)
            ax.grid(visible=False, axis="y")
            ax.set_title(label(controller))
            ax.set_ylabel("foot")
        axes[-1, 0].set_xlabel("time (s)")

    return draw_figure(len(shown), 1, 0.5 + 1.15 * len(shown), draw, sharex=True)


def _spans(on: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First index and length of every run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], on.astype(np.int8), [0]])))
    return [(int(begin), int(end - begin)) for begin, end in edges.reshape(-1, 2)]
