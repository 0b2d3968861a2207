"""A run is saved and read again to the last digit; what its files lack is named."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.scenes import leg
from tests.trajectories import ablated_run, of_scene, with_two_inlets
from tests.trajectories import made_run as made_long_run
from viscodesign import Trajectory, simulate
from viscodesign.errors import UsageError, ViscodesignError
from viscodesign.results.findings import Notice, RetryAttempt, Scales, Verdict
from viscodesign.results.trajectory import Cost
from viscodesign.scene.reading.write import resolved_yaml

SPEC = resolved_yaml(leg())
TIMES = np.linspace(0.0, 8.0, 41)


def made_run(**changes: Any) -> Trajectory:
    """The made-up run with few output times."""
    return made_long_run(**{"time": TIMES, **changes})


TWO = leg(config="antagonistic_two_inlets")
CONSTANT = replace(made_run().classification, scales=Scales(0.03, 0.2, math.inf, 1.0))
RUNS: dict[str, Callable[[], Trajectory]] = {
    "plain": lambda: made_run(spec_text=SPEC),
    "ablated": lambda: ablated_run(spec_text=SPEC, time=TIMES),
    "failed": lambda: made_run(spec_text=SPEC, status="failed", failure="stretch below 0.2"),
    "interrupted": lambda: made_run(spec_text=SPEC, status="interrupted", failure="Ctrl-C"),
    "one row": lambda: made_run(spec_text=SPEC, time=np.array([0.0])),
    "two inlets": lambda: of_scene(with_two_inlets(made_run(), -0.5), TWO),
    "thinned": lambda: thinned(made_run(spec_text=SPEC, time=np.linspace(0, 1, 12))),
    "outside": lambda: made_run(spec_text=SPEC, violations=(Notice("choking", "chokes", "R1", 0.5),)),
    "infinite": lambda: made_run(
        spec_text=SPEC, classification=CONSTANT,
        effects=(Verdict("flow_regime", "auto", True, math.inf, "a/b", "why", math.inf, math.inf),),
    ),
    "retried": lambda: made_run(
        spec_text=SPEC, ladder=(RetryAttempt(0.1, "less", True, "stuck"),), cost=Cost(steps=3),
        provenance={"version": "1", "packages": {"numpy": "2"}},
    ),
    "not numbers": lambda: made_run(spec_text=SPEC).with_arrays(flow=np.full((41, 16), np.nan)),
}  # fmt: skip


def thinned(run: Trajectory) -> Trajectory:
    """The run with every fifth shape, and the last."""
    kept = replace(run, shape_every=5)
    return kept.with_arrays(shape=run.shape[kept.shape_rows])


@pytest.mark.parametrize("name", RUNS)
def test_a_run_comes_back_as_it_was(name: str, tmp_path: Path) -> None:
    run = RUNS[name]()
    run.save(tmp_path / "a", plots=False, report=False)
    back = Trajectory.read(tmp_path / "a")
    np.testing.assert_equal(back.frame().to_numpy(), run.frame().to_numpy())
    np.testing.assert_array_equal(back.shape_frame(), run.shape_frame())
    assert back.spec_text == run.spec_text
    told, was = back.summary(), run.summary()
    for document in (told, was):
        document.pop("cost")
    assert told == was
    for field in ("bellows", "tubes", "inlets", "effects", "proof", "shape_every", "status"):
        assert getattr(back, field) == getattr(run, field)
    back.save(tmp_path / "b", plots=False, report=False)
    for file in ("trajectory.csv", "shape.csv", "spec.yaml"):
        assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes()


def test_a_real_run_comes_back_too(tmp_path: Path) -> None:
    scene = leg("run.duration=0.1 s", config="leg_4_air")
    run = simulate(scene, verify=False)
    run.save(tmp_path, plots=False, report=False)
    back = Trajectory.read(tmp_path)
    for quantity in ("time", "tip", "inlet_pressure", "pressure", "flow", "shape"):
        np.testing.assert_array_equal(back[quantity], run[quantity])
    np.testing.assert_array_equal(back.arc, run.arc)
    assert (back.length, back.width, back.period) == (run.length, run.width, run.period)
    assert back.metrics == run.metrics
    assert back.provenance == run.provenance


@pytest.mark.parametrize("quantity", ["volume", "inflow", "section_stretch", "presure"])
def test_what_no_file_has_is_absent_by_name(quantity: str, tmp_path: Path) -> None:
    made_run(spec_text=SPEC).save(tmp_path, plots=False, report=False)
    back = Trajectory.read(tmp_path)
    with pytest.raises(ViscodesignError, match=f"this run has no '{quantity}'") as caught:
        back[quantity]
    assert isinstance(caught.value, KeyError)
    with pytest.raises(ViscodesignError, match=f"this run has no '{quantity}'"):
        back.frame("tip_x", quantity)
    assert "It has time, tip, inlet_pressure, pressure, flow, shape" in str(caught.value)
    assert ("did you mean 'pressure'?" in str(caught.value)) == (quantity == "presure")


def damage(file: str, change: Callable[[Any], Any]) -> Callable[[Path], None]:
    def apply(folder: Path) -> None:
        path = folder / file
        if file.endswith(".json"):
            path.write_text(json.dumps(change(json.loads(path.read_text()))))
        else:
            path.write_text(change(path.read_text()))

    return apply


def without(*keys: str) -> Callable[[dict[str, Any]], dict[str, Any]]:
    return lambda summary: {key: value for key, value in summary.items() if key not in keys}


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda folder: (folder / "summary.json").unlink(), "there is no summary.json"),
        (lambda folder: (folder / "shape.csv").unlink(), "there is no shape.csv"),
        (damage("trajectory.csv", lambda text: text.replace("pressure_R1_pa", "p")), "no column pressure_R1_pa"),
        (damage("trajectory.csv", lambda text: text.rpartition(",")[0]), "is not a whole table"),
        (damage("shape.csv", lambda text: text[: text.rindex("\n", 0, -1)]), "do not fit together"),
        (damage("spec.yaml", lambda text: text.replace("109", "110")), "was changed after the run"),
        (damage("spec.yaml", lambda text: f"{text}# mine\n"), "was changed after the run"),
        (damage("summary.json", without("scales")), "do not fit together"),
        (damage("summary.json", without("status")), "is not the summary of a run"),
    ],
)  # fmt: skip
def test_a_folder_that_is_not_of_a_run_is_told(
    tmp_path: Path, spoil: Callable[[Path], None], words: str
) -> None:
    made_run(spec_text=SPEC).save(tmp_path, plots=False, report=False)
    spoil(tmp_path)
    with pytest.raises(UsageError) as caught:
        Trajectory.read(tmp_path)
    assert words in str(caught.value)
    assert str(tmp_path) in str(caught.value)


@pytest.mark.parametrize("name", ["none", "file"])
def test_what_is_no_folder_is_told(tmp_path: Path, name: str) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(UsageError, match="expected the folder of a run"):
        Trajectory.read(tmp_path / name)


@pytest.mark.parametrize("key", ["provenance", "validity", "resolved_sha256", "ladder", "cutoff"])
def test_a_run_of_an_older_version_may_say_less(tmp_path: Path, key: str) -> None:
    made_run(spec_text=SPEC).save(tmp_path, plots=False, report=False)
    damage("summary.json", without(key))(tmp_path)
    assert Trajectory.read(tmp_path).status == "complete"


def test_line_ends_of_another_system_are_no_change(tmp_path: Path) -> None:
    made_run(spec_text=SPEC).save(tmp_path, plots=False, report=False)
    for name in ("spec.yaml", "trajectory.csv", "shape.csv"):
        file = tmp_path / name
        file.write_bytes(file.read_bytes().replace(b"\n", b"\r\n"))
    assert Trajectory.read(tmp_path).spec_text == SPEC


def test_a_folder_of_other_files_is_not_written_to(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("mine")
    with pytest.raises(UsageError, match="other files"):
        made_run().save(tmp_path)
    made_run().save(tmp_path, plots=False, report=False, force=True)
    assert (tmp_path / "summary.json").exists()
