"""Serves the page on this machine, to this machine alone: its folder, or one text."""

from __future__ import annotations

import os
from functools import partial
from http.server import BaseHTTPRequestHandler, SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Event, Thread
from typing import Any


class PageServer(ThreadingHTTPServer):
    """Serves the files of a folder at ``address``; port 0 is any that is free."""

    def __init__(self, folder: Path, port: int = 0) -> None:
        super().__init__(("127.0.0.1", port), partial(_Handler, directory=str(folder)))

    @property
    def address(self) -> str:
        """Where a browser finds the page."""
        return f"http://127.0.0.1:{self.server_port}/"


# All that a page consists of; machines differ in which of these they know by themselves.
_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript",
    ".css": "text/css",
    ".wasm": "application/wasm",
    ".json": "application/json",
    ".txt": "text/plain; charset=utf-8",
}


class _Handler(SimpleHTTPRequestHandler):
    def guess_type(self, path: str | os.PathLike[str]) -> str:
        return _TYPES.get(Path(path).suffix, "application/octet-stream")

    def end_headers(self) -> None:
        # Another version of the page may have been at this port before.
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def list_directory(self, path: object) -> None:
        """A folder without a page is not shown."""
        self.send_error(404)

    def log_message(self, format: str, *arguments: object) -> None:
        """Logs nothing."""


class BackgroundServer:
    """Serves one page at ``address`` until Python ends."""

    def __init__(self, page: str) -> None:
        self.fetched = Event()
        """Set when a browser has fetched the page."""
        handler = partial(_OnePage, page=page.encode(), fetched=self.fetched)
        server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
        self.address = f"http://127.0.0.1:{server.server_port}/"
        Thread(target=server.serve_forever, daemon=True).start()


class _OnePage(BaseHTTPRequestHandler):
    def __init__(self, *request: Any, page: bytes, fetched: Event) -> None:
        self._page = page
        self._fetched = fetched
        super().__init__(*request)

    def do_GET(self) -> None:
        if self.path != "/":
            self.send_error(404)
            return
        self.send_response(200)
        self.send_header("Content-Type", _TYPES[".html"])
        self.send_header("Content-Length", str(len(self._page)))
        self.send_header("Cache-Control", "no-cache")
        self.end_headers()
        self.wfile.write(self._page)
        self._fetched.set()

    def log_message(self, format: str, *arguments: object) -> None:
        """Logs nothing."""
