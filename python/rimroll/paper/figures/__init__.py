"""The figures of the report, in its order; one file each."""

from __future__ import annotations

from collections.abc import Callable

from rimroll.paper.drawing import Drawing

FIGURES: tuple[Callable[[], Drawing], ...] = ()
