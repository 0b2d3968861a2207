"""Ctrl-C is noted first and obeyed between two stretches."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.scenes import CONFIGS
from viscodesign.interrupt import ended_like_interrupts, gentle_interrupt

pytestmark = pytest.mark.skipif(os.name != "posix", reason="POSIX signals")


def test_an_interrupt_is_noted() -> None:
    before = signal.getsignal(signal.SIGINT)
    with gentle_interrupt() as interrupt:
        assert not interrupt.asked
        os.kill(os.getpid(), signal.SIGINT)
        assert interrupt.asked
        assert signal.getsignal(signal.SIGINT) is signal.SIG_DFL  # a second one ends it all
    assert signal.getsignal(signal.SIGINT) is before


TELLS_WHEN_IT_LISTENS = """
import sys
from contextlib import contextmanager
from viscodesign.cli.main import main
from viscodesign.solve import transient

listens = transient.gentle_interrupt

@contextmanager
def told():
    with listens() as interrupt:
        print("listening", flush=True)
        yield interrupt

transient.gentle_interrupt = told
sys.exit(main())
"""


IN_THE_BACKGROUND = "import signal; signal.signal(signal.SIGINT, signal.SIG_IGN)"
"""What a shell does to a background job of a script."""


@pytest.mark.parametrize(
    ("number", "before"),
    [
        (signal.SIGINT, ""),
        (signal.SIGTERM, ""),
        (signal.SIGHUP, ""),
        (signal.SIGTERM, IN_THE_BACKGROUND),
        (signal.SIGHUP, IN_THE_BACKGROUND),
    ],
)
def test_a_long_run_stops_and_keeps_what_it_has(number: int, before: str, tmp_path: Path) -> None:
    spec, folder = CONFIGS / "workspace_middle.yaml", tmp_path / "run"
    words = ["simulate", str(spec), "-o", str(folder), "--no-plots"]
    words += ["--set", "run.duration=4000 s", "--set", "run.output_interval=1 s"]
    process = subprocess.Popen(
        [sys.executable, "-c", before + TELLS_WHEN_IT_LISTENS, *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "listening\n"
    process.send_signal(number)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "interrupted" in err
    assert str(folder) in err
    assert "Traceback" not in err
    assert json.loads((folder / "summary.json").read_text())["status"] == "interrupted"
    assert "interrupted: " in out


def test_an_enclosing_listener_is_notified_at_once() -> None:
    with gentle_interrupt() as outer:
        with gentle_interrupt() as inner:
            os.kill(os.getpid(), signal.SIGINT)
            assert inner.asked
            assert outer.asked
        assert outer.times == 1


@pytest.mark.parametrize("second_raises", [False, True])
def test_an_ignored_interrupt_stays_ignored_and_a_termination_is_noted(second_raises: bool) -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with (
            ended_like_interrupts(),
            gentle_interrupt(second_raises=second_raises) as outer,
            gentle_interrupt() as inner,
        ):
            os.kill(os.getpid(), signal.SIGINT)
            assert not inner.asked
            os.kill(os.getpid(), signal.SIGTERM)
            assert (outer.first, inner.first) == ("SIGTERM", "SIGTERM")
            assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
            with gentle_interrupt() as later:
                assert later.asked
        assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)
