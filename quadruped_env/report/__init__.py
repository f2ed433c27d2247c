"""HTML reports, figures and films of evaluations, replays and identifications."""
