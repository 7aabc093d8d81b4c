"""The built page of the lab, and the same page as one file that needs no server."""

from __future__ import annotations

import base64
import gzip
import json
import re
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import resources
from pathlib import Path

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
