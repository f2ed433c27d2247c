"""The HTML pages that a person reads: reports of a policy, of several, and of a replay."""
