"""The directive `command-help`: a section for each command of rimroll, with the help it prints.

The help of a command is folded up until the reader opens it.
"""

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
        from rimroll.cli.study import COMMANDS as OF_STUDIES

        lines = {(name,): line for name, line in COMMANDS.items()}
        lines |= {("study", name): line for name, line in OF_STUDIES.items()}
        for words, line in lines.items():
            name = f"rimroll-{'-'.join(words)}"
            title = nodes.title("", "", nodes.literal("", f"rimroll {' '.join(words)}"))
            section = nodes.section("", title, ids=[name], names=[name])
            section += nodes.raw("", f"<details><summary>{line}</summary>", format="html")
            section += nodes.literal_block("", help_of(*words), language="text")
            section += nodes.raw("", "</details>", format="html")
            self.state.document.note_explicit_target(section)
            found.append(section)
        return found


def setup(app):
    app.add_directive("command-help", CommandHelp)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
