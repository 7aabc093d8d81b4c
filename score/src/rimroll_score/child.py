"""The process in which an engine runs: it reads tasks and answers each on a line.

Run as a script by any Python that has NumPy and the engine; it finds the rest of this package
beside itself. What the engine prints goes to stderr.
"""

from __future__ import annotations

import importlib.util
import json
import os
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np


def main(place: str) -> None:
    """Answer tasks with the adapter at that place until stdin ends."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # engines greet on stdout
    for line in sys.stdin:
        answers.write(json.dumps(answered(place, json.loads(line))) + "\n")
        answers.flush()


def answered(place: str, task: dict[str, Any]) -> dict[str, Any]:
    """The answer to a task; what went wrong is its ``status`` and ``message``."""
    from rimroll_score.protocol import Unsupported
    from rimroll_score.registry import load
    from rimroll_score.samples import BadSample

    try:
        adapter = load(place)
    except ImportError as error:
        return {"status": "missing", "message": f"{error}"}
    except Exception as error:
        return {"status": "raised", "message": f"{type(error).__name__}: {error}"}
    try:
        return described(adapter) if task["task"] == "describe" else computed(adapter, task)
    except Unsupported as reason:
        return {"status": "unsupported", "message": str(reason)}
    except BadSample as reason:
        return {"status": "invalid", "message": str(reason)}
    except Exception as error:
        return {"status": "raised", "message": f"{type(error).__name__}: {error}"}


def described(adapter: Any) -> dict[str, Any]:
    """The engine's version and settings."""
    version, known = str(adapter().version()), adapter.known_versions
    answer = {
        "status": "ok", "version": version, "settings": dict(adapter.settings),
        "best": dict(getattr(adapter, "best", {})),
        "choices": dict(getattr(adapter, "choices", {})),
    }  # fmt: skip
    if not version.startswith(known):
        named = known if isinstance(known, str) else " or ".join(known)
        answer["warning"] = f"the adapter was written for version {named}, this is {version}"
    return answer


def computed(adapter: Any, task: dict[str, Any]) -> dict[str, Any]:
    """Run a motion, save its samples and return the processor time of its steps."""
    from rimroll_score.protocol import Body, Scene, State, Unsupported
    from rimroll_score.samples import Recorder

    scene = Scene(**{**task["scene"], "body": Body(**task["scene"]["body"])})
    start = State(**{name: np.array(value) for name, value in task["state"].items()})
    dt, every = task["dt"], task["every"]
    if scene.table_acceleration and not getattr(adapter, "moves_table", False):
        why = getattr(adapter, "why_table_rests", "the adapter does not move the table")
        raise Unsupported(why)
    engine = adapter()
    if task["changes"]:
        engine.best = {**adapter.best, **task["changes"]}
    departures = list(engine.make(scene, dt, task["setting"]))
    engine.set_state(start)
    recorder = Recorder(dt)
    recorder.add(engine.time(), 0.0, engine.state())
    spent = 0.0
    for sample in range(1, task["samples"] + 1):
        before = time.process_time()
        for _ in range(every):
            engine.step()
        spent += time.process_time() - before
        recorder.add(engine.time(), sample * every * dt, engine.state())
    recorder.samples(task["samples"] + 1).save(Path(task["save"]))
    simulated = task["samples"] * every * dt
    return {"status": "ok", "departures": departures, "cost": spent / simulated}


def _package() -> None:
    """Make ``rimroll_score`` importable from this file's folder, and nothing else from there."""
    folder = Path(__file__).parent
    spec = importlib.util.spec_from_file_location(
        "rimroll_score", folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["rimroll_score"] = module
    spec.loader.exec_module(module)


if __name__ == "__main__":
    _package()
    main(sys.argv[1])
