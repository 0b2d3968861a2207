"""Hold predictions against recordings: python docs/make_validation.py FOLDER

Fills the blocks of `docs/validation.md` and draws its picture. FOLDER has the recordings, in
`beam/` and `arm/`, as CSV; without them the page stays as it is, but for what needs none.
"""

from __future__ import annotations

import sys
from pathlib import Path

DOCS = Path(__file__).parent
sys.path[:0] = [str(DOCS.parent), str(DOCS)]

from arm_validation import (  # noqa: E402
    ARM_FITTED,
    ARM_HEAD,
    CURVE_FROM,
    MOTION_HEAD,
    PRESSURES,
    SEGMENT_PRESSURES,
    arm_rest_rows,
    fitted_scenes,
    motion_rows,
    recordings,
)
from beam_effects import EFFECTS_HEAD, FIT_HEAD, effects_rows, fit_rows  # noqa: E402
from beam_picture import SHOWN, draw_beam  # noqa: E402
from beam_validation import (  # noqa: E402
    BEAM_HEAD,
    CREEP_HEAD,
    FITTED,
    PAYLOADS,
    REST_HEAD,
    BeamRun,
    FittedModel,
    beam_rows,
    creep_rows,
    fitted_models,
    predicted,
    recorded_swings,
    rest_rows,
)
from make_pages import blocks_of, fill, table  # noqa: E402
from paper_validation import (  # noqa: E402
    ASSUMED_HEAD,
    EFFECT_HEAD,
    PAPER_HEAD,
    assumption_rows,
    effect_rows,
    layout_runs,
    paper_rows,
)

PAGE = DOCS / "validation.md"
TARGETS = {"place of rest": 0.05, "first swing": 0.1, "period": 0.05}


def main(arguments: list[str]) -> None:
    """Fill what can be filled."""
    blocks = {name: text for _, name, text in blocks_of(PAGE.read_text(encoding="utf-8"))}
    runs = layout_runs()
    blocks["paper"] = table(PAPER_HEAD, paper_rows(runs))
    blocks["paper_effects"] = table(EFFECT_HEAD, effect_rows(runs))
    blocks["paper_assumed"] = table(ASSUMED_HEAD, assumption_rows(runs))
    folder = Path(arguments[0]) if arguments else None
    if folder is not None and not (missing := missing_files(folder)):
        blocks |= beam_blocks(folder / "beam") | arm_block(folder / "arm")
    else:
        told = "no folder of recordings is given" if folder is None else f"no {missing[0]}"
        print(f"{told}: the blocks of the beam and the arm stay as they are", file=sys.stderr)
    fill(PAGE, blocks)


def missing_files(folder: Path) -> list[Path]:
    """Recordings that are not there."""
    files = [folder / "beam" / f"{name}.csv" for name in PAYLOADS]
    files += [folder / "arm" / f"step_{own}mbar.csv" for own in PRESSURES]
    files += [folder / "arm" / f"segment_{own}mbar.csv" for own in SEGMENT_PRESSURES]
    return [file for file in files if not file.exists()]


def beam_blocks(folder: Path) -> dict[str, str]:
    """The beam's table, fitted numbers and targets; draws the picture."""
    measured = recorded_swings(folder)
    models = fitted_models(measured)
    runs = [predicted(model, name, measured[name]) for name in PAYLOADS for model in models]
    plain = [own for own in runs if own.model is models[0]]
    draw_beam(plain, DOCS / "validation" / "beam.png")
    numbers, told = fit_rows(folder)
    return {
        "beam_fit": f"{table(FIT_HEAD, numbers)}\n\n{told}",
        "beam_effects": table(
            EFFECTS_HEAD, effects_rows([own for own in plain if own.name in SHOWN])
        ),
        "beam_numbers": table(NUMBERS_HEAD, [_numbers(model) for model in models]),
        "beam": table(BEAM_HEAD, beam_rows(runs)),
        "beam_rest": table(REST_HEAD, rest_rows(measured)),
        "beam_creep": table(CREEP_HEAD, creep_rows(measured)),
        "beam_targets": table(TARGETS_HEAD, [_targets(model, runs) for model in models]),
    }


NUMBERS_HEAD = ("model", "modulus", "damping time")
TARGETS_HEAD = (
    "model", "place of rest within 5 %", "first swing within 10 %", "period within 5 %",
    "band holds the place of rest",
)  # fmt: skip


def _numbers(model: FittedModel) -> tuple[str, ...]:
    return (model.label, f"{1e-3 * model.modulus:.1f} kPa", f"{1e3 * model.damping_time:.2f} ms")


def _targets(model: FittedModel, runs: list[BeamRun]) -> tuple[str, ...]:
    """How many recordings that were not fitted meet each target."""
    own = [run for run in runs if run.model is model and run.name != FITTED]
    pairs = {
        "place of rest": [(run.measured.static, run.static) for run in own],
        "first swing": [(run.measured.lowest, run.predicted.lowest) for run in own],
        "period": [(run.measured.period, run.predicted.period) for run in own],
    }
    met = [
        sum(abs(found / seen - 1) <= within for seen, found in pairs[what])
        for what, within in TARGETS.items()
    ]
    held = sum(run.holds for run in own)
    return (model.label, *(f"{count} of {len(own)}" for count in (*met, held)))


def arm_block(folder: Path) -> dict[str, str]:
    """The arm's tables: by a linear law, by a measured curve, and on the way."""
    measured = recordings(folder)
    steps = [own for own in measured if own.name.startswith("step")]
    angle, linear, curved = fitted_scenes(steps)
    rows = arm_rest_rows(measured, linear, ARM_FITTED, "fitted")
    return {
        "arm": f"Fitted: {angle:.3g} rad per p/E.\n\n{table(ARM_HEAD, rows)}",
        "arm_curve": table(ARM_HEAD, arm_rest_rows(measured, curved, CURVE_FROM, "in the curve")),
        "arm_motion": table(MOTION_HEAD, motion_rows(measured, curved)),
    }


if __name__ == "__main__":
    main(sys.argv[1:])
