"""Which effects a scene calls for: what may be left out, what stays, and what is told of it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import FrozenInstanceError, fields
from functools import cache
from itertools import pairwise
from typing import Any, ClassVar

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.scenes import LEG_LENGTH, leg
from viscodesign import check, simulate
from viscodesign.checks.check import Check
from viscodesign.effects import select, tip_displacements
from viscodesign.effects.allowed_sets import AllowedSets, Names
from viscodesign.effects.catalogue import catalogue, every_effect
from viscodesign.effects.gravity import Gravity
from viscodesign.effects.select import NUMBERS, Selection, select_effects
from viscodesign.effects.tip_displacements import TipDisplacements
from viscodesign.estimate import modal_response
from viscodesign.estimate.linear_network import LinearNetworks
from viscodesign.estimate.motion_estimate import MotionEstimate, tips
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.results.findings import Verdict
from viscodesign.storage.lru_cache import LruCache

AUTO = "effects=auto"
SLOW = ("input={kind: sine, amplitude: 3 kPa, frequency: 0.001 Hz}", "fluid=water",
        "run={duration: 2000 s, output_interval: 10 s}")  # fmt: skip
SMALL = ("bellows.count=4", "input={kind: sine, amplitude: 3 kPa, frequency: 1 Hz}")
STILL = "input={kind: constant, value: 0}"
SCENES = {
    "the paper's leg": (),
    "water, on its side": ("bellows.count=4", "fluid=water", "loads.gravity={tilt: 60 deg}", "network.tube_radius=1 mm"),
    "payload": ("bellows.count=4", "loads.payload=20 g", "loads.gravity=on"),
    "small swing": ("bellows.count=4", "input={kind: sine, amplitude: 3 kPa, frequency: 1 Hz}",),
    "soft tubes": ("bellows.count=4", "input={kind: sine, amplitude: 30 kPa, frequency: 0.1 Hz}",
                   "network.tube_wall={youngs_modulus: 1 MPa, thickness: 0.3 mm}"),
    "let go": ("bellows.count=4", "input={kind: step, value: 500 Pa}", "loads.gravity={tilt: 90 deg}", "run.start=rest"),
}  # fmt: skip
ACCURACIES = (0.2, 0.02, 0.005, 1e-4, 1e-7)


def selection(*overrides: str) -> Selection:
    return select_effects(SceneQuantities(leg(*overrides)))


def verdicts(*overrides: str) -> dict[str, Verdict]:
    return {v.name: v for v in check(leg(*overrides)).effects}


def active(*overrides: str) -> set[str]:
    return {name for name, verdict in verdicts(*overrides).items() if verdict.taken}


def estimated(quantities: SceneQuantities, names: Iterable[str]) -> MotionEstimate:
    """The estimate with these effects, in the order of the catalogue."""
    effects, own = every_effect(quantities), set(names)
    terms = [effects[name].estimate_term() for name in effects if name in own]
    return quantities.bare_estimate.plus(*(term for term in terms if term is not None))


# -- what may be left out ---------------------------------------------------


@cache
def ladder(scene: str) -> tuple[tuple[SceneQuantities, Selection], ...]:
    """Selections at ever smaller accuracies."""
    several = [
        SceneQuantities(leg(*SCENES[scene], AUTO, f"accuracy={accuracy}"))
        for accuracy in ACCURACIES
    ]
    return tuple((quantities, select_effects(quantities)) for quantities in several)


def together(quantities: SceneQuantities, found: Selection) -> float:
    """How far the tip moves by all omissions, over what they may spend."""
    everything = estimated(quantities, found.sets.present)
    apart = estimated(quantities, (e.name for e in found.effects)).distance(everything)
    return apart / (NUMBERS.accuracy_share * quantities.accuracy * LEG_LENGTH)


@pytest.mark.parametrize("scene", SCENES)
def test_omissions_fit_into_their_share_together(scene: str) -> None:
    for quantities, found in ladder(scene):
        assert together(quantities, found) <= 1.0
        names = {e.name for e in found.effects}
        for verdict in found.verdicts:
            needed = catalogue()[verdict.name].needs
            if verdict.name in found.sets.present - names and names.issuperset(needed):
                assert verdict.budget_share <= NUMBERS.accuracy_share


@pytest.mark.parametrize("scene", SCENES)
def test_a_smaller_accuracy_never_leaves_out_more(scene: str) -> None:
    """Counted: what one effect does depends on the others, so one may give way to two."""
    counts = [len(found.effects) for _, found in ladder(scene)]
    assert counts == sorted(counts)
    assert counts[0] < counts[-1]


@pytest.mark.parametrize("scene", [s for s in SCENES if s != "small swing"])
def test_a_tighter_accuracy_mostly_keeps_the_effects_of_a_looser_one(scene: str) -> None:
    names = [{e.name for e in found.effects} for _, found in ladder(scene)]
    assert all(coarse <= fine for coarse, fine in pairwise(names))


@pytest.mark.parametrize("scene", SCENES)
def test_the_finest_accuracy_neglects_only_what_has_no_effect(scene: str) -> None:
    _, found = ladder(scene)[-1]
    assert found.sets.present - {e.name for e in found.effects} <= {"collapse"}


@given(
    amplitude=st.floats(200.0, 3e4),
    frequency=st.floats(0.02, 20.0),
    tilt=st.floats(0.0, 90.0),
    accuracy=st.sampled_from(ACCURACIES),
)
@settings(max_examples=5, deadline=None)
def test_omissions_fit_whatever_the_scene(
    amplitude: float, frequency: float, tilt: float, accuracy: float
) -> None:
    wave = f"input={{kind: sine, amplitude: {amplitude}, frequency: {frequency}}}"
    run = f"run.duration={2 / frequency}"
    interval = f"run.output_interval={0.05 / frequency}"
    quantities = SceneQuantities(
        leg("bellows.count=4", wave, run, interval, f"loads.gravity.tilt={tilt} deg", AUTO,
            f"accuracy={accuracy}")
    )  # fmt: skip
    assert together(quantities, select_effects(quantities)) <= 1.0


def bent(pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A law of bellows of which the first one bends at any pressure."""
    curvature = np.zeros_like(pressure)
    curvature[..., 0] = 10.0
    return 1e-12 * pressure, curvature, np.zeros_like(pressure)


class Push(Gravity):
    """A law that it takes two to leave out: either of them alone is enough."""

    name: ClassVar[str] = "push"

    def present(self, quantities: SceneQuantities) -> bool:
        return True

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(wall=bent)


class Shove(Push):
    """The other one."""

    name: ClassVar[str] = "shove"


def test_omitted_effects_may_add_up_to_more_than_each_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    known = {**catalogue(), "push": Push, "shove": Shove}
    monkeypatch.setattr("viscodesign.effects.catalogue.catalogue", lambda: known)
    found = {e.name for e in selection(AUTO, STILL).effects}
    assert len(found & {"push", "shove"}) == 1


# -- what choosing costs ------------------------------------------------------

RINGING = ("bellows.count=4", "fluid=water", "loads.gravity={tilt: 90 deg}",
           "input={kind: square, high: 5 kPa, low: 0 kPa, frequency: 3 Hz}",
           "run={duration: 2 s, output_interval: 10 ms}")  # fmt: skip


@pytest.mark.parametrize("scene", [SMALL, RINGING, SCENES["soft tubes"]])
def test_no_motion_is_estimated_in_vain(
    scene: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every set of effects whose motion is estimated is compared with another, and once."""
    estimated, compared = list[MotionEstimate](), set[frozenset[str]]()
    plain_tips, plain_between = tip_displacements.tips, TipDisplacements.between

    def tips(estimates: Sequence[MotionEstimate]) -> np.ndarray:
        estimated.extend(estimates)
        return plain_tips(estimates)

    def between(self: TipDisplacements, one: Names, other: Names) -> float:
        if one != other:
            compared.update((one, other))
        return plain_between(self, one, other)

    monkeypatch.setattr(tip_displacements, "tips", tips)
    monkeypatch.setattr(tip_displacements, "_distances", LruCache(1))
    monkeypatch.setattr(select, "_choices", LruCache(1))
    monkeypatch.setattr(TipDisplacements, "between", between)
    found = selection(AUTO, *scene)
    assert len(found.active) < len(found.everything)
    assert len(estimated) == len(compared)


@pytest.mark.parametrize(("scene", "most"), [(SMALL, 250_000), (RINGING, 245_000)])
def test_filters_of_choosing(
    scene: tuple[str, ...], most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Networks that begin alike are filtered once, and only rods that swing are."""
    filtered, plain = list[int](), modal_response._by_loop

    def counted(loop: str, numbers: Any, time: Any, drive: np.ndarray, state: Any) -> np.ndarray:
        filtered.append(drive.size)
        return plain(loop, numbers, time, drive, state)

    monkeypatch.setattr(tip_displacements, "_distances", LruCache(1))
    monkeypatch.setattr(select, "_choices", LruCache(1))
    monkeypatch.setattr(modal_response, "_by_loop", counted)
    selection(AUTO, *scene)
    assert 0.5 * most < sum(filtered) <= most


# -- what costs nothing -----------------------------------------------------


def test_weight_along_a_straight_leg_is_left_out() -> None:
    hanging = verdicts(AUTO, STILL, "loads.gravity=on")["gravity"]
    assert not hanging.taken
    assert hanging.budget_share < 0.1  # the weight draws it a little longer
    across = verdicts(AUTO, STILL, "loads.gravity.tilt=90 deg")["gravity"]
    assert across.taken
    assert across.contribution_m > 30 * hanging.contribution_m


def test_nothing_is_fed_back_where_nothing_loads_the_rod() -> None:
    assert not verdicts(AUTO, *SLOW)["feedback"].taken
    assert verdicts(AUTO, *SLOW, "effects.inertia=off")["feedback"].contribution_m == 0.0
    loaded = verdicts(AUTO, *SLOW, "loads.tip_force.x=2 N")["feedback"]
    assert loaded.contribution_m > 0.0


def test_a_slow_input_needs_no_inertia() -> None:
    found = verdicts(AUTO, *SLOW)
    for name in ("inertia", "rotary_inertia", "damping", "fluid_inertance"):
        assert not found[name].taken
        assert found[name].budget_share < 1e-2
    assert found["pressure_distribution"].taken


def test_a_pressure_that_never_moves_calls_for_nothing() -> None:
    assert active(AUTO, STILL) == set()


def test_a_collapse_that_no_pressure_reaches_changes_nothing() -> None:
    """Up to the iteration by which an estimate finds its means over the motion."""
    assert verdicts(AUTO, *SMALL)["collapse"].budget_share <= 1e-3


# -- what belongs together --------------------------------------------------


@pytest.mark.parametrize(
    ("needed", "dependants"),
    [
        (
            "pressure_distribution",
            ["tube_compliance", "flow_regime", "fluid_inertance", "choked_flow"],
        ),
        ("gas_compressibility", ["choked_flow"]),
        ("inertia", ["rotary_inertia"]),
    ],
)
def test_dependants_go_with_what_they_need(needed: str, dependants: list[str]) -> None:
    assert {n for n, kind in catalogue().items() if needed in kind.needs} == set(dependants)
    # So fine that nothing else would be left out.
    everything = (AUTO, "accuracy=1e-6")
    assert set(dependants) <= active(*everything)
    without = verdicts(*everything, f"effects={{{needed}: off}}")
    for name in dependants:
        assert not without[name].taken
        assert (
            f"neglected with {needed}, without which it has nothing to act on"
            in without[name].reason
        )


@pytest.mark.parametrize("name", [n for n, kind in catalogue().items() if kind.needs])
def test_an_effect_that_is_on_keeps_the_one_it_depends_on(name: str) -> None:
    needed = catalogue()[name].needs
    assert needed
    still = (
        STILL,
        "loads.gravity=off",
        "network.tube_wall={youngs_modulus: 1 MPa, thickness: 1 mm}",
    )
    assert not active(AUTO, *still).intersection(needed)
    found = verdicts(*still, f"effects={{{name}: on}}")
    assert found[name].taken
    for other in needed:
        assert found[other].taken
        assert found[other].mode == "auto"


def test_switching_off_a_needed_effect_overrides_one_that_depends_on_it() -> None:
    found = verdicts("effects={rotary_inertia: on, inertia: off}")
    assert not found["rotary_inertia"].taken
    assert found["rotary_inertia"].mode == "on"
    assert "without which it has nothing to act on" in found["rotary_inertia"].reason


def test_inertance_stays_beside_losses_of_fast_flow() -> None:
    """It spares the solver unknown flows, so it is kept though it hardly moves the tip."""
    found = verdicts(AUTO, "bellows.count=4")
    assert found["flow_regime"].taken
    assert found["fluid_inertance"].taken
    assert found["fluid_inertance"].budget_share < NUMBERS.accuracy_share
    assert "no extra cost beside flow_regime" in found["fluid_inertance"].reason
    alone = verdicts("bellows.count=4", "effects={flow_regime: off}")["fluid_inertance"]
    assert not alone.taken


def test_inertia_brings_damping_unless_it_is_forbidden() -> None:
    def names(*overrides: str) -> tuple[set[str], set[str]]:
        found = selection(*SLOW, *overrides)
        return {e.name for e in found.effects}, {e.name for e in found.with_flipped("inertia")}

    before, after = names(AUTO)
    assert not before & {"inertia", "damping"}
    assert after == before | {"inertia", "damping"}
    before, after = names("effects={damping: off}")
    assert after == before | {"inertia"}
    before, after = names(AUTO, "actuator.damping_time=0")
    assert after == before | {"inertia"}


def test_switching_an_effect_switches_those_tied_to_it() -> None:
    found = selection("effects={others: on}")
    gone = {e.name for e in found.effects} - {e.name for e in found.with_flipped("inertia")}
    assert gone == {"inertia", "rotary_inertia"}
    still = selection(AUTO, STILL)
    assert [e.name for e in still.effects] == []
    brought = [e.name for e in still.with_flipped("flow_regime")]
    assert brought == ["pressure_distribution", "flow_regime"]


def test_effects_join_in_the_order_of_the_catalogue() -> None:
    order = list(catalogue())
    names = [e.name for e in selection("effects={others: on}").effects]
    assert names == sorted(names, key=order.index)
    assert len(names) > 8


# -- what has to stay -------------------------------------------------------


def test_loads_that_meet_a_straight_rod_need_inertia() -> None:
    found = verdicts(AUTO, STILL, "run.start=rest", "loads.tip_force.x=1e-9", "accuracy=20 %")
    assert found["inertia"].taken
    assert found["inertia"].budget_share < NUMBERS.accuracy_share
    assert "this scene requires it" in found["inertia"].reason
    assert found["tip_load"].taken


def test_two_inlets_of_one_network_need_its_flow() -> None:
    tubes = ", ".join(f"{{from: {a}, to: {b}, length: 4 cm, radius: 1 mm}}"
                      for a, b in (("a", "R1"), ("R1", "L1"), ("L1", "b")))  # fmt: skip
    found = verdicts(
        AUTO, "bellows.count=2", "input=null", "accuracy=20 %",
        "inputs={a: {kind: constant, value: 1}, b: {kind: constant, value: 2}}",
        f"network={{layout: custom, tubes: [{tubes}]}}",
    )["pressure_distribution"]  # fmt: skip
    assert found.taken
    assert "this scene requires it" in found.reason


# -- what is told -----------------------------------------------------------


@pytest.mark.parametrize("modes", ["auto", "on", "off"])
def test_a_verdict_for_every_member(modes: str) -> None:
    found = check(leg(*SCENES["soft tubes"], f"effects={modes}")).effects
    assert [v.name for v in found] == list(catalogue())
    for verdict in found:
        assert verdict.reason
        assert verdict.contribution_m >= 0.0
        assert verdict.budget_share == pytest.approx(verdict.contribution_m / (0.005 * LEG_LENGTH))
        follows = not catalogue()[verdict.name].own_rule
        assert verdict.mode == (modes if follows else "auto")
        assert not follows or modes != "off" or not verdict.taken


def test_an_effect_that_is_on_without_what_it_needs_is_warned_of() -> None:
    def warned(effects: str) -> dict[str, str]:
        found = check(leg(f"effects={effects}"))
        return {w.where: w.message for w in found.warnings if w.code == "unmet_need"}

    told = warned("{choked_flow: on, gas_compressibility: off}")
    assert set(told) == {"effects.choked_flow"}
    assert "use `gas_compressibility: auto`" in told["effects.choked_flow"]
    assert not warned("{choked_flow: on, others: off}")  # what is needed follows it
    assert not warned("{others: on, gas_compressibility: off}")


def needed_off(found: Check) -> dict[str, str]:
    return {w.where: w.message for w in found.warnings if w.code == "needed_effect_off"}


def test_what_is_off_although_needed_is_warned_of_in_millimetres() -> None:
    off = check(leg("effects={collapse: off, gas_compressibility: off}"))
    told = {v.name: v for v in off.effects}
    warned = needed_off(off)
    assert set(warned) == {"effects.collapse", "effects.gas_compressibility"}
    for name in ("collapse", "gas_compressibility"):
        message = warned[f"effects.{name}"]
        assert told[name].budget_share > 1.0
        assert f"effects.{name} is off" in message
        assert f"about {1e3 * told[name].contribution_m:.3g} mm" in message
        assert f"{told[name].budget_share:.3g} times the requested accuracy" in message


def test_what_is_off_and_not_needed_is_not_warned_of() -> None:
    assert needed_off(check(leg("effects={feedback: off, fluid_mass: off}"))) == {}
    assert needed_off(check(leg(AUTO))) == {}
    # Twice the accuracy is a reason, a hundredth of it is none.
    assert "effects.inertia" in needed_off(check(leg("effects={inertia: off}")))
    assert needed_off(check(leg("effects={inertia: off}", "accuracy=10 %"))) == {}


def test_reasons_say_how_the_choice_was_made() -> None:
    found = verdicts("effects={inertia: on, collapse: off}")
    assert found["inertia"].reason.startswith("included: set in the spec; ")
    assert found["collapse"].reason.startswith("neglected: set in the spec; ")
    assert found["tip_load"].reason == "not applicable: the tip is free"
    assert found["pressure_distribution"].reason.startswith("included: moves the tip by about ")
    assert "times the accuracy" in found["pressure_distribution"].reason
    assert found["feedback"].reason.startswith("neglected: moves the tip by about ")
    assert "% of the accuracy" in found["feedback"].reason


def test_what_is_absent_has_no_weight() -> None:
    found = verdicts(AUTO, STILL)["gravity"]
    assert (found.taken, found.weight, found.contribution_m) == (False, 0.0, 0.0)
    assert found.reason.startswith("not applicable: ")


def test_selecting_effects_does_not_change_the_quantities_of_a_scene() -> None:
    quantities = SceneQuantities(leg(AUTO))
    assert [f.name for f in fields(quantities)] == ["scene"]
    select_effects(quantities)
    with pytest.raises(FrozenInstanceError):
        quantities.scene = leg()  # type: ignore[misc]


def test_the_choice_is_the_same_every_time() -> None:
    first, second = (selection(AUTO).verdicts for _ in range(2))
    assert first == second
    modes = ["inertia: on", "collapse: off", "feedback: on"]
    ordered, reversed_ = (
        verdicts(f"effects={{{', '.join(m)}}}") for m in (modes, list(reversed(modes)))
    )
    assert ordered == reversed_


# -- gas that goes fast ----------------------------------------------------------

SUCKED = "input={kind: step, value: -90 kPa, time: 0.1 s}"
WIDE = ("network.tube_radius=1.5 mm", "run={duration: 0.5 s}")


@pytest.mark.parametrize("accuracy", ["0.5 %", "20 %"])
def test_no_gas_goes_faster_than_it_can_where_effects_are_free(accuracy: str) -> None:
    """However little it moves the tip: a run without the effect is solved again."""
    told = simulate(leg(AUTO, SUCKED, *WIDE, f"accuracy={accuracy}"), verify=False)
    assert told.status == "complete", told.failure
    assert not {"choking", "fast_gas"} & {reason.code for reason in told.violations}
    assert {v.name for v in told.effects if v.taken} >= {"choked_flow", "gas_compressibility"}


def test_gas_that_may_not_choke_is_told_of() -> None:
    forbidden = "effects={choked_flow: off, others: auto}"
    told = simulate(leg(forbidden, SUCKED, *WIDE), verify=False)
    assert "choking" in {reason.code for reason in told.violations}
    assert told.validity == "outside"


@pytest.mark.parametrize(
    ("modes", "taken"),
    [("auto", True), ("off", True), ("{tip_load: on, others: off}", True), ("{tip_load: auto, others: off}", True),
     ("{tip_load: off}", False), ("{tip_load: off, others: on}", False)],
)  # fmt: skip
def test_a_stated_load_acts_unless_it_is_named_off(modes: str, taken: bool) -> None:
    found = verdicts(AUTO, "loads.payload=20 g", f"effects={modes}")
    assert found["tip_load"].taken is taken


@pytest.mark.parametrize(
    "changes",
    [
        ("effects={inertia: on}",),
        ("effects={inertia: on}", "actuator.damping_time=1 us"),
        ("loads.gravity={acceleration: 9.81, tilt: 90 deg}", "run.start=rest", "effects=auto"),
    ],
)
def test_damping_goes_with_inertia_however_little_it_does(changes: tuple[str, ...]) -> None:
    scene = leg(
        "bellows.count=4", "input={kind: sine, amplitude: 10 kPa, frequency: 0.1 Hz}", *changes
    )
    active = select_effects(SceneQuantities(scene)).active
    assert {"inertia", "damping"} <= active
    forbidden = leg("bellows.count=4", *changes, "effects.damping=off")
    assert "damping" not in select_effects(SceneQuantities(forbidden)).active


@pytest.mark.parametrize(
    ("source", "lowest"),
    [
        ("{kind: table, rows: [[0, 2 kPa], [1, 40 kPa], [2, 2 kPa]]}", "2 kPa"),
        ("{kind: constant, value: 5 kPa}", "5 kPa"),
        ("{kind: table, rows: [[0, 0], [1, -3 kPa]]}", "-3 kPa"),
    ],
)
def test_the_lowest_inlet_pressure_is_one_that_is_met(source: str, lowest: str) -> None:
    """The baseline is none of an inlet that never comes down to it."""
    reason = verdicts("bellows.count=4", f"input={source}", "effects=auto")["collapse"].reason
    assert reason.endswith(f"the lowest inlet pressure is {lowest}")


# -- what it takes ------------------------------------------------------------


def test_choosing_solves_few_arrays_of_networks(monkeypatch: pytest.MonkeyPatch) -> None:
    """One by one, with the means of each from the linear laws, it was 118."""
    solved, pressures = [], LinearNetworks.pressures

    def counted(self: LinearNetworks, *given: np.ndarray) -> np.ndarray:
        solved.append(len(self.capacity))
        return pressures(self, *given)

    monkeypatch.setattr(LinearNetworks, "pressures", counted)
    select_effects(SceneQuantities(leg(AUTO, "fluid=air", "run.duration=1.01 s")))
    assert len(solved) <= 24
    assert max(solved) >= 5


def test_effects_are_weighed_once_where_none_is_left_out_that_others_follow(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Everything, each effect less, and the choice: nothing else is estimated for a verdict."""
    quantities = SceneQuantities(leg(AUTO, "fluid=air", "effects={inertia: on}"))
    estimated: list[int] = []

    def counted(estimates: Sequence[MotionEstimate]) -> np.ndarray:
        estimated.append(len(estimates))
        return tips(estimates)

    monkeypatch.setattr(tip_displacements, "tips", counted)
    found = select_effects(quantities)
    left_out = {effect.name for effect in found.neglected}
    assert left_out
    assert not any(found.sets.is_followed(n, found.active) for n in left_out)
    acting = [v.name for v in found.verdicts if v.present and v.name in found.everything]
    assert sum(estimated) <= len(acting) + 4
    told = {v.name: v.contribution_m for v in found.verdicts}
    for name in left_out & {n for n in acting if found.sets.acts_in(n, found.active)}:
        lacking = found.sets.without(found.everything, name)
        assert told[name] == found.displacements.between(found.everything, lacking)


def test_what_follows_an_effect() -> None:
    sets = AllowedSets(SceneQuantities(leg(AUTO, "fluid=air")))
    assert sets.is_followed("inertia", frozenset({"damping"}))
    assert not sets.is_followed("inertia", frozenset({"gravity"}))
    assert sets.is_followed("flow_regime", frozenset({"fluid_inertance"}))
    assert not sets.is_followed("gravity", sets.everything)


def test_a_dominant_effect_is_told_by_the_set_in_which_it_was_weighed() -> None:
    quantities = SceneQuantities(leg(AUTO, "bellows.count=4"))
    found = select_effects(quantities)
    share = NUMBERS.accuracy_share * quantities.requested_m
    told = {v.name: v.contribution_m for v in found.verdicts if v.taken}
    dominant = [n for n in told if told[n] > NUMBERS.always_kept * share and found.sets.leads(n)]
    assert dominant
    everything = found.everything
    for name in dominant:
        apart = found.displacements.between(everything, found.sets.without(everything, name))
        assert told[name] == apart
        # Nearly what it does in the set that was chosen.
        now = found.displacements.between(found.active, found.sets.flipped(found.active, name))
        assert told[name] == pytest.approx(now, abs=2 * share)
