"""Runs a JSON list of Python codes from stdin, each of which computes a ``motion``.

Writes one JSON line for each: the status, the columns as doubles in base64, and the printed text.
"""

import base64
import contextlib
import io
import json
import sys

import numpy as np

from rimroll.motion import UNITS

for code in json.load(sys.stdin):
    names: dict = {}
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(code, names)
    motion = names["motion"]
    columns = {
        name: base64.b64encode(np.asarray(motion[name], "<f8").tobytes()).decode() for name in UNITS
    }
    answer = {"status": motion.status, "columns": columns, "printed": printed.getvalue()}
    print(json.dumps(answer))
