"""An engine whose best settings can be searched for."""

from dataclasses import replace

import numpy as np

from rimroll_score.adapters.rimroll_itself import Rimroll


class Tuned(Rimroll):
    """rimroll, but the can is this far too high (m)."""

    best = {"off": 0.0, "idle": 1}  # noqa: RUF012
    choices = {"off": [0.0, 1e-4, 0.1], "idle": [1, 2]}  # noqa: RUF012

    def state(self):
        now = super().state()
        return replace(now, position=np.add(now.position, [0.0, 0.0, self.best["off"]]))
