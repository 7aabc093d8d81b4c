"""Runs pieces of Python code, a JSON list of them on stdin, each of which leaves a ``motion``.

Answers with one JSON line for each: its status, its columns as doubles in base64, what it printed.
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
