"""Fixtures of the tests of the simulation."""

import pytest


@pytest.fixture(params=["singles", "2 threads"])
def driver(request):
    return request.param
