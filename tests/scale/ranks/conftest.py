"""The run that the tests of ranks go on from."""

from trainings import run  # noqa: F401  a fixture
