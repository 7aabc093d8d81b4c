"""Formulas typeset by KaTeX when the site is built, so that pages need no script and no network."""

import json
import shutil
import subprocess
from functools import cache
from pathlib import Path

from docutils import nodes
from sphinx.util import logging
from sphinx.util.math import get_node_equation_number

ROOT = Path(__file__).parents[2]
KATEX = ROOT / "web/node_modules/katex/dist"
logger = logging.getLogger(__name__)


@cache
def typesetter():
    script = Path(__file__).with_name("katex_lines.cjs")
    return subprocess.Popen(
        [ROOT / "tools/node.sh", "node", script],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        encoding="utf-8",
    )


@cache
def typeset(tex, display):
    process = typesetter()
    process.stdin.write(json.dumps({"tex": tex, "displayMode": display}) + "\n")
    process.stdin.flush()
    return json.loads(process.stdout.readline())


def formula(node, display):
    answer = typeset(node.astext().strip(), display)
    if "error" in answer:
        logger.warning("%s", answer["error"], location=node)
    return answer.get("html", "")


def inline(translator, node):
    translator.body.append(formula(node, display=False))
    raise nodes.SkipNode


def displayed(translator, node):
    translator.body.append(translator.starttag(node, "div", CLASS="math-block"))
    translator.body.append(formula(node, display=True))
    if node["number"]:
        number = get_node_equation_number(translator, node)
        translator.body.append(f'<span class="eqno">({number})')
        translator.add_permalink_ref(node, "Link to this equation")
        translator.body.append("</span>")
    translator.body.append("</div>\n")
    raise nodes.SkipNode


def copy_style(app, error):
    if error is None and app.builder.format == "html":
        target = app.outdir / "_static/katex"
        (target / "fonts").mkdir(parents=True, exist_ok=True)
        shutil.copy(KATEX / "katex.min.css", target)
        for font in (KATEX / "fonts").glob("*.woff2"):
            shutil.copy(font, target / "fonts")


def setup(app):
    app.add_html_math_renderer("katex", (inline, None), (displayed, None))
    app.add_css_file("katex/katex.min.css")
    app.connect("build-finished", copy_style)
    return {"parallel_read_safe": True, "parallel_write_safe": False}
