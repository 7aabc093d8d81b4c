"""Fixtures."""

import pytest
from hypothesis import HealthCheck, settings

from given.motions import LAWS, paper_motion

# The time of an example depends on other work on the machine.
anywhere = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
# `make test` draws the same examples in each run, so what passes keeps passing. `make soak` draws
# new ones.
settings.register_profile("test", anywhere, max_examples=25, derandomize=True)
settings.register_profile("soak", anywhere, max_examples=100)
settings.load_profile("test")


@pytest.fixture(scope="session", params=LAWS, ids=lambda law: law.name)
def motion(request):
    """Three near-collisions of the paper's can, accurate enough for finite differences."""
    return paper_motion(request.param, rtol=1e-13)
