"""The built page of the lab: a folder that a server gives to this machine alone, or one file.

Only requests to this machine by its own name are answered, so that a web page from elsewhere whose
host name leads to this machine cannot read what is served.
"""

from __future__ import annotations

import base64
import gzip
import json
import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib import resources
from io import BytesIO
from pathlib import Path
from threading import Event, Thread
from typing import Any, BinaryIO

from rimroll.errors import RimrollError


@contextmanager
def built_page() -> Iterator[Path]:
    """The folder of the page; ``RimrollError`` if the page has not been built."""
    with resources.as_file(resources.files("rimroll") / "page") as folder:
        if not (folder / "index.html").is_file():
            raise RimrollError("the page is not built yet; in rimroll's source tree, run: make web")
        yield folder


def page_alone(folder: Path, setup: str) -> str:
    """The built page as one HTML text that loads nothing, with a set-up to begin with.

    Its script and its core are compressed; the page unpacks them when it opens. The core is the one
    with tables that move, which computes all that the other does. Raises ``RimrollError`` for a
    page that has been built by an older version.
    """
    page = (folder / "index.html").read_text(encoding="utf-8")
    style = _one(r'<link rel="stylesheet"[^>]* href="\./([^"]+)"[^>]*>', page)
    core = _one(r'<link rel="preload"[^>]* href="\./([^"]+\.wasm)"[^>]*>', page)
    cores = list(folder.glob("assets/rimroll-ground-*.wasm"))
    script = folder / "alone.js"
    if not (style and core and len(cores) == 1 and script.is_file()):
        raise RimrollError("the page is older than this rimroll; in its source tree, run: make web")
    parts = {
        "core": _packed(cores[0]),
        "script": _packed(script),
        "licences": _packed(folder / "licences.txt"),
    }
    unpack = resources.files("rimroll.browser").joinpath("unpack.html").read_text(encoding="utf-8")
    css = (folder / style[1]).read_text(encoding="utf-8")
    page = page.replace(style[0], f"<style>{css}</style>").replace(core[0], "")
    page = re.sub(r"<!--.*?-->", "", page, flags=re.S)
    # For the page at an address: its parts, its icon, and previews of links to it.
    page = re.sub(r'<link rel="(?:modulepreload|apple-touch-icon|manifest)"[^>]*>', "", page)
    page = re.sub(r'<meta property="(?:og|twitter):[^>]*>', "", page)
    # One script remains, which chooses the language. The page's main script is among the parts; the
    # others choose what is shown while that one loads, and report why it does not load.
    page = re.sub(r'<script\b(?! id="language").*?</script>', "", page, flags=re.S)
    page = page.replace("<html", f'<html data-setup="{setup.replace("&", "&amp;")}"', 1)
    return page.replace("</body>", unpack.replace("PARTS", json.dumps(parts)) + "</body>")


def _one(pattern: str, page: str) -> re.Match[str] | None:
    found = list(re.finditer(pattern, page))
    return found[0] if len(found) == 1 else None


def _packed(file: Path) -> str:
    # Without the time, so that the same page gives the same text.
    return base64.b64encode(gzip.compress(file.read_bytes(), mtime=0)).decode()


# All that a page consists of; machines differ in which of these they know by themselves.
_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript",
    ".css": "text/css",
    ".wasm": "application/wasm",
    ".json": "application/json",
    ".webmanifest": "application/manifest+json",
    ".txt": "text/plain; charset=utf-8",
    ".svg": "image/svg+xml",
    ".png": "image/png",
}
_PACKED = {".png"}

_POLICY = "; ".join(
    (
        "default-src 'none'",
        # The page has scripts and styles in itself, and compiles WebAssembly.
        "script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval' blob:",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "connect-src 'self'",
        "manifest-src 'self'",
        "base-uri 'none'",
        "form-action 'none'",
    )
)


class _Server(ThreadingHTTPServer):
    @property
    def address(self) -> str:
        """Where a browser finds the page."""
        return f"http://127.0.0.1:{self.server_port}/"

    def handle_error(self, request: object, client_address: object) -> None:
        """A browser that ends a request early is no error."""


class PageServer(_Server):
    """Serves the files of a folder at ``address``; port 0 is any that is free."""

    def __init__(self, folder: Path, port: int = 0) -> None:
        super().__init__(("127.0.0.1", port), partial(_Folder, directory=str(folder)))


class _Handler(SimpleHTTPRequestHandler):
    """Answers requests by this machine's own name; its headers keep the page to itself."""

    def parse_request(self) -> bool:
        if not super().parse_request():
            return False
        host = self.headers.get("Host", "").rpartition(":")[0] or self.headers.get("Host", "")
        if host in ("127.0.0.1", "localhost", ""):
            return True
        self.send_error(HTTPStatus.MISDIRECTED_REQUEST)
        return False

    def end_headers(self) -> None:
        # Another version of the page may have been at this port before.
        self.send_header("Cache-Control", "no-cache")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Content-Security-Policy", _POLICY)
        self.send_header("Referrer-Policy", "no-referrer")
        super().end_headers()

    def answer(self, content: bytes, suffix: str) -> BytesIO:
        """Send the headers of a content, and return it as it is to be sent: compressed if asked."""
        accepted = self.headers.get("Accept-Encoding", "")
        packed = "gzip" in accepted and suffix not in _PACKED
        if packed:
            content = gzip.compress(content, 6, mtime=0)
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", _TYPES.get(suffix, "application/octet-stream"))
        self.send_header("Content-Length", str(len(content)))
        self.send_header("Vary", "Accept-Encoding")
        if packed:
            self.send_header("Content-Encoding", "gzip")
        self.end_headers()
        return BytesIO(content)

    def log_message(self, format: str, *arguments: object) -> None:
        """Logs nothing."""


class _Folder(_Handler):
    def send_head(self) -> BytesIO | BinaryIO | None:
        try:
            file = Path(self.translate_path(self.path))
            if self.path.partition("?")[0] == "/":
                file = file / "index.html"
            content = file.read_bytes()
        except (OSError, ValueError):  # no such file, a folder, or a name that no file can have
            self.send_error(HTTPStatus.NOT_FOUND)
            return None
        return self.answer(content, file.suffix)


class BackgroundServer:
    """Serves one page at ``address`` until Python ends."""

    def __init__(self, page: str) -> None:
        self.fetched = Event()
        """Set when a browser has fetched the page."""
        handler = partial(_OnePage, page=page.encode(), fetched=self.fetched)
        server = _Server(("127.0.0.1", 0), handler)
        self.address = server.address
        Thread(target=server.serve_forever, daemon=True).start()


class _OnePage(_Handler):
    def __init__(self, *request: Any, page: bytes, fetched: Event) -> None:
        self._page = page
        self._fetched = fetched
        super().__init__(*request)

    def send_head(self) -> BytesIO | None:
        if self.path != "/":
            self.send_error(HTTPStatus.NOT_FOUND)
            return None
        return self.answer(self._page, ".html")

    def do_GET(self) -> None:
        super().do_GET()
        if self.path == "/":
            self._fetched.set()
