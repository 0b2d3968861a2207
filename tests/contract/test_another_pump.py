"""A pump of another principle streams under the same rules: they know nothing of servos."""

from __future__ import annotations

import ast

import numpy as np
import pytest

from tests.rig.regulator import RegulatorPump, SimulatedRegulator
from tests.scenes import ROOT
from viscodesign.interrupt import StopRequest
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.play.stream import Stream
from viscodesign.pump.play.stream_result import StreamResult, TickReport
from viscodesign.pump.profile import Profile

FAMILY = ("viscodesign.pump.ax", "viscodesign.pump.boards", "viscodesign.pump.simulated")
PLAY = sorted((ROOT / "viscodesign" / "pump" / "play").glob("*.py"))


@pytest.mark.parametrize("path", PLAY, ids=lambda path: path.stem)
def test_what_plays_a_profile_imports_nothing_of_a_family(path) -> None:  # type: ignore[no-untyped-def]
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module:
            names = [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
            assert not any(name.startswith(FAMILY) for name in names), names


class Regulated:
    """Up and down by 8 kPa in two seconds."""

    def __init__(self) -> None:
        self.clock = SteppedClock()
        self.device = SimulatedRegulator(self.clock)
        self.pump = RegulatorPump(self.device, self.clock)
        self.request = StopRequest()
        self.rows: list[TickReport] = []

    def happen(self, report: TickReport) -> None:
        """What happens after a tick."""

    def observe(self, report: TickReport) -> None:
        self.rows.append(report)
        self.happen(report)

    def play(self) -> StreamResult:
        time = np.linspace(0.0, 2.0, 81)
        pressure = 8e3 * np.sin(np.pi * time)[:, None] ** 2
        steps = pressure / self.pump.limits.step
        profile = Profile(("inlet",), (1,), time, steps, pressure)
        return Stream(self.pump, profile, self.request, self.observe, rate=30.0).play()


def test_a_profile_is_streamed_and_followed() -> None:
    rig = Regulated()
    result = rig.play()
    assert (result.status, result.verified) == ("complete", True)
    pairs = [(r.sample.pressure[0], r.sample.wanted[0]) for r in rig.rows if r.time >= 0.0]
    errors = [abs(p - w) for p, w in pairs if p is not None and w is not None]
    assert max(errors) < 1000.0
    assert max(p for p, _ in pairs if p is not None) == pytest.approx(8e3, abs=500.0)
    assert np.abs(np.diff(rig.device.commands)).max() <= 2000.0


def test_the_pressure_cap_stops_it_and_it_retreats_below_the_cap() -> None:
    rig = Regulated()
    rig.happen = lambda report: setattr(rig.device, "offset", 21e3 * (report.time > 0.4))  # type: ignore[method-assign]
    result = rig.play()
    assert (result.status, result.rule, result.retreat) == ("stopped", "pressure_cap", "")
    assert rig.device.measured() - 101_325.0 <= 25e3


@pytest.mark.parametrize(
    ("rule", "trouble"),
    [
        ("silence", lambda rig: rig.clock.sleep(0.5)),
        ("replies", lambda rig: setattr(rig.device, "plugged", False)),
        ("command_lost", lambda rig: setattr(rig.device, "powered", False)),
    ],
)
def test_other_trouble_stops_it_by_the_same_rules(rule: str, trouble) -> None:  # type: ignore[no-untyped-def]
    rig = Regulated()
    rig.happen = lambda report: trouble(rig) if len(rig.rows) == 20 else None  # type: ignore[method-assign]
    result = rig.play()
    assert (result.status, result.rule) == ("stopped", rule)
    assert result.verified is (rule != "replies")


def test_a_request_to_stop_holds_it() -> None:
    rig = Regulated()
    rig.happen = lambda report: rig.request.note(2, None) if len(rig.rows) == 30 else None  # type: ignore[method-assign]
    result = rig.play()
    assert (result.status, result.verified) == ("interrupted", True)
    before = rig.device.pressure
    rig.clock.sleep(2.0)
    assert rig.device.measured() - 101_325.0 == pytest.approx(before, abs=1.0)
