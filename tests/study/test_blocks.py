"""Chunks are blocks of the labelled dimensions and ranges of rows at the same time."""

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from given.strategies import examples
from rimroll.study.columns import Blocks

shapes = st.lists(st.integers(1, 12), max_size=4).map(tuple)


@examples(400)
@given(shape=shapes, rows=st.integers(1, 2000))
def test_every_row_is_in_one_chunk_in_order(shape, rows):
    blocks = Blocks.of(shape, rows)
    grid = np.arange(math.prod(shape)).reshape(shape)
    found = []
    for chunk in range(blocks.number):
        first, last = blocks.rows(chunk)
        assert last - first <= rows
        assert (grid[blocks.place(chunk)].ravel() == np.arange(first, last)).all()
        found.extend(range(first, last))
    assert found == list(range(grid.size))


@examples(100)
@given(shape=shapes, rows=st.integers(1, 2000), data=st.data())
def test_a_block_is_a_chunk_of_a_zarr_array(shape, rows, data):
    blocks = Blocks.of(shape, rows)
    chunk = data.draw(st.integers(0, blocks.number - 1))
    index = blocks.index(chunk)
    for part, i, size in zip(blocks.place(chunk), index, blocks.block, strict=True):
        assert part.start == i * size


def test_chunks_are_as_equal_as_they_can_be():
    assert Blocks.of((1_000_001,), 1_000_000).block == (500_001,)
    assert Blocks.of((10, 1000, 1000), 300_000).block == (1, 250, 1000)
