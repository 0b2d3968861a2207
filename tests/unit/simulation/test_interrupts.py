"""Ctrl-C in Python raises once, wherever it falls, and holds what there is of the run."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable, Iterator
from types import FrameType
from typing import Any

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.interrupt import ended_like_interrupts, gentle_interrupt
from viscodesign.results.trajectory import RunInterruptedError
from viscodesign.scene.scene import Scene
from viscodesign.simulation import measured_effects, solve_once
from viscodesign.simulation import simulate as simulating
from viscodesign.solve import transient

pytestmark = pytest.mark.skipif(os.name != "posix", reason="POSIX signals")

SHORT = ("run={duration: 2 s, output_interval: 0.05 s}", "bellows.count=4")
PLACES: dict[str, Any] = {
    "choosing effects": (simulating, "select_effects"),
    "refusing": (simulating, "refuse_unsolvable"),
    "choosing settings": (simulating, "suggest_settings"),
    "at the start": (transient, "Fallbacks"),
    "reading": (solve_once, "read_motion"),
    "weighing again": (simulating, "escalation"),
    "stating the accuracy": (simulating, "accuracy_of"),
    "at the end": (simulating, "trajectory_of"),
}


def press(number: int = signal.SIGINT) -> None:
    os.kill(os.getpid(), number)


@pytest.fixture(scope="module")
def scene() -> Scene:
    return leg(*SHORT)


@pytest.fixture
def pressed_at(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[str], None]]:
    """Ctrl-C as soon as a place is reached, once."""

    def at(place: str) -> None:
        module, name = PLACES[place]
        own, pressed = getattr(module, name), []

        def pressing(*words: Any, **options: Any) -> Any:
            if not pressed:
                pressed.append(True)
                press()
            return own(*words, **options)

        monkeypatch.setattr(module, name, pressing)

    yield at
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


@pytest.mark.parametrize("place", PLACES)
def test_a_press_raises_once_wherever_it_falls(
    place: str, scene: Scene, pressed_at: Callable[[str], None]
) -> None:
    pressed_at(place)
    with pytest.raises(KeyboardInterrupt) as stopped:
        simulate(scene)
    assert isinstance(stopped.value, RunInterruptedError)
    again = simulate(scene)  # nothing of the press is left
    assert again.status == "complete"
    partial = stopped.value.trajectory
    if partial is not None:
        assert np.array_equal(partial.time, again.time[: len(partial.time)])


@pytest.mark.parametrize("place", ["reading", "at the end"])
def test_what_was_computed_is_on_it(
    place: str, scene: Scene, pressed_at: Callable[[str], None]
) -> None:
    pressed_at(place)
    with pytest.raises(RunInterruptedError) as stopped:
        simulate(scene)
    assert stopped.value.trajectory is not None
    assert len(stopped.value.trajectory.time) == 41


@pytest.mark.parametrize("done", [0, 2])
def test_a_press_while_effects_are_measured_says_that_the_run_is_complete(
    done: int, scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    own, begun = measured_effects.solve, []

    def pressing(*words: Any, **options: Any) -> Any:
        begun.append(True)
        if len(begun) == done + 2:  # the first one is that of all that follow
            press()
        return own(*words, **options)

    monkeypatch.setattr(measured_effects, "solve", pressing)
    with pytest.raises(RunInterruptedError, match="the run itself is complete") as stopped:
        simulate(scene, prove=True)
    assert stopped.value.trajectory is not None
    assert stopped.value.trajectory.status == "complete"
    assert len(stopped.value.trajectory.proof) in (done, done + 1)


@pytest.mark.parametrize("share", [0.0, 0.2, 0.4, 0.6, 0.9])
def test_a_press_on_the_way_keeps_the_way_so_far(share: float) -> None:
    long = leg("run={duration: 40 s, output_interval: 0.02 s}", "bellows.count=4")
    pressed: list[float] = []

    def watch(done: float) -> None:
        if done >= share and not pressed:
            pressed.append(done)
            press()

    with pytest.raises(RunInterruptedError) as stopped:
        simulate(long, progress=watch)
    partial = stopped.value.trajectory
    assert partial is not None
    assert partial.status == "interrupted"
    assert partial.time[-1] >= pressed[0] * 40 - 0.02


def test_a_loop_ends_with_its_first_press(scene: Scene) -> None:
    begun = []

    def run(k: int) -> None:
        begun.append(k)
        simulate(scene, progress=lambda _: press() if k == 1 else None)

    with pytest.raises(KeyboardInterrupt):
        list(map(run, range(3)))
    assert begun == [0, 1]


def test_a_second_press_raises_and_ends_no_process(scene: Scene) -> None:
    with pytest.raises(KeyboardInterrupt):
        simulate(scene, progress=lambda _: press())
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_the_handler_of_the_user_is_given_back(scene: Scene) -> None:
    def own(number: int, frame: FrameType | None) -> None:
        raise AssertionError

    before = signal.signal(signal.SIGINT, own)
    try:
        simulate(scene)
        assert signal.getsignal(signal.SIGINT) is own
    finally:
        signal.signal(signal.SIGINT, before)


def test_an_ignored_signal_stays_ignored(scene: Scene) -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        assert simulate(scene, progress=lambda _: press()).status == "complete"
    finally:
        signal.signal(signal.SIGINT, before)


def test_other_threads_leave_the_handler_alone(scene: Scene) -> None:
    seen = []

    def work() -> None:
        simulate(
            scene, verify=False, progress=lambda _: seen.append(signal.getsignal(signal.SIGINT))
        )

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert seen
    assert set(seen) == {signal.default_int_handler}


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_termination_is_an_interrupt_for_commands(number: int) -> None:
    before = signal.getsignal(number)
    with ended_like_interrupts(), gentle_interrupt() as interrupt:
        press(number)
        assert (interrupt.times, interrupt.first) == (1, signal.Signals(number).name)
        press(number)  # a shell may send it again
        assert interrupt.times == 1
    assert signal.getsignal(number) is before


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_termination_outside_of_a_run_raises(number: int) -> None:
    with pytest.raises(KeyboardInterrupt), ended_like_interrupts():
        press(number)


def test_nohup_holds() -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with ended_like_interrupts():
            press(signal.SIGHUP)
            assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGHUP, before)
