"""The lines about measured effects."""

from __future__ import annotations

import pytest

from tests.trajectories import ablated_run, made_run, verdict
from viscodesign.cli.texts.ablation_text import ablation_lines, wrongly_neglected_lines
from viscodesign.results.findings import EffectAblation

BUDGET = 0.000545


def row(ablation: EffectAblation, mode: str = "auto") -> str:
    """The line of one effect, words apart by one space."""
    effects = (verdict(ablation.name, ablation.taken, ablation.estimated_m, mode),)
    lines = ablation_lines(ablated_run(effects=effects, proof=(ablation,)))
    return " ".join(next(line for line in lines if line.startswith(f"  {ablation.name}")).split())


@pytest.mark.parametrize("columns", [None, "60", "80", "100"])
def test_every_effect_beside_its_measurement(
    monkeypatch: pytest.MonkeyPatch, columns: str | None
) -> None:
    if columns is not None:
        monkeypatch.setenv("COLUMNS", columns)
        monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    lines = ablation_lines(ablated_run())
    words = " ".join(" ".join(lines).split())
    assert "the budget is the requested error, 0.545 mm" in words
    assert "pressure_distribution included 114 mm 98.7 mm > 1000 % significant" in words
    assert "fluid_mass neglected 0.0043 mm 0.0039 mm 0.716 % within budget" in words
    assert "flow_regime included infinite 97.4 mm > 1000 % significant" in words
    assert "inertia included 0.79 mm 0.81 mm 149 % significant" in words
    if columns is not None:
        assert all(len(line) <= int(columns) for line in lines)


@pytest.mark.parametrize(
    ("measured", "taken", "meaning"),
    [
        (1.01 * BUDGET, True, "101 % significant"),
        (0.99 * BUDGET, True, "99 % minor"),
        (0.99 * BUDGET, False, "99 % within budget"),
        (1.01 * BUDGET, False, "101 % NEGLECTED BUT SIGNIFICANT"),
        (0.0, False, "0 % no change"),
    ],
)
def test_a_measurement_is_compared_with_the_budget(
    measured: float, taken: bool, meaning: str
) -> None:
    assert row(EffectAblation("inertia", taken, measured, measured, 1.0)).endswith(meaning)


@pytest.mark.parametrize(
    ("estimated", "measured", "words"),
    [
        (0.1 * BUDGET, 0.5 * BUDGET, "; underestimated"),
        (0.5 * BUDGET, 0.1 * BUDGET, "; overestimated"),
        (0.5 * BUDGET, 0.0, "; overestimated"),
        (0.2 * BUDGET, 0.5 * BUDGET, ""),
        (0.001 * BUDGET, 0.05 * BUDGET, ""),
    ],
)
def test_a_wrong_estimate_is_named(estimated: float, measured: float, words: str) -> None:
    told = row(EffectAblation("inertia", False, estimated, measured, 1.0))
    assert told.endswith(words or ("within budget", "no change")[measured == 0.0])


def test_what_was_not_measured_says_why() -> None:
    told = row(EffectAblation("inertia", True, 1e-3, None, 0.0, "no equilibrium at t = 0 s"))
    assert told == "inertia included 1 mm unknown unknown not measured: no equilibrium at t = 0 s"
    partly = row(EffectAblation("inertia", True, 1e-3, 1e-3, 0.0, "compared up to t = 1 s"))
    assert partly.endswith("significant; compared up to t = 1 s")


def test_omissions_are_summed_and_only_they() -> None:
    ablations = (
        EffectAblation("a", False, 0.0, 1e-4, 1.0),
        EffectAblation("b", False, 0.0, 2e-4, 1.0),
        EffectAblation("c", False, 0.0, None, 1.0),
        EffectAblation("d", True, 0.0, 5e-4, 1.0),
    )
    text = "\n".join(ablation_lines(ablated_run(proof=ablations)))
    assert "add up to 0.3 mm, 55 % of the budget (2 measured, one at a time)" in text


def test_a_wrongly_neglected_effect_is_a_warning_with_its_remedy() -> None:
    (alarm,) = wrongly_neglected_lines(ablated_run())
    assert alarm == (
        "WARNING: gravity was neglected as set in the spec, but moves the tip by 2.3 mm, 422 % of "
        "the requested error. Include it: --set effects.gravity=on"
    )
    assert alarm in ablation_lines(ablated_run())
    chosen = ablated_run(effects=(verdict("gravity", False, 2e-4),))
    assert "neglected by the estimate" in wrongly_neglected_lines(chosen)[0]


def test_a_run_without_measured_effects_says_so() -> None:
    assert ablation_lines(made_run())[0].startswith("measured effects: none")
    assert wrongly_neglected_lines(made_run()) == []
