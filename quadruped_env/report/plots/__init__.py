"""Figures of a report: functions that turn results into SVG documents in one style (`quadruped.mplstyle`)."""

from quadruped_env.report.plots.effort_plots import cost_over_speed, mean_terms, motor_limits
from quadruped_env.report.plots.learning_plots import LEARNING_CURVES, learning_curve, read_progress, term_curves
from quadruped_env.report.plots.motion_plots import episode, gait_diagram, tracking

__all__ = [
    "LEARNING_CURVES",
    "cost_over_speed",
    "episode",
    "gait_diagram",
    "learning_curve",
    "mean_terms",
    "motor_limits",
    "read_progress",
    "term_curves",
    "tracking",
]
