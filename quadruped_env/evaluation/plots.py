"""The figures of a report: functions from a comparison to an SVG document, in one style.

Colours are Okabe and Ito's (https://jfly.uni-koeln.de/color/), which people with a colour vision deficiency can tell
apart. The figures are narrow, so that they can be read on a phone.
"""

import csv
import io
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.evaluation.comparison import CONTROLLERS, Comparison
from quadruped_env.evaluation.metrics import START_UP, window_means
from quadruped_env.robot import EFFORT_LIMIT, JOINT_POSITION_HIGH, JOINT_POSITION_LOW, LEG_NAMES, VELOCITY_LIMIT

CONTROLLER_COLOURS: Final = {"policy": "#0072B2", "tuned": "#D55E00", "article": "#009E73", "zero": "#7F7F7F"}
CONTROLLER_MARKERS: Final = {"policy": "o", "tuned": "s", "article": "^", "zero": "x"}
LEG_COLOURS: Final = dict(zip(LEG_NAMES, ("#0072B2", "#D55E00", "#56B4E9", "#E69F00"), strict=True))
_LIMIT_COLOUR: Final = "#CC0033"
_REFERENCE: Final[dict[str, Any]] = {"color": "#333333", "linewidth": 1.0, "linestyle": (0, (4, 2))}

WIDTH: Final = 5.6
"""in"""
STYLE: Final[dict[str, Any]] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9.0,
    "axes.titlesize": 9.0,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.edgecolor": "#888888",
    "grid.color": "#E4E4E4",
    "grid.linewidth": 0.7,
    "lines.linewidth": 1.6,
    "lines.markersize": 4.5,
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "figure.constrained_layout.use": True,
    "path.simplify_threshold": 0.5,
    "svg.hashsalt": "quadruped",
}
"""Of every figure; matplotlib's rcParams"""


def _figure(rows: int, columns: int, height: float, draw: Callable[[Any], None], **layout: Any) -> str:
    """An SVG document of a grid of axes (rows, columns), WIDTH by `height` inches, that `draw` has filled.

    Raises:
        MissingExtraError: if matplotlib is not installed.
    """
    try:
        from matplotlib import rc_context
        from matplotlib.figure import Figure
    except ImportError as error:
        raise MissingExtraError("The report", "report") from error

    with rc_context(STYLE):
        figure = Figure((WIDTH, height))
        draw(figure.subplots(rows, columns, squeeze=False, **layout))
        file = io.StringIO()
        # Without the date, the same numbers give the same file.
        figure.savefig(file, format="svg", metadata={"Date": None})
    return file.getvalue()


def tracking(comparison: Comparison) -> str:
    """Achieved over commanded velocity, forward and turning, of every controller."""
    panels = []
    commands = np.array(comparison.commands)
    straight = (
        comparison.conditions("forwards") + comparison.conditions("standing") + comparison.conditions("backwards")
    )
    turning = comparison.conditions("turning")
    if straight:
        panels.append((straight, 0, "forward_velocity", "forward velocity (m/s)"))
    if turning:
        panels.append((turning, 1, "yaw_rate", "yaw rate (rad/s)"))

    def draw(axes: Any) -> None:
        for ax, (rows, column, metric, label) in zip(axes[0], panels, strict=True):
            asked = commands[rows, column]
            span = np.array([asked.min(), asked.max()])
            ax.plot(span, span, **_REFERENCE, label="command")
            offsets = np.linspace(-1, 1, len(comparison.values)) * 0.012 * max(float(np.ptp(span)), 0.1)
            for offset, controller in zip(offsets, comparison.values, strict=True):
                estimates = [comparison.estimate_at(controller, metric, row) for row in rows]
                mean = np.array([e.mean for e in estimates])
                reach = np.array([[e.mean - e.low for e in estimates], [e.high - e.mean for e in estimates]])
                ax.errorbar(
                    # Side by side, where several controllers stand on the same spot.
                    asked + offset,
                    mean,
                    reach,
                    color=CONTROLLER_COLOURS[controller],
                    marker=CONTROLLER_MARKERS[controller],
                    linestyle="none",
                    elinewidth=1.0,
                    zorder=3 if controller == "policy" else 2,
                    label=CONTROLLERS[controller],
                )
            ax.set(xlabel=f"commanded {label}", ylabel=f"achieved {label}")
        axes[0, 0].legend(loc="upper left", handletextpad=0.3)

    return _figure(1, len(panels), 3.0, draw)


def velocity_over_time(comparison: Comparison, forward_at: int | None, turning_at: int | None) -> str:
    """Velocity over time of every controller in one episode of one command (index) or two."""
    panels = [(i, c) for i, c in ((forward_at, 0), (turning_at, 1)) if i is not None]

    def draw(axes: Any) -> None:
        for ax, (command, column) in zip(axes[:, 0], panels, strict=True):
            row = comparison.episode(command)
            for controller, rollout in reversed(comparison.rollouts.items()):
                one = rollout.select([row])
                velocity = one.yaw_rate if column else one.linear_velocity_b[..., 0]
                time = (np.arange(len(velocity)) + 1) * one.timestep
                colour = CONTROLLER_COLOURS[controller]
                if controller == "policy":
                    raw = np.where(one.valid & (time > START_UP)[:, None], velocity, np.nan)
                    ax.plot(time, raw, color=colour, linewidth=0.5, alpha=0.5)
                means, whole = window_means(velocity, one.valid, one.timestep)
                if len(means):
                    middle = time[: len(means)] + 0.5 * (time[-1] - time[len(means) - 1])
                    ax.plot(middle, np.where(whole, means, np.nan), color=colour, label=CONTROLLERS[controller])
            target = comparison.commands[command]
            ax.axhline(target[column], **_REFERENCE, label="command")
            ax.set_title(f"asked for {target[0]:g} m/s and {target[1]:g} rad/s")
            ax.set_ylabel("yaw rate (rad/s)" if column else "forward velocity (m/s)")
        handles, labels = axes[0, 0].get_legend_handles_labels()
        axes[0, 0].figure.legend(handles[::-1], labels[::-1], loc="outside upper center", ncols=3)
        axes[-1, 0].set_xlabel("time (s)")

    return _figure(len(panels), 1, 1.0 + 1.9 * len(panels), draw, sharex=True)


def joint_traces(comparison: Comparison, command: int, seconds: float = 1.5) -> str:
    """Position, speed and torque of the policy's joints with their limits, from the end of the start-up on.

    Args:
        comparison: what was run.
        command: index of the command.
        seconds: of it.
    """
    one = comparison.rollouts["policy"].select([comparison.episode(command)])
    samples = _samples(one.valid, one.timestep, seconds)
    time = (samples + 1) * one.timestep
    quantities: tuple[tuple[str, NDArray[Any], NDArray[Any], NDArray[Any]], ...] = (
        ("position (rad)", one.joint_position, JOINT_POSITION_LOW, JOINT_POSITION_HIGH),
        ("speed (rad/s)", one.joint_velocity, np.full(8, -VELOCITY_LIMIT), np.full(8, VELOCITY_LIMIT)),
        ("torque (N m)", one.joint_torque, np.full(8, -EFFORT_LIMIT), np.full(8, EFFORT_LIMIT)),
    )

    def draw(axes: Any) -> None:
        for row, (label, values, low, high) in zip(axes, quantities, strict=True):
            for joint, ax in enumerate(row):
                for limit in (low[joint], high[joint]):
                    line = ax.axhline(limit, color=_LIMIT_COLOUR, linewidth=1.0)
                for leg, name in enumerate(LEG_NAMES):
                    trace = values[samples, 0, 2 * leg + joint]
                    ax.plot(time, trace, color=LEG_COLOURS[name], linewidth=1.2, label=name)
                margin = 0.06 * (high[joint] - low[joint])
                ax.set_ylim(low[joint] - margin, high[joint] + margin)
            row[0].set_ylabel(label)
        axes[0, 0].set_title("hips")
        axes[0, 1].set_title("knees")
        for ax in axes[-1]:
            ax.set_xlabel("time (s)")
        handles, names = axes[0, 0].get_legend_handles_labels()
        axes[0, 0].figure.legend(
            [*handles, line], [*names, "limit"], loc="outside upper center", ncols=5, columnspacing=1.0
        )

    return _figure(3, 2, 4.8, draw, sharex=True)


def gait_diagram(comparison: Comparison, command: int, seconds: float = 2.0) -> str:
    """When each foot is on the ground, for every controller that moves its feet."""
    shown = [name for name in comparison.rollouts if name != "zero"]

    def draw(axes: Any) -> None:
        for ax, controller in zip(axes[:, 0], shown, strict=True):
            one = comparison.rollouts[controller].select([comparison.episode(command)])
            samples = _samples(one.valid, one.timestep, seconds)
            for leg, name in enumerate(LEG_NAMES):
                spans = _spans(one.contact[samples, 0, leg])
                start = (samples[0] if len(samples) else 0) * one.timestep
                ax.broken_barh(
                    [(start + begin * one.timestep, length * one.timestep) for begin, length in spans],
                    (leg - 0.36, 0.72),
                    color=LEG_COLOURS[name],
                )
            ax.set_yticks(range(len(LEG_NAMES)), LEG_NAMES)
            ax.set_ylim(len(LEG_NAMES) - 0.4, -0.6)
            ax.grid(visible=False, axis="y")
            ax.set_title(CONTROLLERS[controller])
            ax.set_ylabel("foot")
        axes[-1, 0].set_xlabel("time (s)")

    return _figure(len(shown), 1, 0.5 + 1.15 * len(shown), draw, sharex=True)


def _samples(valid: NDArray[np.bool_], timestep: float, seconds: float) -> NDArray[np.intp]:
    """Indices of the first `seconds` after the start-up, before a fall; of the very beginning for an early fall."""
    alive = int(valid[:, 0].sum())
    length = round(seconds / timestep)
    start = max(0, min(round(START_UP / timestep), alive - length))
    return np.arange(start, min(alive, start + length), dtype=np.intp)


def _spans(on: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First index and length of every run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], on.astype(np.int8), [0]])))
    return [(int(begin), int(end - begin)) for begin, end in edges.reshape(-1, 2)]


LEARNING_CURVES: Final = (
    ("return", "return"),
    ("forward_velocity_error", "forward velocity\nerror (m/s)"),
    ("fall_rate", "fall rate"),
)


def read_progress(path: Path) -> dict[str, NDArray[np.float64]]:
    """The learning curve of a training run: column -> values, NaN where there is none.

    Raises:
        QuadrupedError: if the file is not a table of numbers with a column `timesteps`.
    """
    try:
        with path.open(newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file)
            names = list(reader.fieldnames or ())
            rows = list(reader)
            # A line that a killed run left unfinished has fewer cells: those are None.
            columns = {name: np.array([float(row[name] or math.nan) for row in rows]) for name in names}
    except (ValueError, csv.Error) as error:
        raise QuadrupedError(f"{path}: {error}; remove the file to make the report without a learning curve") from error
    if "timesteps" not in columns:
        raise QuadrupedError(f"{path}: expected a column 'timesteps'; found {', '.join(names) or 'an empty file'}")
    return columns


def learning_curve(progress: dict[str, NDArray[np.float64]]) -> str:
    """What the training measured over its time steps."""
    curves: Sequence[tuple[str, str]] = [curve for curve in LEARNING_CURVES if curve[0] in progress]

    def draw(axes: Any) -> None:
        steps = progress["timesteps"] / 1e6
        for ax, (name, label) in zip(axes[:, 0], curves, strict=True):
            # Only some rows have a return: those in which an episode ended.
            known = np.isfinite(progress[name])
            ax.plot(steps[known], progress[name][known], color=CONTROLLER_COLOURS["policy"], marker=".", markersize=3)
            ax.set_ylabel(label)
            if name == "fall_rate":
                ax.set_ylim(-0.03, 1.03)
            elif name != "return":
                ax.set_ylim(bottom=0.0)
        axes[-1, 0].set_xlabel("time steps (millions)")

    return _figure(len(curves), 1, 0.5 + 1.3 * len(curves), draw, sharex=True)
