"""Reports on a robot that moves sideways: its tables, figures, film and suite."""

import re

import numpy as np
import pytest
from synthetic import synthetic_rollout
from twelve_joints import ROBOT

from quadruped_env.evaluation.comparison import run
from quadruped_env.policies import ZeroController
from quadruped_env.report.films import overlay
from quadruped_env.report.pages import clips, report, suite_section
from quadruped_env.report.pages.run_comparison import headline
from quadruped_env.report.pages.tables import metric_tables, summary_table
from quadruped_env.report.plots import episode, tracking
from quadruped_env.report.plots.suite_plots import command_map
from quadruped_env.task import TaskConfig

COMMANDS = ((0.3, 0.0, 0.0), (0.0, 0.5, 0.0), (0.0, 0.0, 0.15), (0.3, 0.0, -0.15))


@pytest.fixture(scope="module")
def standing():
    """A comparison of two standing robots."""
    controllers = {name: ZeroController("position") for name in ("policy", "zero")}
    return run(controllers, {}, TaskConfig().for_robot(ROBOT), COMMANDS, 2, 2.5)


def titles(svg):
    """Texts of a figure, which are comments next to their shapes."""
    return re.findall(r"<!-- (.*?) -->", svg)


def test_tables_have_sideways_rows(standing):
    assert "Sideways: lateral velocity error (m/s)  0.150 [0.150, 0.150]" in summary_table(standing)
    table = next(table for table in metric_tables(standing) if table.title == "Sideways")
    assert table.note == "0.15 m/s to the left; 0.3 m/s and 0.15 m/s to the right"
    rows = {row[0]: row[1] for row in table.rows}
    assert rows["Lateral velocity error\nm/s"].startswith("0.150")
    assert rows["Lateral velocity\nm/s"].startswith("0.000")
    assert headline(standing, ["policy", "zero"]) == "All are equally accurate forwards, turning and sideways."


def test_figures_have_a_panel_of_the_lateral_velocity(standing):
    panels = ["forward velocity (m/s)", "yaw rate (rad/s)", "lateral velocity (m/s)"]
    found = titles(tracking(standing))
    assert [title for title in found if title in panels] == panels
    assert [title for title in titles(episode(standing, "policy", 4)) if title in panels] == panels


def test_page_names_the_three_velocities():
    sideways = report._description(TaskConfig().for_robot(ROBOT))
    assert "commands of forward velocity, yaw rate and lateral velocity." in sideways
    assert "commands of forward velocity and yaw rate." in report._description(TaskConfig())
    soft = {"kp": 1.0}
    described = report._description(TaskConfig.from_dict({"motor": {"hip": soft, "knee": soft}}))
    assert "For a trot it lacks: kp 1 N m/rad: " in described, "of the task's motors"
    assert report._velocities(ROBOT, "tilt") == "forward velocity, yaw rate, lateral velocity and tilt"


def test_film_shows_the_robot_sideways(standing):
    assert [clip.title for clip in clips.filmed(standing)] == [
        "forwards: 0.3 m/s", "turning: 0.5 rad/s", "sideways: 0.15 m/s to the left",
    ]  # fmt: skip


def test_overlay_has_a_third_bar():
    shape = {"joint_position": np.tile(ROBOT.stance, (2, 1, 1)), "joint_velocity": np.zeros((2, 1, 12))}
    velocity = np.tile([0.0, 0.0, -0.3], (2, 1, 1))
    trace = synthetic_rollout(
        2, robot=ROBOT, **shape, joint_torque=np.zeros((2, 1, 12)), velocity=velocity, command=0 * velocity
    ).env(0)
    drawn = overlay.Overlay("", trace).draw(np.zeros((480, 640, 3), np.uint8), 1)
    blue = np.array([int(overlay.ACTUAL[i : i + 2], 16) for i in (1, 3, 5)])
    top = 480 - overlay._PANEL_HEIGHT - overlay._ROW_HEIGHT + 14 + 8
    filled = [np.flatnonzero((drawn[top + overlay._ROW_HEIGHT * row] == blue).all(axis=-1)) for row in range(3)]
    middle = (overlay._BAR_LEFT + overlay._BAR_RIGHT) / 2
    assert [len(columns) for columns in filled[:2]] == [0, 0]
    assert filled[2].min() == pytest.approx((overlay._BAR_LEFT + middle) / 2, abs=2)
    assert filled[2].max() == pytest.approx(middle, abs=2)


def test_map_of_commands_has_a_strip_of_the_lateral_velocity():
    errors = {f"{name}_error": {"signed": [0.0, 0.1]} for name in ("forward_velocity", "yaw_rate", "lateral_velocity")}
    commands = {"commands": [[0.1, 0.2, 0.1], [0.3, 0.0, -0.1]], "fall_share": [0.0, 1.0], **errors}
    found = titles(command_map({"commands": commands}))
    assert [title for title in found if title.startswith("error")] == [
        "error of forward velocity (m/s)", "error of yaw rate (rad/s)", "error of lateral velocity (m/s)",
    ]  # fmt: skip
    assert found.count("commanded lateral velocity (m/s)") == 1
    assert found.count("commanded yaw rate (rad/s)") == 2


def test_suite_names_lateral_commands_and_errors():
    known = {"mean": 0.5, "low": 0.4, "high": 0.6}
    law = {"robot_hours": 1.0, "falls_per_hour": known, "mean_error": [0.1, 0.2, 0.05], "accuracy": known}
    table = suite_section._joystick({"joystick": {"laws": {"undisturbed": law}}})
    assert list(zip(table.head, table.rows[0], strict=True))[3:6] == [
        ("speed error (m/s)", "0.100"), ("yaw error (rad/s)", "0.200"), ("sideways error (m/s)", "0.050"),
    ]  # fmt: skip
    envelope = {"forwards": 0.5, "left": 0.8, "sideways_left": 0.2}
    assert suite_section._envelope({"commands": {"envelope": envelope}}) == (
        "forwards 0.5 m/s, left 0.8 rad/s, sideways to the left 0.2 m/s"
    )
    entry = {"command": [0.0, 0.0, 0.15], "share": [None, None, 0.9]}
    one = {"kept": known, "falls": known, "commands": [entry]}
    table = suite_section._regulation({"regulation": {"disturbances": {"nominal": one}}})
    assert (table.head[-1], table.rows[0][-1]) == ("0 m/s, 0 rad/s, 0.15 m/s", "90")
    assert "commanded speed, yaw rate and lateral velocity that are kept" in table.note
