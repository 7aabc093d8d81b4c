"""``rimroll lab``: tip the can in a browser."""

from __future__ import annotations

import webbrowser
from pathlib import Path
from typing import TYPE_CHECKING, Annotated
from urllib.parse import quote

import typer

from rimroll.browser.page import built_page
from rimroll.browser.setup import check
from rimroll.cli.screen import say
from rimroll.errors import RimrollError

if TYPE_CHECKING:
    from rimroll.browser.page import PageServer


LAB = "lab"
"""The part after # of the address of the lab; without one, the page opens with its essay."""


def lab(
    setup: Annotated[
        str,
        typer.Option(
            help="The set-up to begin with, as in the page's address after #.", metavar="SETUP"
        ),
    ] = "",
    port: Annotated[
        int, typer.Option(min=0, max=65535, help="Where to serve it; 0 is any port that is free.")
    ] = 0,
    browser: Annotated[
        bool, typer.Option(help="Open it in the browser, or only say where it is.")
    ] = True,
) -> int:
    """Tip the can in a browser, on a page that computes itself.

    It is served on this machine and to this machine alone, until Ctrl-C.

    Examples:

    $ rimroll lab

    $ rimroll lab --setup "body=coin&tilt=60" --no-browser
    """
    with built_page() as page, _server(page, port) as server:
        if setup:
            _check(setup, page)
        address = f"{server.address}#{quote(setup, safe='=&%+') or LAB}"
        try:
            say(f"The lab is at {address}")
            say("Press Ctrl-C to end it.")
            if browser:
                webbrowser.open(address)
            server.serve_forever()
        except KeyboardInterrupt:
            say()  # ends the line on which the terminal shows Ctrl-C
    return 0


def _check(setup: str, page: Path) -> None:
    try:
        check(setup, page)
    except RimrollError as error:
        raise error.inside("--setup:") from None


def _server(page: Path, port: int) -> PageServer:
    from rimroll.browser.page import PageServer  # brings http.server, slow to load

    try:
        return PageServer(page, port)
    except OSError as error:
        reason = error.strerror or error
        raise RimrollError(f"--port {port} cannot be served on ({reason}); try without") from None
