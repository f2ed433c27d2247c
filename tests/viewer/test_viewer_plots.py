"""The viewer's plots."""

from xml.etree import ElementTree

import numpy as np
import pytest
from viewing import DT

from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.viewer.live_plots import GAIT_SECONDS, gait_diagram, reward_bars


def test_the_gait_diagram_shows_each_stance_once():
    contact = np.zeros((100, 4), bool)
    contact[10:30, 0] = contact[50:60, 0] = contact[90:, 0] = contact[:, 3] = True
    html = gait_diagram(MINI_QUADRUPED, contact, DT)
    svg = ElementTree.fromstring(html[html.index("<svg") :])  # noqa: S314
    bars = [node for node in svg.iter("rect") if node.get("fill") != "#EEF1F4"]
    right, scale = 360, 330 / GAIT_SECONDS
    assert [float(bar.get("width")) for bar in bars] == [
        pytest.approx(n * DT * scale, abs=0.06) for n in (20, 10, 10, 100)
    ]
    assert float(bars[0].get("x")) == pytest.approx(right - 90 * DT * scale, abs=0.06)
    assert [node.text for node in svg.iter("text")][:4] == ["LF", "RF", "LH", "RH"]


def test_the_reward_bars_add_up():
    html = reward_bars(["track_forward_velocity", "fall"], np.array([1.5, -0.25]))
    table = ElementTree.fromstring(html[html.index("<table") :])  # noqa: S314
    assert [[cell.text for cell in row][::2] for row in table] == [
        ["track forward velocity", "+1.50"],
        ["fall", "-0.25"],
        ["sum", "+1.25"],
    ]
