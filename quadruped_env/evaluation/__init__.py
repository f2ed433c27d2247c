"""How good was it: rollouts, metrics, statistics, plots and reports."""
