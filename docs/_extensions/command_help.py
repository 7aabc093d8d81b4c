"""The directive `command-help`: a section for each command of rimroll, with the help it prints."""

import contextlib
import io
import os

from docutils import nodes
from sphinx.util.docutils import SphinxDirective


def help_of(*words):
    """What the command prints for --help on a screen of 90 columns."""
    from rimroll.cli import main

    os.environ["COLUMNS"] = "90"
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        if main([*words, "--help"]) != 0:
            raise RuntimeError(f"rimroll {' '.join(words)} --help failed")
    return printed.getvalue()


class CommandHelp(SphinxDirective):
    def run(self):
        from rimroll.cli.commands import COMMANDS

        found = [nodes.literal_block("", help_of(), language="text")]
        for name, line in COMMANDS.items():
            title = nodes.title("", "", nodes.literal("", f"rimroll {name}"))
            section = nodes.section("", title, ids=[f"rimroll-{name}"], names=[f"rimroll-{name}"])
            section += nodes.paragraph("", line)
            section += nodes.literal_block("", help_of(name), language="text")
            self.state.document.note_explicit_target(section)
            found.append(section)
        return found


def setup(app):
    app.add_directive("command-help", CommandHelp)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
