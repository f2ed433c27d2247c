"""The page of a replay: how closely it was followed, what the motors could not do, and pictures of both."""

from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.replay.replay import Replay
from quadruped_env.replay.signal_comparison import SIGNALS
from quadruped_env.reporting.pages.page import circumstances, figure, write_html
from quadruped_env.reporting.palette import BLUE, INK, VERMILION
from quadruped_env.reporting.plots.joints import Line, joint_panels
from quadruped_env.reporting.results import REPORT_FILE
from quadruped_env.robot import JOINT_NAMES, JOINT_POSITION_HIGH, JOINT_POSITION_LOW
from quadruped_env.task import TaskConfig

_GOOD: Final = 0.05
"""rad; a root mean square error below this is close"""


def write_replay_report(replay: Replay, directory: Path, command_line: str, compare: bool = False) -> None:
    """Write `report.html` into a directory, over an older one.

    Args:
        replay: what was played.
        directory: where to write.
        command_line: what a person types to repeat it.
        compare: whether to show recorded against simulated positions, velocities and efforts.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if the file cannot be written, or there is nothing to compare.
    """
    report = replay.report()
    error = report["tracking_error"]["all"]
    fell = replay.motion is not None and replay.motion.fell_at is not None
    tables = [_tracking_table(report)]
    figures = [_tracking_figure(replay)]
    if replay.motion is not None:
        tables.append(_limits_table(report))
        figures += _motor_figures(replay)
    if compare:
        tables.append(_comparison_table(replay))
        figures += _comparison_figures(replay)
    context = {
        "title": f"Replay of {Path(replay.recorded.source.name).name}, {replay.mode}",
        "headline": f"The joints followed to {error['rms']:.4f} rad (RMS), {error['max']:.4f} rad at most.",
        "level": "poor" if fell else "good" if error["rms"] < _GOOD else "fair",
        "remarks": replay.remarks(),
        "tables": tables,
        "figures": figures,
        "document": circumstances(command_line),
        "motors": TaskConfig(motor=replay.motors).to_dict()["motor"],
    }
    write_html(directory / REPORT_FILE, "motion.html", context)


def _tracking_table(report: dict[str, Any]) -> dict[str, Any]:
    rows = []
    for name, error in report["tracking_error"]["joints"].items():
        late = "-" if error["lag"] is None else f"{1000 * error['lag']:.0f}"
        rows.append([name, f"{error['rms']:.4f}", f"{error['max']:.4f}", f"{error['max_at']:.2f}", late])
    return {
        "title": "Tracking errors",
        "head": ["", "RMS (rad)", "largest (rad)", "at (s)", "lag (ms)"],
        "rows": rows,
        "note": "Played minus recorded position at the same time. The lag is the shift in time with the least error.",
    }


def _limits_table(report: dict[str, Any]) -> dict[str, Any]:
    rows = []
    for name, limits in report["limits"].items():
        saturated = limits["saturated"]
        first = "-" if saturated["first_at"] is None else f"{saturated['first_at']:.2f}"
        fastest = limits["fastest_recorded"]
        rows.append(
            [
                name,
                f"{100 * saturated['share']:.1f}",
                first,
                f"{saturated['largest_torque_asked']:.2f}",
                f"{limits['largest_torque']:.2f}",
                "-" if fastest is None else f"{fastest:.2f}",
                f"{limits['fastest']:.2f}",
                str(limits["positions_clipped"]),
            ]
        )
    return {
        "title": "Limits",
        "head": [
            "",
            "at the motor's limit (% of time)",
            "first at (s)",
            "torque wanted (N m)",
            "torque given",
            "speed recorded (rad/s)",
            "speed played",
            "positions clipped",
        ],
        "rows": rows,
        "note": "A motor is at its limit where its controller wants more torque than it can give at its speed.",
    }


def _comparison_table(replay: Replay) -> dict[str, Any]:
    rows = []
    for signal, entry in replay.comparison().report().items():
        for name, found in entry["joints"].items():
            cells = [found[key] for key in ("rms", "mean", "max", "correlation")]
            rows.append([f"{name}, {signal} ({entry['unit']})", *("-" if c is None else f"{c:.4f}" for c in cells)])
    derived = (
        " The recording has no velocities: they were made from its positions." if replay.comparison().derived else ""
    )
    return {
        "title": "Recorded against simulated",
        "head": ["simulated minus recorded", "RMS", "mean", "largest", "correlation"],
        "rows": rows,
        "note": f"Recorded: {Path((replay.measured or replay.recorded).source.name).name}.{derived}",
    }


def _tracking_figure(replay: Replay) -> dict[str, str]:
    lines = {
        "recorded": Line(replay.recorded.times, replay.recorded.positions, INK, dashed=True),
        "played": Line(replay.played.times, replay.played.positions, BLUE),
    }
    limits = JOINT_POSITION_LOW, JOINT_POSITION_HIGH
    caption = "What was recorded and what was played. Red lines are the joints' limits, where they come into sight."
    return figure("Positions", joint_panels(lines, "rad", limits), caption)


def _motor_figures(replay: Replay) -> list[dict[str, str]]:
    saturation = replay.saturation()
    assert saturation is not None
    assert replay.played.efforts is not None
    assert replay.played.velocities is not None
    times = replay.played.times
    motors = [replay.motors.of_joint(name) for name in JOINT_NAMES]
    stall, top = (np.array([getattr(motor, name) for motor in motors]) for name in ("stall_torque", "no_load_speed"))
    torque = {
        "wanted": Line(times, np.clip(saturation.asked, -2 * stall, 2 * stall), VERMILION),
        "given": Line(times, replay.played.efforts, BLUE),
    }
    speed = {"played": Line(times, replay.played.velocities, BLUE)}
    return [
        figure(
            "Torques",
            joint_panels(torque, "N m", (-stall, stall)),
            "What the controllers wanted (drawn up to twice the limit) and what the motors gave.",
        ),
        figure(
            "Speeds",
            joint_panels(speed, "rad/s", (-top, top)),
            "What the joints did. Red lines are the speeds that the motors reach without load.",
        ),
    ]


def _comparison_figures(replay: Replay) -> list[dict[str, str]]:
    signals = replay.comparison()
    return [
        figure(
            f"Recorded and simulated {name}",
            joint_panels(
                {
                    "recorded": Line(signals.times, signals.recorded[name], INK),
                    "simulated": Line(signals.times, signals.simulated[name], BLUE),
                },
                SIGNALS[name],
            ),
            "At the times of the simulation that the recording covers.",
        )
        for name in signals.recorded
    ]
