"""The HTML report of a replay: tracking errors, motor limits, and figures of both."""

from pathlib import Path
from typing import Final

import numpy as np

from quadruped_env.replay.replay import Replay
from quadruped_env.replay.signal_comparison import SIGNALS, common_signals
from quadruped_env.report.pages.page import figure, provenance, write_html
from quadruped_env.report.palette import BLUE, INK, VERMILION
from quadruped_env.report.plots.joint_plots import Line, joint_panels
from quadruped_env.report.report_directory import REPORT_FILE
from quadruped_env.ros.timestamps import NS_PER_SECOND

_GOOD: Final = 0.05
"""Maximum RMS tracking error of a good replay, rad; the robot also stays on its feet."""


def write_replay_report(replay: Replay, directory: Path, command_line: str, compare: bool = False) -> None:
    """Write `report.html` into a directory; an existing file is replaced.

    Args:
        replay: replay to report.
        directory: where to write.
        command_line: command that reproduces the report.
        compare: True to show recorded against simulated positions, velocities and efforts.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if the file cannot be written, or `measured` has no time in common with the replay.
    """
    error = replay.report["tracking_error"]["all"]
    fell = replay.motion is not None and replay.motion.fell_at is not None
    tracks = error["rms"] < _GOOD and (replay.motion is None or replay.motion.stayed_on_its_feet)
    figures = [_tracking_figure(replay)]
    if replay.motion is not None:
        figures += _motor_figures(replay)
    if compare:
        figures += _comparison_figures(replay)
    context = {
        "title": f"Replay of {Path(replay.recorded.source.name).name}, {replay.mode}",
        "headline": f"Tracking error of the joints: {error['rms']:.4f} rad RMS, {error['max']:.4f} rad maximum.",
        "level": "poor" if fell else "good" if tracks else "fair",
        "remarks": replay.remarks(),
        "tables": replay.tables(compare),
        "figures": figures,
        "document": provenance(command_line),
        "motors": replay.motors.to_dict(),
    }
    write_html(directory / REPORT_FILE, "motion.html", context)


def _tracking_figure(replay: Replay) -> dict[str, str]:
    lines = {
        "recorded": Line(replay.recorded.times, replay.recorded.positions, INK, dashed=True),
        "played": Line(replay.played.times, replay.played.positions, BLUE),
    }
    limits = replay.robot.joint_position_low, replay.robot.joint_position_high
    caption = "Recorded and played positions. Red lines are the joint limits, where they are within the plotted range."
    return figure("Positions", joint_panels(replay.robot, lines, "rad", limits), caption)


def _motor_figures(replay: Replay) -> list[dict[str, str]]:
    asked, _ = replay.torques
    assert replay.played.efforts is not None
    assert replay.played.velocities is not None
    times = replay.played.times
    motors = replay.motors.of_joints(replay.robot.joint_kinds)
    stall, top = (np.array([getattr(motor, name) for motor in motors]) for name in ("stall_torque", "no_load_speed"))
    torque = {
        "requested": Line(times, np.clip(asked, -2 * stall, 2 * stall), VERMILION),
        "applied": Line(times, replay.played.efforts, BLUE),
    }
    speed = {"played": Line(times, replay.played.velocities, BLUE)}
    return [
        figure(
            "Torques",
            joint_panels(replay.robot, torque, "N m", (-stall, stall)),
            "Torques that the controllers requested (clipped at twice the limit) and that the motors applied.",
        ),
        figure(
            "Speeds",
            joint_panels(replay.robot, speed, "rad/s", (-top, top)),
            "Speeds of the joints. Red lines are the no-load speeds of the motors.",
        ),
    ]


def _comparison_figures(replay: Replay) -> list[dict[str, str]]:
    recorded, simulated = replay.comparison
    times = recorded.times + (int(recorded.stamps[0]) - int(replay.played.stamps[0])) / NS_PER_SECOND
    return [
        figure(
            f"Recorded and simulated {name}",
            joint_panels(
                replay.robot,
                {
                    "recorded": Line(times, here, INK),
                    "simulated": Line(times, there, BLUE),
                },
                SIGNALS[name],
            ),
            "At the times of the simulation that the recording covers.",
        )
        for name, (here, there) in common_signals(recorded, simulated).items()
    ]
