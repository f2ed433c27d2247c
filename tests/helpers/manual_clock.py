"""A clock for tests of timing."""


class ManualClock:
    """A clock that the test sets."""

    now = 100.0

    def __call__(self):
        return self.now
