"""A badge for a README: the largest step with which an engine stays within the bounds."""

from __future__ import annotations

from rimroll_score.page import Bounds, in_ms
from rimroll_score.paths import NEAR
from rimroll_score.results import EngineResult
from rimroll_score.sweep import grade


def badge(result: EngineResult, bounds: Bounds) -> str:
    """An SVG that shows the best grade of any setting in ``rolling_near``."""
    grades = [grade(result.of(NEAR, one), bounds.angle, bounds.energy) for one in result.settings]
    best = max((one for one in grades if one is not None), default=None)
    if best is not None:
        value = f"right to {in_ms(best)}"
    else:
        tried = any(run.case == NEAR for run in result.runs)
        value = "right at no step tried" if tried else f"{NEAR} not scored"
    left, right = 84, 7 * len(value) + 14
    fill = "#1a7f5a" if best is not None else "#b34700"
    text = 'font-family="Verdana,DejaVu Sans,sans-serif" font-size="11" fill="#fff"'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + right}" height="20" role="img" '
        f'aria-label="rimroll score: {value}"><rect width="{left}" height="20" fill="#444"/>'
        f'<rect x="{left}" width="{right}" height="20" fill="{fill}"/>'
        f'<text x="8" y="14" {text}>rimroll score</text>'
        f'<text x="{left + 7}" y="14" {text}>{value}</text></svg>\n'
    )
