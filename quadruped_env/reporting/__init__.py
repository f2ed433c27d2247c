"""Pages, figures and films made from the results of an evaluation."""
