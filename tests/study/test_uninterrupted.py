"""Ctrl-C does not cut off what is being written."""

import signal
import threading

import pytest

from given.ctrl_c import needs_signals
from rimroll.study.work import uninterrupted

pytestmark = needs_signals


@pytest.fixture(autouse=True)
def default_handler():
    # Who runs the tests may ignore SIGINT.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_an_interrupt_comes_after_the_block():
    written = []
    with pytest.raises(KeyboardInterrupt), uninterrupted():
        signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)
        written.append("all")
    assert written == ["all"]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_an_interrupt_comes_after_an_error_too():
    with pytest.raises(KeyboardInterrupt) as interrupt, uninterrupted():
        signal.raise_signal(signal.SIGINT)
        raise OSError("the disk is full")
    assert isinstance(interrupt.value.__context__, OSError)


def test_without_an_interrupt_nothing_happens():
    with uninterrupted():
        pass
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with uninterrupted():
        signal.raise_signal(signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN


def test_other_threads_leave_signals_alone():
    entered = []

    def block():
        with uninterrupted():
            entered.append(signal.getsignal(signal.SIGINT))

    thread = threading.Thread(target=block)
    thread.start()
    thread.join()
    assert entered == [signal.default_int_handler]
