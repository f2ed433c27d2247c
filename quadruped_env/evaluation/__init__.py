"""Evaluation of controllers: rollouts, metrics, confidence intervals, comparisons and verdicts."""
