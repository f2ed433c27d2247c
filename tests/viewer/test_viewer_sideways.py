"""The viewer of a robot that moves sideways: its third command, its keys, sliders and charts, and the arrow of it."""

import math

import numpy as np
import pytest
from twelve_joints import ROBOT
from viewing import now, robot

from quadruped_env.control.steering import key_steps
from quadruped_env.policies import ControllerSpec, ZeroController
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig
from quadruped_env.viewer import Show, ViewController
from quadruped_env.viewer.panel_text import key_html, keys_html, status_html
from quadruped_env.viewer.viewed_robot import Offered
from quadruped_env.viewer.viewer_scene import _METRES_PER_VELOCITY

RANGES = [entry.range for entry in TaskConfig().for_robot(ROBOT).commands]


class Standing(ZeroController):
    """Stands, but shows the command."""

    def __init__(self):
        super().__init__("position")
        self.follows_command = True


@pytest.fixture
def controller(tmp_path):
    made = ViewController({"standing": ControllerSpec("standing", Standing)}, ["standing"], tmp_path, ROBOT)
    yield made
    made.close()


def test_a_command_has_three_velocities_within_their_ranges(controller):
    assert controller.command == (0.0, 0.0, 0.0)
    assert controller.set_command(0.1, -0.2, 0.1) == (0.1, -0.2, 0.1)
    assert controller.set_command(0.0, 0.0, -9.0) == (0.0, 0.0, pytest.approx(RANGES[2][0], abs=0.01))
    assert controller.set_command(0.3, 0.2) == (0.3, 0.2, 0.0)
    controller.step()
    np.testing.assert_array_equal(now(controller).command, [0.3, 0.2, 0.0])
    assert now(controller).smooth_velocity.shape == now(controller).velocity.shape == (3,)
    # The robot's own, not the built-in one's, to the hundredth below.
    assert [entry.name for entry in controller.command_ranges] == ["forward_velocity", "yaw_rate", "lateral_velocity"]
    for entry, own in zip(controller.command_ranges, RANGES, strict=True):
        assert np.array(entry.range) * 100 == pytest.approx(np.trunc(np.array(own) * 100))


def test_keys_change_the_lateral_velocity_in_steps(controller):
    size = key_steps(ROBOT)[2]
    assert controller.nudge(0, 0, 1) == (0.0, 0.0, pytest.approx(size))
    assert controller.nudge(1) == (pytest.approx(key_steps(ROBOT)[0]), 0.0, pytest.approx(size))
    assert controller.nudge(0, 0, -2)[2] == pytest.approx(-size)


def test_only_a_robot_that_moves_sideways_has_keys_for_it():
    assert "<b>Q E</b> sideways" in keys_html(ROBOT, Offered())
    assert "sideways" not in keys_html(MINI_QUADRUPED, Offered())
    assert "'Space', 'KeyQ', 'KeyE']" in key_html(ROBOT)
    assert "'ArrowRight', 'Space'];" in key_html(MINI_QUADRUPED)


def test_status_shows_three_velocities(controller):
    controller.set_command(0.1, 0.2, 0.15)
    controller.step()
    shown = status_html(controller.view())
    assert [f"of {asked} {unit}" in shown for asked, unit in (("0.10", "m/s"), ("0.20", "rad/s"))] == [True, True]
    assert "of 0.15 m/s to the left" in shown


def test_page_has_a_slider_and_a_chart_of_the_lateral_velocity_and_its_arrow_points_there(controller):
    pytest.importorskip("viser")
    pytest.importorskip("mjviser")
    controller.paused = True
    show = Show(controller, port=0)
    try:
        assert [slider.label for slider in show.panel._velocities] == [
            "Forward, m/s", "Turn left, rad/s", "To the left, m/s",
        ]  # fmt: skip
        assert [chart.handles[0].content.count("Lateral velocity, m/s") for chart in show._plots._velocities] == [
            0,
            0,
            1,
        ]
        data = robot(controller).data
        heading = 0.5
        data.qpos[3:7] = [math.cos(heading / 2), 0.0, 0.0, math.sin(heading / 2)]
        controller.set_command(0.02, 0.0, 0.16)
        controller.step()
        show.draw(controller.view())
        assert [slider.value for slider in show.panel._velocities] == [0.02, 0.0, 0.16]
        (arrow,) = show._scene._velocities.points  # the measured velocity is too small for one
        angle = controller.view().robots[0].heading + math.atan2(0.16, 0.02)
        expected = math.hypot(0.02, 0.16) * _METRES_PER_VELOCITY * np.array([math.cos(angle), math.sin(angle), 0.0])
        np.testing.assert_allclose(arrow[1] - arrow[0], expected, atol=1e-6)
    finally:
        show.close()
