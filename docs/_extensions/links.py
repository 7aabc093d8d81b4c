"""Pages that are files of the repository, and links that lead out of docs/.

A page that consists of `<!-- file: NAME -->` shows that file of the repository. A link to a file
outside docs/ leads to the page that shows it, otherwise to the file in the repository.
"""

import os
import re
from pathlib import Path

DOCS = Path(__file__).parents[1]
ROOT = DOCS.parent
SHOWN = re.compile(r"<!-- file: (\S+) -->\s*")
LINK = re.compile(r"((?<!!)\[[^][]*\]\()([^)#\s:]+)(#[^)\s]*)?(\))")
BLOCK = re.compile(r"^```.*?^```", re.M | re.S)


def shown_files():
    """The page for each file of the repository that is shown as a page."""
    pages = {page: SHOWN.fullmatch(page.read_text("utf-8")) for page in DOCS.rglob("*.md")}
    return {ROOT / match[1]: page for page, match in pages.items() if match}


def read(app, name, source):
    page = Path(app.env.doc2path(name))
    if page.suffix != ".md":
        return
    shown = shown_files()
    original = next((file for file, at in shown.items() if at == page), page)
    text = source[0] if original == page else original.read_text("utf-8")

    def link(match):
        before, target, fragment, after = match.groups()
        aim = Path(os.path.normpath(original.parent / target))
        if not aim.exists():
            return match[0]  # Sphinx reports it
        aim = shown.get(aim, aim)
        if aim.is_relative_to(DOCS) and aim.is_file():
            address = os.path.relpath(aim, page.parent)
        else:
            address = f"{app.config.repository}/blob/main/{aim.relative_to(ROOT)}"
        return f"{before}{address}{fragment or ''}{after}"

    blocks = BLOCK.findall(text)
    parts = [LINK.sub(link, part) for part in BLOCK.split(text)]
    source[0] = "".join(part + block for part, block in zip(parts, [*blocks, ""], strict=True))


def setup(app):
    app.add_config_value("repository", "", "env")
    app.connect("source-read", read)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
