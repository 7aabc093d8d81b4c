"""Formats of records that are not read: by what they are known, and how to read them."""

from __future__ import annotations

import re

from rimroll.errors import RimrollError

OBSPY = 'read it with ObsPy: rr.ground.from_obspy(obspy.read(FILE), "m/s2")'
TABLE = (
    "write its accelerations as a CSV file with the columns t (s), ax (m/s2), ay (m/s2), az (m/s2)"
)
NUMBERS = (
    "keep its numbers, one a line, and give their step and unit, as in --step 0.01s --units cm/s2"
)

_FORMATS = (
    (r"\AOrigin Time\b[\s\S]*^Sampling Freq", "K-NET or KiK-net", OBSPY),
    (r"^EVENT_NAME:[\s\S]*^(EVENT_ID|SAMPLING_INTERVAL_S|STATION_CODE|STREAM|UNITS):", "ESM (DYNA)",
     NUMBERS),
    (r"\A[\s\S]{0,400}\(Format v[\s\d.]+ with", "COSMOS", NUMBERS),
    (r"\A\s*\d?\s*(UN)?CORRECTED ACCELEROGRAM[^\n]*\n\*", "SMC (USGS)", NUMBERS),
    (r"\A[\s\S]{0,400}\b(UN)?CORRECTED ACCELEROGRAM", "CSMIP and USGS (V1, V2)", NUMBERS),
    (r"STRONG[ -](GROUND[ -])?MOTION RECORDS? OF T|^(PLACE|EARTHQUAKE DATE|STATION ID)\s*:[\s\S]*"
     r"^(SAMPLING INTERVAL|NUMBER OF DATA|RAW[_ ]PGA)", "AFAD", NUMBERS),
)  # fmt: skip

HEAD = 5000
"""Characters in which a format is looked for."""


def refuse_other_format(name: str, text: str) -> None:
    """Raise ``RimrollError`` for a file in a format of records that is known and not read."""
    for pattern, called, way_out in _FORMATS:
        if re.search(pattern, text[:HEAD], re.IGNORECASE | re.MULTILINE):
            raise RimrollError(
                f"{name} is in the format of {called}, which rimroll does not read: {way_out}, or"
                f" {TABLE}"
            )
