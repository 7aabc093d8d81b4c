"""Public names have a docstring and a place in docs/reference/python, or the build fails."""

import inspect
import re
from pathlib import Path

from sphinx.util import logging

import rimroll

REFERENCE = Path(__file__).parents[1] / "reference/python"
DIRECTIVE = re.compile(r"^\.\. auto(?:class|function|exception|data|module):: (\S+)", re.M)
logger = logging.getLogger(__name__)


def described():
    """The names that the pages of the reference describe, one for each time."""
    texts = [page.read_text("utf-8") for page in sorted(REFERENCE.glob("*.rst"))]
    return [name for text in texts for name in DIRECTIVE.findall(text)]


def public():
    """The public names, with those of the public modules."""
    for name in rimroll.__all__:
        value = getattr(rimroll, name)
        yield f"rimroll.{name}", value
        if inspect.ismodule(value):
            for inner, function in vars(value).items():
                own = getattr(function, "__module__", None) == value.__name__
                if own and not inner.startswith("_"):
                    yield f"rimroll.{name}.{inner}", function


def undocumented():
    """Public names, and public methods and properties of them, that have no docstring."""
    for name, value in public():
        if (callable(value) or inspect.ismodule(value)) and not inspect.getdoc(value):
            yield name
        if inspect.isclass(value):
            for inner, member in vars(value).items():
                is_code = inspect.isroutine(member) or isinstance(member, property)
                if is_code and not inner.startswith("_") and not inspect.getdoc(member):
                    yield f"{name}.{inner}"


def full_names():
    """The public names as the reference has them: modules with their path in the package."""
    values = {f"rimroll.{name}": getattr(rimroll, name) for name in rimroll.__all__}
    return {value.__name__ if inspect.ismodule(value) else name for name, value in values.items()}


def not_described():
    """Public names that have no place in the reference; functions of modules come with them."""
    return full_names() - set(described())


def check(app):
    for name in undocumented():
        logger.warning("%s has no docstring", name)
    for name in not_described():
        logger.warning("%s is on no page of docs/reference/python", name)


def escape_bars(app, what, name, value, options, lines):
    """|T| in a docstring is an absolute value, not a substitution of reStructuredText."""
    for number, line in enumerate(lines):
        parts = re.split(r"(``.*?``)", line)
        parts[::2] = [part.replace("|", r"\|") for part in parts[::2]]
        lines[number] = "".join(parts)


def setup(app):
    app.connect("builder-inited", check)
    app.connect("autodoc-process-docstring", escape_bars)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
