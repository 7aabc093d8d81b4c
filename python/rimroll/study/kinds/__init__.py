"""The kinds of studies, by name."""

from __future__ import annotations

from collections.abc import Mapping

from rimroll.study.kinds.falls import ENSEMBLE, EXACT_TURN, TOPPLE
from rimroll.study.kinds.fit import FIT
from rimroll.study.kinds.kind import Kind, Result
from rimroll.study.kinds.shake import SHAKE

KINDS: Mapping[str, Kind] = {kind.name: kind for kind in (ENSEMBLE, TOPPLE, EXACT_TURN, SHAKE, FIT)}

__all__ = ["KINDS", "Kind", "Result"]
