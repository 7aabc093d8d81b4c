"""Writes the report: figures as SVG and PNG, a film, ``numbers.json`` and ``index.html``."""

from __future__ import annotations

import base64
import json
import os
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import jinja2
import numpy as np

from rimroll import _core
from rimroll.figures.animation import animate
from rimroll.figures.style import figure_style
from rimroll.files.output import ensure_folder, writing
from rimroll.paper import setting
from rimroll.paper.claims import Claim, all_claims
from rimroll.paper.drawing import Drawing, Table
from rimroll.paper.errata import ERRATA
from rimroll.paper.figures import FIGURES
from rimroll.theory.closed_forms import turn_limit

Progress = Callable[[int, int, str], None]

FILM = "rocking.gif"
FILM_SIZE = (480, 360)


@dataclass(frozen=True)
class Picture:
    """A drawing as the page shows it; ``source`` is a data URL of the picture.

    ``size`` is its width and height, pixels: with them the page keeps its place until it is drawn.
    """

    slug: str
    title: str
    caption: str
    source: str
    size: tuple[int, int]
    table: Table | None


def reproduce(folder: str | os.PathLike[str], progress: Progress | None = None) -> Path:
    """Write the report into a folder, made if needed, and return the path of its page.

    The page is self-contained and written last: if it exists, the report is complete.
    ``progress`` is called with (steps done, steps in all, what comes next).

    Raises ``RimrollError`` when the folder cannot be written to.
    """
    folder = ensure_folder(folder)
    total = len(FIGURES) + 3
    say = progress or (lambda done, total, what: None)

    say(0, total, "the paper's numbers")
    claims = all_claims()
    drawings: list[Drawing] = []
    pictures: list[Picture] = []
    for done, draw in enumerate(FIGURES, start=1):
        say(done, total, f"figure {done} of {len(FIGURES)}")
        with figure_style():
            drawing = draw()
            pictures.append(_save(drawing, folder))
        drawings.append(drawing)

    say(total - 2, total, "the film")
    animate(setting.motion(setting.LAWS[0]), folder / FILM, seconds=7.0, fps=20, size=FILM_SIZE)

    say(total - 1, total, "the page")
    _write_numbers(folder / "numbers.json", claims, drawings)
    page = folder / "index.html"
    text = _page(claims, pictures, _data_address(folder / FILM, "image/gif"))
    with writing(page) as part:
        part.write_text(text, encoding="utf-8")
    say(total, total, "done")
    return page


def _save(drawing: Drawing, folder: Path) -> Picture:
    """A drawing as SVG and PNG in the folder, and as a picture for the page."""
    vector = folder / f"{drawing.slug}.svg"
    with writing(vector) as part:
        # Without a date the same figure is the same file.
        drawing.figure.savefig(part, metadata={"Date": None})
    with writing(folder / f"{drawing.slug}.png") as part:
        drawing.figure.savefig(part, dpi=150)
    address = _data_address(vector, "image/svg+xml")
    width, height = (round(96 * inches) for inches in drawing.figure.get_size_inches())
    return Picture(
        drawing.slug, drawing.title, drawing.caption, address, (width, height), drawing.table
    )


def _data_address(path: Path, kind: str) -> str:
    return f"data:{kind};base64,{base64.b64encode(path.read_bytes()).decode('ascii')}"


def _write_numbers(path: Path, claims: dict[str, list[Claim]], drawings: list[Drawing]) -> None:
    numbers = {
        "rimroll_version": _core.__version__,
        "can": asdict(setting.CAN),
        "gravity": setting.GRAVITY,
        "start": asdict(setting.start()),
        "claims": [
            {"topic": topic, **asdict(claim), "verdict": claim.verdict}
            for topic, group in claims.items()
            for claim in group
        ],
        "errata": [asdict(erratum) for erratum in ERRATA],
        "figures": {drawing.slug: drawing.numbers for drawing in drawings},
    }
    with writing(path) as part:
        text = json.dumps(numbers, indent=1, default=_plain, ensure_ascii=False, allow_nan=False)
        part.write_text(text + "\n", encoding="utf-8")


def _plain(value: Any) -> Any:
    """NumPy's numbers and arrays as JSON knows them."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"no JSON for {type(value).__name__}")


def _page(claims: dict[str, list[Claim]], pictures: list[Picture], film: str) -> str:
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("rimroll.paper", "."),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template("report.html").render(
        version=_core.__version__,
        claims=claims,
        verdicts=_count(claims),
        pictures={picture.slug: picture for picture in pictures},
        sections=list(_sections(pictures)),
        errata=ERRATA,
        film=film,
        film_size=FILM_SIZE,
        limits={law.name: float(np.degrees(turn_limit(setting.CAN, law))) for law in setting.LAWS},
    )


def _count(claims: dict[str, list[Claim]]) -> dict[str, int]:
    verdicts = [claim.verdict for group in claims.values() for claim in group]
    return {verdict: verdicts.count(verdict) for verdict in dict.fromkeys(verdicts)}


def _sections(pictures: list[Picture]) -> Iterator[tuple[int, Picture]]:
    yield from enumerate((p for p in pictures if p.slug != "falling"), start=2)
