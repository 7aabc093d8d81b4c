"""``rimroll study verify``: read all numbers again, and print one hash of them."""

from __future__ import annotations

from typing import Annotated

import typer

from rimroll.cli.options import JsonOption
from rimroll.cli.screen import say, show_json, working
from rimroll.cli.study.options import StoredArgument, StoreOption, stored
from rimroll.study.claim import claimed
from rimroll.study.verify import verify as look

RepairOption = Annotated[
    bool, typer.Option("--repair", help="Forget that damaged chunks are done: run computes them.")
]


def verify(
    study: StoredArgument,
    store: StoreOption = None,
    repair: RepairOption = False,
    json: JsonOption = False,
) -> int:
    """Read all numbers of a store again, and print one hash of them.

    The hash is that of all numbers and coordinates. Equal studies have equal hashes, whatever the
    chunks and the machines. The exit code is 1 if chunks are damaged or missing.

    Examples:

    $ rimroll study verify falls.toml

    $ rimroll study verify falls.toml --repair
    """
    opened, _ = stored(study, store)
    with working("reading") as bar:
        found = look(opened, lambda done, total: bar(done, total, ""))
    unwritten = opened.unmerged
    if repair and (found.damaged or found.unmerged):
        with claimed(opened.marks.folder, 0, opened.blocks.number):
            opened.marks.remove_merged()
            for chunk in found.damaged:
                opened.marks.remove(chunk)
    if json:
        show_json({"store": str(opened.path), **vars(found), "repaired": repair})
    else:
        then = "run computes them again" if repair else "--repair has run compute them again"
        if found.damaged:
            say(f"damaged chunks: {_ranges(found.damaged)}; {then}")
        if found.unmerged and unwritten:
            say("the statistics are not written: run writes them")
        elif found.unmerged:
            say(f"damaged statistics; {then}")
        if found.missing:
            say(f"missing chunks: {_ranges(found.missing)}; run computes them")
        if found.sha256:
            say(f"sha256 {found.sha256}")
    return 0 if found.sha256 else 1


def _ranges(chunks: list[int]) -> str:
    """Numbers in order, neighbours together.

    >>> _ranges([1, 2, 3, 7])
    '1-3, 7'
    """
    spans: list[list[int]] = []
    for chunk in chunks:
        if spans and spans[-1][1] == chunk - 1:
            spans[-1][1] = chunk
        else:
            spans.append([chunk, chunk])
    return ", ".join(f"{a}-{b}" if b > a else str(a) for a, b in spans)
