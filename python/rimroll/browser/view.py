"""The lab with a body, in a cell of a notebook or in the browser."""

from __future__ import annotations

import os
import sys
import webbrowser
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rimroll.bodies.body import Body
from rimroll.browser.page import built_page, page_alone
from rimroll.browser.setup import check, setup_of
from rimroll.errors import RimrollError
from rimroll.files.output import writing
from rimroll.laws import Law
from rimroll.options import FlatLanding
from rimroll.state import State
from rimroll.units import Number, whole_number

if TYPE_CHECKING:
    from rimroll.browser.page import BackgroundServer
    from rimroll.ground.ground import Ground

PATIENCE = 30.0
"""How long the browser may take to fetch the page, s."""


class Lab:
    """The lab with a set-up to begin with; :func:`rimroll.lab` makes it.

    A notebook shows it in its cell. The page is a part of the cell's output, of four fifths of a
    megabyte: it computes in the browser, and needs no server, no network and no Python.
    """

    setup: str
    """The set-up to begin with, as in the page's address after ``#``."""

    def __init__(self, setup: str, page: str, height: int) -> None:
        self.setup = setup
        self._page = page
        self._height = height
        self._server: BackgroundServer | None = None

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the lab as one HTML file, which opens in a browser from wherever it lies.

        Returns the path. Raises ``RimrollError`` for a place that cannot be written to.
        """
        path = Path(path)
        with writing(path) as part:
            part.write_text(self._page, encoding="utf-8")
        return path

    def open(self) -> str:
        """Open the lab in the browser and return its address on this machine.

        It is served to this machine alone, as long as Python runs. A page that is open needs no
        server any more. Raises ``RimrollError`` where no browser opens.
        """
        from rimroll.browser.page import BackgroundServer  # brings http.server, slow to load

        if self._server is None:
            self._server = BackgroundServer(self._page)
        address = self._server.address
        # A script may end at once, and the server with it, so the browser gets time.
        if not (webbrowser.open(address) and self._server.fetched.wait(PATIENCE)):
            raise RimrollError(
                f"no browser has opened {address}; write the lab to a file with its method save, or"
                " show it in a notebook"
            )
        return address

    def __repr__(self) -> str:
        return f"<Lab {self.setup}>" if self.setup else "<Lab>"

    def _repr_html_(self) -> str:
        """The view in notebooks: the page in a frame."""
        return (
            f'<iframe srcdoc="{escape(self._page)}" title="The lab" width="100%"'
            f' height="{self._height}" style="border: 0" allow="clipboard-write"></iframe>'
        )


def lab(
    body: Body | None = None,
    start: State[Any] | None = None,
    law: Law | None = None,
    *,
    duration: Number | None = None,
    gravity: Number | None = None,
    ground: Ground | None = None,
    flat: FlatLanding | None = None,
    height: int = 760,
    browser: bool | None = None,
) -> Lab:
    """The lab with a body: tip it with the mouse, slow time down, change the table.

    In a notebook, the lab appears in the cell, as the cell's result. Elsewhere, it opens in the
    browser.

    Parameters
    ----------
    body, start, law, duration, gravity, ground, flat
        What the lab begins with, as in :func:`rimroll.simulate`. What is left out has the lab's own
        value: the paper's can, leaning by 20° and released at rest on a table with friction 0.5.
        Bodies other than presets are drawn as plain cylinders. ``start.spin``, on which no motion
        depends, is left out.
    height
        Height of the frame in a notebook, pixels.
    browser
        Whether to open the browser; by default everywhere but in a notebook.

    Raises
    ------
    RimrollError
        A law that the lab does not have: it has ``NoSlip``, ``Frictionless`` and ``Coulomb`` with
        one coefficient, each with dry rolling resistance. A ground that is not one pulse, the same
        in all components except for its amplitude: the lab has no records. A ``flat`` with a seed
        or a restitution. A start that stands flat without a ground. Many bodies, starts or laws; a
        number outside the lab's bounds, such as a tilt of 90°; a page that is not built; a browser
        that does not open.
    """
    pixels = whole_number("height", height)
    setup = setup_of(body, start, law, duration, gravity, ground, flat)
    with built_page() as folder:
        check(setup, folder)
        shown = Lab(setup, page_alone(folder, setup), pixels)
    if not _in_notebook() if browser is None else browser:
        shown.open()
    return shown


def _in_notebook() -> bool:
    """Whether this Python is the kernel of a notebook, or runs in a browser itself."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return hasattr(shell, "kernel") or sys.platform == "emscripten"
