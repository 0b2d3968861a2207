"""The control table."""

from __future__ import annotations

import itertools

import pytest

from viscodesign.pump.ax.protocol import registers


def test_registers_stand_in_order_and_do_not_overlap() -> None:
    table = registers.TABLE
    assert all(a.address + a.size <= b.address for a, b in itertools.pairwise(table))
    assert table[-1].address + table[-1].size == registers.TABLE_END


@pytest.mark.parametrize(("data", "value"), [("0002", 512), ("ff03", 1023)])
def test_words_come_low_byte_first(data: str, value: int) -> None:
    assert registers.GOAL_POSITION.decode(bytes.fromhex(data)) == value
    assert registers.GOAL_POSITION.encode(value) == bytes.fromhex(data)


def test_clockwise_load_is_negative() -> None:
    block = bytes.fromhex("0002 6400 c804 6f 1e".replace(" ", ""))
    start = registers.PRESENT_POSITION.address
    assert registers.PRESENT_SPEED.within(block, start) == 100
    assert registers.PRESENT_LOAD.within(block, start) == -200
    assert registers.PRESENT_VOLTAGE.within(block, start) == 111
