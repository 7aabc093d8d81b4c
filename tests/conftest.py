"""What pytest hands to the tests that ask for it by name."""

import pytest

from motions import LAWS, paper_motion


@pytest.fixture(scope="session", params=LAWS, ids=lambda law: law.name)
def motion(request):
    """Three near-collisions of the paper's can, with the digits that finite differences need."""
    return paper_motion(request.param, rtol=1e-13)
