"""Figures of the joints over time: the samples of a long log that are drawn."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from quadruped_env.report.plots.joint_plots import Line, joint_panels
from quadruped_env.robot import MINI_QUADRUPED

ROWS = 200_000
JOINT = 3
PANEL = f"axes_{JOINT + 1}"


def drawn_line(values):
    """x and y (N, 2), in points, of the line of joint JOINT in the figure of values (T, 8); NaN where it is broken."""
    figure = joint_panels(MINI_QUADRUPED, {"played": Line(np.arange(len(values)) * 0.001, values, "#0000ff")}, "rad")
    svg = ElementTree.fromstring(figure)  # noqa: S314  made here
    (panel,) = (group for group in svg.iter() if group.get("id") == PANEL)
    paths = [path.get("d") for group in panel for path in group if (group.get("id") or "").startswith("line2d")]
    line = max(paths, key=len)
    return np.array([[float(x), float(y)] for x, y in re.findall(r"[ML] (\S+) (\S+)", line)]), line.count("M")


@pytest.mark.parametrize("peak", [-1.0, 1.0])
def test_joint_panels_with_a_peak_of_one_row_in_a_long_log_draws_it(peak):
    values = np.zeros((ROWS, 8))
    values[123_457, JOINT] = peak
    line, _ = drawn_line(values)
    heights = line[:, 1]
    # The axis is scaled to what is drawn: the peak is as far from the others as the panel is high, less its margins.
    flat = np.median(heights)
    assert np.abs(heights - flat).max() > 50.0
    assert np.count_nonzero(np.abs(heights - flat) > 1.0) == 1
    assert np.sign(flat - heights[np.abs(heights - flat).argmax()]) == peak  # y of SVG points down
    times = (line[:, 0] - line[0, 0]) / (line[-1, 0] - line[0, 0])
    assert times[np.abs(heights - flat).argmax()] == pytest.approx(123_457 / ROWS, abs=1e-3)


def test_joint_panels_of_a_long_log_draws_few_points():
    values = np.random.default_rng(0).normal(size=(ROWS, 8))
    line, _ = drawn_line(values)
    assert 400 < len(line) <= 1500


def test_joint_panels_with_a_hole_in_a_long_log_leaves_it_open():
    values = np.random.default_rng(0).normal(size=(ROWS, 8))
    values[50_000:60_000] = np.nan
    _, parts = drawn_line(values)
    assert parts == 2


def test_joint_panels_of_a_short_log_draws_every_row():
    values = np.random.default_rng(0).normal(size=(100, 8))  # from 128 on, matplotlib simplifies lines
    line, _ = drawn_line(values)
    assert len(line) == 100
