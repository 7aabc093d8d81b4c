"""How motions and falls end: the names that data has for it, and the words that people read."""

from __future__ import annotations

STATUSES = {
    "finished": "was followed for the whole duration",
    "toppled": "reached the topple tilt",
    "lifted_off": "would have left the table, under a law without flight",
    "face_down": "came down flat",
    "at_rest": "came to rest",
    "painleve": "met Painlevé's paradox",
    "failed": "could not be computed further",
}
"""How a motion ends (``Motion.status``), and what that means."""

OUTCOMES = {
    "toppled": "passed a tilt minimum, then reached the topple tilt; or, under a law without"
    " flight, lifted off beyond the balance tilt",
    "rocked": "passed a tilt minimum, then a tilt maximum",
    "fell_back": "fell over without a tilt minimum after the release",
    "hovered": "did none of these in the time given",
    "lifted_off": STATUSES["lifted_off"],
    "face_down": STATUSES["face_down"],
    "at_rest": STATUSES["at_rest"],
    "painleve": STATUSES["painleve"],
    "failed": "could not be computed",
}
"""The outcomes of a fall (``outcome`` in :func:`rimroll.ensemble`), and what they mean."""

FELL = ("toppled", "rocked")
"""The outcomes that have a direction: that of the fall, or that of the largest tilt."""


def ending_in_words(name: str) -> str:
    """A status, an outcome or the kind of an event as people read it: ``fell back``."""
    return name.replace("_", " ").replace("painleve", "Painlevé")
