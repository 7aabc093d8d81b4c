"""``rimroll study status``: how much of a study is done."""

from __future__ import annotations

from rimroll.cli.options import JsonOption
from rimroll.cli.screen import say, show_json
from rimroll.cli.study.options import StoredArgument, StoreOption, stored
from rimroll.study.progress import status_of


def status(study: StoredArgument, store: StoreOption = None, json: JsonOption = False) -> int:
    """How much of a study is done, and who is at work.

    Examples:

    $ rimroll study status falls.toml
    """
    opened, _ = stored(study, store)
    found = status_of(opened)
    if json:
        show_json({"store": str(opened.path), **vars(found)})
        return 0
    say(f"{opened.path}: {found.chunks_done:,} of {found.chunks:,} chunks are done")
    say(f"motions: {found.motions_done:,} of {found.motions:,}")
    if found.seconds is not None:
        say(f"a chunk took {found.seconds:.3g} s on average")
    if found.chunks_done == found.chunks and opened.unmerged:
        say("the statistics are not written: run writes them")
    for owner in found.owners:
        say(owner)
    return 0
