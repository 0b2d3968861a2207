"""Limit cycles of a free input, their sense, and graphs."""

from __future__ import annotations

import itertools
import signal
from pathlib import Path

import numpy as np
import pytest

from tests.unit.inverse.tasks import loop, small, task
from viscodesign import PathDesign, design, load, simulate
from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.errors import SpecError
from viscodesign.inverse.free_choice import free_choice
from viscodesign.inverse.loop_sense import wrong_sense
from viscodesign.inverse.posed_scene import posed_scene
from viscodesign.inverse.quick_motion import QuickMotion
from viscodesign.inverse.target_spec import read_target
from viscodesign.inverse.tree_graph import chain, mirrored, tree_of, with_tree
from viscodesign.inverse.wanted_path import wanted_path

HARMONICS = {"harmonics": 2, "period": ["2 s", "60 s"], "limits": ["-20 kPa", "25 kPa"]}
FREE = {"network.tubes[*].length": ["5 mm", "300 mm"], "input": HARMONICS}


@pytest.fixture(scope="module")
def ellipse(tmp_path_factory: pytest.TempPathFactory) -> PathDesign:
    folder = tmp_path_factory.mktemp("ellipse")
    return design(task(folder, FREE, loop(-1.0), tolerance="0.02 mm"))


def test_an_ellipse_is_followed_as_a_limit_cycle(ellipse: PathDesign) -> None:
    assert ellipse.status == "met"
    run = simulate(load(ellipse.spec_text))
    assert run.tip[-1] == pytest.approx(run.tip[0], abs=1e-6)
    assert ellipse.confirmed_rms_m == pytest.approx(ellipse.rms_m, rel=0.05)
    assert ellipse.evaluations < 20


def test_its_input_keeps_its_limits(ellipse: PathDesign) -> None:
    source = load(ellipse.spec_text).inputs["inlet"]
    low, high = source.extremes(1e3)
    assert -20e3 <= low < high <= 25e3
    assert 2.0 <= ellipse.parameters["input.period"] <= 60.0


def test_narrow_limits_and_a_rate_limit_are_kept_and_named(tmp_path: Path) -> None:
    narrow: dict[str, object] = {"harmonics": 1, "period": "7 s", "limits": ["-2 kPa", "2 kPa"]}
    narrow["rate_limit"] = "1 kPa/s"
    found = design(task(tmp_path, {"input": narrow}, loop(-1.0), tolerance="0.01 mm"))
    assert found.status == "not_met"
    assert "the limits of the input" in found.at_bounds
    source = load(found.spec_text).inputs["inlet"]
    low, high = source.extremes(1e3)
    assert -2e3 <= low < high <= 2e3
    time = np.linspace(0, source.period or 1.0, 4001)
    assert np.abs(np.diff(source.values(time)) / np.diff(time)).max() <= 1e3 * (1 + 1e-6)


def test_the_wrong_sense_is_refused_and_the_mirrored_graph_is_not(tmp_path: Path) -> None:
    path = task(tmp_path, FREE, loop(1.0), tolerance="0.02 mm")
    found = design(path)
    assert found.status == "refused"
    assert "goes counter-clockwise" in found.reason
    assert "column R fed first" in found.reason
    assert found.evaluations == 0
    (tmp_path / "spec.yaml").write_text(found.spec_text)
    assert design(path).status == "met"


@pytest.mark.parametrize(
    ("payload", "shortest", "refused"),
    [("0 g", "0.25 s", True), ("0 g", "0.15 s", False), ("200 g", "0.25 s", False)],
)
def test_near_the_rods_own_frequency_no_sense_is_wrong(
    payload: str, shortest: str, refused: bool, tmp_path: Path
) -> None:
    """A leg fed first at R goes counter-clockwise at 20 Hz: 41 mm2 with 3 kPa and 1.2 mm tubes."""
    leg = load("configs/leg_16_straight_air.yaml", {"loads.payload": payload})
    leg = leg.replace({"effects": "auto"})
    circle = 5e-3 * np.exp(2j * np.pi * np.arange(65) / 64) + 0.11j
    rows = np.column_stack([circle.real, circle.imag]).tolist()
    own = {"harmonics": 2, "period": [shortest, "9 s"], "limits": ["-9 kPa", "9 kPa"]}
    read = read_target(task(tmp_path, {"input": own}, {"rows": rows}))
    wanted, choice = wanted_path(read), free_choice(read, leg)
    assert choice.harmonics is not None
    scene = posed_scene(choice.harmonics.placed(leg), wanted, read.spec.tolerance)
    assert (wrong_sense(wanted, choice, scene) is not None) == refused


def test_a_path_beyond_the_longest_rod_is_refused_by_how_much(tmp_path: Path) -> None:
    """At 25 kPa a straight rod is so long: by a static simulation."""
    longest = simulate(small(input={"kind": "constant", "value": 25e3}), verify=False).tip[0, 1]
    rows = [[0.0, 0.030], [0.001, 0.034], [-0.001, 0.034]]
    found = design(task(tmp_path, FREE, {"rows": rows, "closed": True}))
    assert found.status == "refused"
    assert "out of reach" in found.reason
    beyond = float(found.reason.split("it is ")[1].split(" mm")[0])
    assert beyond == pytest.approx(1e3 * (np.hypot(0.001, 0.034) - longest), rel=0.02)


def test_a_path_in_millimetres_is_refused_at_once(tmp_path: Path) -> None:
    """Whatever is free of the input."""
    rows = [[0.0, 28.0], [1.0, 28.5], [-1.0, 28.5]]
    target = {"rows": rows, "closed": False}
    found = design(task(tmp_path, {"input.drop": ["10 kPa", "60 kPa"]}, target))
    assert found.status == "refused"
    assert "1.05e+03 times the actuator's length of 27.25 mm; are these metres?" in found.reason
    assert found.evaluations == 0


def test_the_chain_that_made_a_path_is_found(tmp_path: Path) -> None:
    wanted = small(network__tubes=[
        {"from": a, "to": b} for a, b in itertools.pairwise(["inlet", "L2", "R1", "R2", "L1"])
    ])  # fmt: skip
    path = task(tmp_path, {"network.graph": "chain"}, wanted, tolerance="0.005 mm")
    found = design(path)
    assert found.status == "met"
    assert found.graph == ("inlet-L2", "L2-R1", "R1-R2", "R2-L1")
    assert found.evaluations <= 6


def test_a_tree_finds_the_branch_that_made_a_path(tmp_path: Path) -> None:
    ends = [("inlet", "R1"), ("R1", "L2"), ("R1", "R2"), ("inlet", "L1")]
    wanted = small(network__tubes=[{"from": a, "to": b} for a, b in ends])
    path = task(tmp_path, {"network.graph": "tree"}, wanted, tolerance="0.005 mm")
    found = design(path)
    assert found.status == "met"
    assert set(found.graph) == {f"{a}-{b}" for a, b in ends}


def test_of_many_graphs_changes_find_the_one_that_made_a_path(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("viscodesign.inverse.graph_search.FEW_GRAPHS", 10)
    order = ["inlet", "L1", "R2", "L2", "R1"]
    wanted = small(network__tubes=[{"from": a, "to": b} for a, b in itertools.pairwise(order)])
    for free in ({}, {"network.tubes[*].length": ["20 mm", "80 mm"]}):
        path = task(tmp_path, {"network.graph": "chain", **free}, wanted, tolerance="0.005 mm")
        found = design(path)
        assert found.status == "met"
        assert found.graph == tuple(f"{a}-{b}" for a, b in itertools.pairwise(order))


@pytest.mark.parametrize("start", ["periodic", "equilibrium"])
def test_the_quick_motion_is_that_of_slow_flow(start: str) -> None:
    """By `simulate` with the flow through the tubes alone; slopes by differences."""
    source = {"kind": "harmonics", "period": 12.0, "cosine": [8e3, 2e3], "sine": [0, -3e3]}
    scene = small(input=source, run={"duration": 12, "output_interval": 0.1875, "start": start})
    scene = scene.replace({"effects": {"pressure_distribution": "on", "others": "off"}})
    graph = tree_of(scene.graph)
    assert graph is not None
    keys = FreeKeys(scene, ["network.tubes[*].length", "input.cosine[1]", "input.period"])
    motion = QuickMotion(keys, graph)
    run = simulate(scene)
    tip = motion.tip(keys.values)
    assert tip == pytest.approx(run.tip[: len(tip), :2], abs=2e-6)
    slopes = motion.slopes(keys.values)
    for k in (0, 2, 4, 5):
        change = np.zeros(6)
        change[k] = 1e-4 * keys.values[k]
        ends = [motion.tip(keys.values + sign * change) for sign in (1, -1)]
        expected = (ends[0] - ends[1]) / (2 * change[k])
        assert slopes[:, :, k] == pytest.approx(expected, abs=5e-3 * np.abs(expected).max())


def test_a_tree_is_written_and_read_again() -> None:
    graph = chain([3, 0, 2, 1])
    scene = with_tree(small(), graph, [(0.01 * (k + 1), 9e-4) for k in range(4)])
    assert [tube.name for tube in scene.graph.tubes] == ["inlet-L2", "L2-R1", "R1-L1", "L1-R2"]
    assert [tube.length for tube in scene.graph.tubes] == [0.01, 0.02, 0.03, 0.04]
    assert tree_of(scene.graph) == graph
    assert mirrored(mirrored(graph, 2), 2) == graph


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"harmonics": 0}, "harmonics: must be a whole number"),
        ({"limits": ["25 kPa", "-20 kPa"]}, "are reversed"),
        ({"limits": [-25, 30]}, r"free.input.limits: .*have no unit.*\[-25 kPa, 30 kPa\]"),
        ({"rate_limit": 50}, "50 has no unit beside limits"),
        ({"period": "0 s"}, "expected one value above 0"),
        ({"rate_limit": "5 kPa"}, "is a pressure"),
        ({"limit": 3}, "did you mean 'limits'"),
    ],
)
def test_a_free_input_without_sense_is_refused(
    changes: dict[str, object], message: str, tmp_path: Path
) -> None:
    with pytest.raises(SpecError, match=message):
        design(task(tmp_path, {"input": {**HARMONICS, **changes}}, loop(-1.0)))


@pytest.mark.parametrize(
    ("free", "calls", "solved"), [(FREE, 1, False), ({"input.drop": ["10 kPa", "90 kPa"]}, 3, True)]
)
def test_ctrl_c_keeps_the_best_so_far(
    free: dict[str, object], calls: int, solved: bool, tmp_path: Path
) -> None:
    """In the ranking of starts, and in the search on the scene's own model."""
    told: list[float] = []

    def progress(share: float, best_m: float) -> None:
        told.append(best_m)
        if len(told) == calls:
            signal.raise_signal(signal.SIGINT)

    path = task(tmp_path, free, small(input__drop=55e3) if solved else loop(-1.0))
    found = design(path, progress=progress)
    assert found.interrupted
    assert found.status == "not_met"
    assert "interrupted: this is the best so far, not confirmed" in found.reason
    assert found.confirmed_rms_m is None
    assert set(found.parameters) == set(
        FreeKeys(load(found.spec_text), list(found.parameters)).names
    )
    assert (found.evaluations > 0) == solved
