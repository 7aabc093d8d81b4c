"""What pytest hands to the tests that ask for it by name."""

import pytest
from hypothesis import HealthCheck, settings

from given.motions import LAWS, paper_motion

# How long an example takes depends on what else the machine does.
anywhere = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("test", anywhere, max_examples=25)
settings.register_profile("soak", anywhere, max_examples=100)
settings.load_profile("test")


@pytest.fixture(scope="session", params=LAWS, ids=lambda law: law.name)
def motion(request):
    """Three near-collisions of the paper's can, with the digits that finite differences need."""
    return paper_motion(request.param, rtol=1e-13)
