"""A pump of another principle streams under the same rules, judged by what is on its line."""

from __future__ import annotations

import numpy as np
import pytest

from tests.regulator_rig import RegulatorRig
from viscodesign.errors import PumpError
from viscodesign.pump.play.stream_result import TickReport
from viscodesign.scene.pumps.regulator import RegulatorSpec


def test_a_profile_is_streamed_and_followed() -> None:
    rig = RegulatorRig()
    result = rig.play()
    assert (result.status, result.verified) == ("complete", True)
    pairs = [(r.sample.pressure[0], r.sample.wanted[0]) for r in rig.rows if r.time >= 0.0]
    errors = [abs(p - w) for p, w in pairs if p is not None and w is not None]
    assert max(errors) < 1000.0
    assert max(p for p, _ in pairs if p is not None) == pytest.approx(8e3, abs=500.0)


def test_set_points_go_in_steps_of_one_tick_so_that_a_dead_host_leaves_it_standing() -> None:
    rig = RegulatorRig()
    rig.play()
    steepest = 8e3 * np.pi / 2 / 20.0 / rig.spec.step  # of the profile in one tick
    assert np.abs(np.diff(rig.set_points)).max() <= 1.5 * steepest + 2
    assert len(rig.set_points) > 40


def test_nothing_is_sent_before_it_is_armed_and_then_it_holds_what_it_has() -> None:
    rig = RegulatorRig()
    rig.device.pressure, rig.device.set_point = 5e3, 51
    with rig.link.gauges() as gauges:
        pump = rig.link.connected_pump(gauges)
        pump.connect()
        pump.look()
        assert rig.set_points == []
        assert [str(left) for left in pump.hold()] == [
            "regulator 1: untouched: no set-point was sent"
        ]
        pump.arm()
    assert rig.set_points == [51]


def test_the_pressure_cap_stops_it_and_it_retreats_below_the_cap() -> None:
    rig = RegulatorRig(spec=RegulatorSpec(full_scale=100e3, following_error=0.5))

    def press(report: TickReport) -> None:
        rig.device.extra = 21e3 * (report.time > 0.9)

    rig.happen = press
    result = rig.play()
    assert (result.status, result.rule, result.retreat) == ("stopped", "pressure_cap", "")
    assert rig.device.pressure + rig.device.extra <= 25e3
    assert max(rig.set_points) * rig.spec.step <= 25e3  # not what presses from outside
    assert np.diff(rig.set_points[np.argmax(rig.set_points) :]).max(initial=0) <= 0  # only down


def test_no_set_point_is_ever_above_the_cap() -> None:
    rig = RegulatorRig(spec=RegulatorSpec(full_scale=100e3, max_pressure=6e3))
    result = rig.play()
    assert (result.status, result.rule) == ("stopped", "travel")
    assert max(rig.set_points, default=0) * rig.spec.step <= 6e3


@pytest.mark.parametrize(
    ("rule", "verified", "trouble"),
    [
        ("silence", True, lambda rig: rig.clock.sleep(0.5)),
        ("replies", False, lambda rig: setattr(rig.device, "mute", True)),
        ("replies", False, lambda rig: setattr(rig.device, "deaf", True)),
        ("following", True, lambda rig: setattr(rig.device, "extra", -8e3)),
        ("sensor_frozen", True, lambda rig: setattr(rig.device, "stuck", True)),
    ],
)
def test_other_trouble_stops_it_by_the_same_rules(rule: str, verified: bool, trouble) -> None:  # type: ignore[no-untyped-def]
    following = 0.05 if rule == "following" else 0.5
    rig = RegulatorRig(spec=RegulatorSpec(full_scale=100e3, following_error=following))
    rig.happen = lambda report: (
        trouble(rig) if len(rig.rows) == (5 if rule == "sensor_frozen" else 20) else None
    )
    result = rig.play()
    assert (result.status, result.rule) == ("stopped", rule), result.reason
    assert result.verified is verified or rule == "following"


def test_a_restart_that_loses_the_set_point_is_noticed() -> None:
    rig = RegulatorRig(spec=RegulatorSpec(full_scale=100e3, following_error=0.5))
    answer = rig.device.answer

    def forgetful(command: str) -> str:
        reply = answer(command)
        if len(rig.rows) >= 30:
            rig.device.set_point = 0
        return reply

    rig.device.answer = forgetful  # type: ignore[method-assign]
    result = rig.play()
    assert (result.status, result.rule) == ("stopped", "command_lost")
    assert "regulator 1 holds goal 0" in result.reason


def test_one_that_falls_behind_its_profile_is_stopped_by_name() -> None:
    rig = RegulatorRig()
    rig.happen = lambda report: rig.clock.sleep(0.08 * (report.time > 0.2))
    result = rig.play()
    assert (result.status, result.rule) == ("stopped", "behind_profile")


def test_a_request_to_stop_holds_it_and_a_second_one_vents_it() -> None:
    rig = RegulatorRig()
    rig.happen = lambda report: rig.request.note(2, None) if len(rig.rows) == 25 else None
    result = rig.play()
    assert (result.status, result.verified) == ("interrupted", True)
    held = rig.device.set_point
    assert held > 20
    rig.clock.sleep(2.0)
    rig.device.advance(rig.clock.now())
    assert rig.device.pressure == pytest.approx(held * rig.spec.step, rel=1e-3)

    again = RegulatorRig()

    def twice(report: TickReport) -> None:
        if len(again.rows) == 25:
            again.request.note(2, None)
            again.request.note(2, None)

    again.happen = twice
    result = again.play()
    assert (result.status, result.verified) == ("interrupted", True)
    assert again.set_points[-1] == 0
    assert result.standing[0].words == "set to 0 kPa: it vents, verified"


def test_after_an_alarm_only_what_draws_back_is_sent() -> None:
    rig = RegulatorRig()
    rig.happen = lambda report: setattr(rig.device, "extra", 30e3) if len(rig.rows) == 30 else None
    rig.play()
    goal = rig.pump.goals[1]
    with pytest.raises(PumpError, match="locked by an alarm"):
        rig.pump.set_goals({1: goal + 1}, {1: 1.0})


@pytest.mark.parametrize(("on_stop", "last"), [("release", 0), ("retract", 20)])
def test_it_ends_as_the_user_wants(on_stop, last: int) -> None:  # type: ignore[no-untyped-def]
    rig = RegulatorRig(on_stop=on_stop)
    rig.happen = lambda report: rig.request.note(2, None) if len(rig.rows) == 25 else None
    result = rig.play()
    assert result.status == "interrupted"
    assert rig.set_points[-1] <= last


@pytest.mark.parametrize(("pressure", "set_point"), [(8e3, 700), (8e3, 0)])
def test_arming_never_raises_the_pressure(pressure: float, set_point: int) -> None:
    """Whoever left it on its way up or down: it stays where it is, or goes on down."""
    rig = RegulatorRig()
    rig.device.pressure, rig.device.set_point = pressure, set_point
    with rig.link.gauges() as gauges:
        rig.link.connected_pump(gauges).arm()
    assert rig.set_points[0] * rig.spec.step <= 1.5 * pressure
    assert rig.set_points[0] <= set_point
