"""Checks a built documentation site: its links lead somewhere, and it loads nothing from elsewhere.

Run as: check_site.py FOLDER
"""

import sys
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# What Sphinx does not write: their own builds check them.
INSERTED = ("lab/", "notebooks/", "paper/", "reference/rust/")


class Page(HTMLParser):
    """The links of a page, what it loads, and its anchors."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], set()
        self.feed(path.read_text("utf-8"))

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.anchors |= {found.get("id"), found.get("name")}
        is_other_page = tag == "link" and "stylesheet" not in (found.get("rel") or "")
        if tag == "a" or is_other_page:
            self.links.append(found.get("href"))
        else:
            self.loaded += [found.get(name) for name in ("src", "href", "data")]


page = cache(Page)


def faults(site):
    pages = [
        path
        for path in sorted(site.rglob("*.html"))
        if not path.relative_to(site).as_posix().startswith(INSERTED)
    ]
    for path in pages:
        name = path.relative_to(site)
        for address in filter(None, page(path).loaded):
            parts = urlsplit(address)
            if elsewhere(parts):
                yield f"{name} loads {address}"
        for address in filter(None, page(path).links + page(path).loaded):
            parts = urlsplit(address)
            if parts.scheme or parts.netloc:
                continue
            aim = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if aim.is_dir():
                aim /= "index.html"
            if not aim.is_file():
                yield f"{name} links to {address}, which is not there"
            elif (
                parts.fragment and aim in pages and unquote(parts.fragment) not in page(aim).anchors
            ):
                yield f"{name} links to {address}, which has no such place"
    for style in site.glob("_static/**/*.css"):
        for scheme in "url(http", "url(//", '@import "http', "@import url":
            if scheme in style.read_text("utf-8"):
                yield f"{style.relative_to(site)} loads from another host"


def elsewhere(parts):
    return bool(parts.netloc) or parts.scheme in ("http", "https")


def main(folder):
    found = list(faults(Path(folder).resolve()))
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
