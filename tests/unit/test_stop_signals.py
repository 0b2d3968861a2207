"""Signals are noted, counted, and given back."""

from __future__ import annotations

import os
import signal
import threading

import pytest

from viscodesign.interrupt import STOP_SIGNALS, stop_on_signals

pytestmark = pytest.mark.skipif(os.name != "posix", reason="POSIX signals")


@pytest.mark.parametrize("number", STOP_SIGNALS)
def test_a_signal_is_a_wish_and_a_second_one_is_urgent(number: int) -> None:
    before = signal.getsignal(number)
    with stop_on_signals() as wish:
        assert not wish.asked
        os.kill(os.getpid(), number)
        assert wish.asked
        assert not wish.urgent
        os.kill(os.getpid(), signal.SIGINT)
        assert wish.urgent
        assert wish.first == signal.Signals(number).name
    assert signal.getsignal(number) is before


def test_outside_the_main_thread_nothing_changes() -> None:
    before = signal.getsignal(signal.SIGINT)
    seen = []

    def work() -> None:
        with stop_on_signals() as wish:
            seen.append((wish.asked, signal.getsignal(signal.SIGINT)))

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert seen == [(False, before)]
