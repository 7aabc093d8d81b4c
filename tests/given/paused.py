"""Stops a process that computes a study at a definite place, so that it can be killed there.

Loaded by ``pause()``, or by a Dask worker as ``--preload given.paused``. The variable RIMROLL_PAUSE
holds what to do, where, and a folder: ``wait mark FOLDER``. The process writes its number to
``FOLDER/reached`` and waits until that file is removed; or it kills itself. ``wait mark@5 FOLDER``
lets it pass the place five times before.
"""

import os
import signal
import time
from itertools import count
from pathlib import Path


def pause():
    """Take part in what RIMROLL_PAUSE says."""
    what, where, folder = os.environ["RIMROLL_PAUSE"].split(" ", 2)
    where, _, passed = where.partition("@")
    reached = Path(folder) / "reached"
    times = count()

    def stop():
        if next(times) < int(passed or 0):
            return
        if what == "die":
            os.kill(os.getpid(), signal.SIGKILL)
        part = reached.with_name("reached.part")
        part.write_text(str(os.getpid()))
        part.replace(reached)
        while reached.exists():
            time.sleep(0.02)

    from rimroll.study.chunks import Marks
    from rimroll.study.plan import Plan

    owner, name = {"compute": (Plan, "compute"), "mark": (Marks, "add")}[where]
    usual = getattr(owner, name)

    def stopping(self, *arguments, **options):
        # A mark is not yet written, a chunk not yet computed: only after what was planned.
        if where == "mark" or arguments[0] > 0:
            stop()
        return usual(self, *arguments, **options)

    setattr(owner, name, stopping)


pause()
