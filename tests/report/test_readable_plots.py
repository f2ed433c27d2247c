"""Figures of reports on a page of 400 px: the size of their text, and that no text covers another."""

import itertools

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.report.plots.canvas import draw_estimates, draw_figure, legend_above
from quadruped_env.report.plots.motion_plots import _shown_samples

PAGE, MARGINS = 400.0, 2 * 0.9 * 16.0
"""Width of the page and of its margins (templates/base.html), CSS pixels."""
SMALLEST = 10.0
"""Least font size on that page, CSS pixels; browsers' own controls have 11 to 13."""


def texts(figure):
    """Every text that is drawn."""
    found = [*figure.texts]
    for legend in [*figure.legends, *filter(None, (ax.get_legend() for ax in figure.axes))]:
        found += legend.get_texts()
    for ax in figure.axes:
        if not ax.get_visible():
            continue
        found += [ax.title, ax._left_title, ax._right_title]
        for axis in (ax.xaxis, ax.yaxis):
            found.append(axis.label)
            if axis.get_visible():
                found += [label for tick in axis._update_ticks() for label in (tick.label1, tick.label2)]
    return [text for text in found if text.get_visible() and text.get_text().strip()]


def test_text_is_large_enough(written):
    assert len(written.figures) >= 5
    for figure in written.figures:
        width = figure.get_figwidth()
        for text in texts(figure):
            size = text.get_fontsize() / 72.0 * (PAGE - MARGINS) / width
            assert size >= SMALLEST, f"{text.get_text()!r}: {size:.1f} px"


def test_no_text_covers_another_or_leaves_the_figure(written):
    for figure in written.figures:
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        whole = figure.bbox
        boxes = [(text.get_text(), text.get_window_extent(canvas.get_renderer())) for text in texts(figure)]
        assert len(boxes) > 5
        for name, box in boxes:
            ends = np.array([box.x0 - whole.x0, whole.x1 - box.x1, box.y0 - whole.y0, whole.y1 - box.y1])
            assert ends.min() >= -1.0, f"{name!r} leaves the figure"
        for (name, box), (other, second) in itertools.combinations(boxes, 2):
            across = min(box.x1, second.x1) - max(box.x0, second.x0)
            along = min(box.y1, second.y1) - max(box.y0, second.y0)
            assert not (across > 1.0 and along > 1.0), f"{name!r} covers {other!r}"


@pytest.mark.parametrize("name", ["flat", "20261128-124312-soft", "20261128-124312-a-longer-name"])
def test_legend_of_runs_stays_within_the_figure(name):
    def draw(axes):
        names = [f"{name}{i}" for i in range(6)]
        for each in names:
            axes[0, 0].plot([0, 1], label=each)
        legend_above(axes[0, 0].figure, 3)
        figure = axes[0, 0].figure
        FigureCanvasAgg(figure).draw()
        box = figure.legends[-1].get_window_extent()
        assert len(figure.legends) == 1
        assert box.x0 >= 0.0
        assert box.x1 <= figure.bbox.x1

    draw_figure(1, 1, 3.0, draw)


def test_bars_reach_from_the_low_to_the_high_end():
    def draw(axes):
        found = [Estimate(1.0, 0.5, 3.0, 8), Estimate(2.0, 1.5, 2.25, 8)]
        draw_estimates(axes[0, 0], np.array([0.0, 1.0]), found)
        (bars,) = axes[0, 0].collections
        assert [bar[:, 1].tolist() for bar in bars.get_segments()] == [[0.5, 3.0], [1.5, 2.25]]

    draw_figure(1, 1, 3.0, draw)


@pytest.mark.parametrize(("alive", "first", "last"), [(200, 50, 149), (120, 20, 119), (60, 0, 59)])
def test_gait_is_shown_after_the_start_up_and_earlier_for_early_falls(alive, first, last):
    samples = _shown_samples(np.arange(200)[:, None] < alive, 0.02, 2.0)
    assert (samples[0], samples[-1]) == (first, last)
