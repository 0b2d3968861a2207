"""A fit as lines of text: numbers with intervals, and in words what the data do not determine."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.layout import and_more, files_row, seconds, table, wrap
from viscodesign.results.channels import PICTURE_UNITS
from viscodesign.results.fit_result import Experiment, Fit, FittedNumber, FittedRun
from viscodesign.results.sweep_table import value_words

MAX_FIT_ROWS = 40


def fit_lines(found: Fit, folder: Path, files: Sequence[Path]) -> list[str]:
    """Numbers, what cannot be told, recordings, files."""
    known = sum(own.is_identified for own in found.numbers)
    head = f"{found.name}: {known} of {len(found.numbers)} numbers identified"
    rows = [_number_row(own) for own in found.numbers[:MAX_FIT_ROWS]]
    return [
        head,
        *(line for text in mismatch_texts(found) for line in wrap(text, "  ", "    ")),
        *table(rows),
        *and_more(len(found.numbers), MAX_FIT_ROWS, "fit.json"),
        *(line for text in undetermined(found) for line in wrap(text, "  ", "    ")),
        "",
        *table(
            [
                *(row for run in found.runs for row in _run_rows(run)),
                *_left_out(found),
                *(("warning", text) for text in found.warnings),
                *_next(found.next_experiment),
                ("what is left", f"{found.chi2_per_dof:.3g} times its noise (mean squares)"),
                ("mesh", _mesh(found)),
                ("effort", f"{found.evaluations} solutions, {seconds(found.wall_s)}"),
                files_row(folder, files),
            ]
        ),
    ]


def mismatch_texts(found: Fit) -> Iterator[str]:
    """Sentences on a model that leaves more than noise, and what to try."""
    own = found.mismatch
    if own is None:
        return
    unit, factor = PICTURE_UNITS.get(own.unit, (own.unit, 1.0))
    yield (
        f"THE MODEL DOES NOT DESCRIBE THE RECORDING: what it leaves of the worst channels is "
        f"{own.mean_square:.3g} times their noise (mean squares)."
    )
    yield (
        f"Worst: {own.header} of {own.file} at {own.time_s:.4g} s, measured - fitted "
        f"{factor * own.residual:.3g} {unit}; its noise is {factor * own.noise:.2g} {unit}."
    )
    yield f"Effects included: {', '.join(own.effects)}."
    if own.effects_left_out:
        yield f"Left out by the spec: {', '.join(own.effects_left_out)}."
    yield (
        "Try: effects on that the spec leaves out, or off that the device does not have (--set "
        "effects.NAME=on or off); then check its lengths, radii, loads and input, the order of the "
        "markers, and units in the header."
    )
    if own.leaves_numbers_unknown:
        yield (
            f"No number counts as identified beyond {own.identified_up_to:g} times: they make up "
            "for what the model lacks, and may be off by more than their intervals."
        )


def _number_row(own: FittedNumber) -> tuple[str, str, str, str]:
    half = own.half_width
    if half is not None:
        width = f"± {_percent(half)}"
        words = f"95 %: {own.low:.5g} to {own.high:.5g}"
    elif own.low is None and own.high is None:
        width, words = "", "95 %: anything"
    elif own.low is None:
        width, words = "", f"95 %: below {own.high:.3g}"
    else:
        width, words = "", f"95 %: above {own.low:.3g}"
    mark = "" if own.is_identified else "; NOT IDENTIFIED"
    mark += f", at its {own.edge} search bound" if own.edge else ""
    return own.key, value_words(own.value, own.unit), width, f"{words}; was {own.start:.5g}{mark}"


def _percent(share: float) -> str:
    return f"{100 * share:.2g} %" if share < 1.0 else f"{100 * share:.0f} %"


def undetermined(found: Fit) -> Iterator[str]:
    """Sentences on what the data do not determine."""
    in_products = set()
    for product in found.products:
        keys = [key for key, _ in product.powers]
        in_products |= set(keys)
        half = (product.high - product.low) / 2 / product.value
        yield (
            f"{_listed(keys)} cannot be told apart: the data determine "
            f"{product.formula} = {product.value:.5g} (SI, ± {_percent(half)}), "
            "and hardly anything of its factors alone."
        )
    if found.status == "mismatch":
        return  # What data determine is said of a model that describes them.
    alone = [
        n for n in found.numbers if not n.is_identified and not n.edge and n.key not in in_products
    ]
    if unknown := [n.key for n in alone if n.half_width is None]:
        yield f"{_listed(unknown)}: not known by these data; kept near the spec's values."
    if hardly := [f"{n.key} (± {_percent(n.half_width)})" for n in alone if n.half_width]:
        yield f"Hardly known by these data: {_listed(hardly)}."


def _listed(words: Sequence[str]) -> str:
    return " and ".join([", ".join(words[:-1]), words[-1]]) if len(words) > 1 else words[0]


def _run_rows(run: FittedRun) -> Iterator[tuple[str, str]]:
    name = " ".join([run.file, *run.overrides])
    left = [f"{run.missing} missing"] if run.missing else []
    left += [f"{run.gross} grossly wrong and left out"] if run.gross else []
    counts = ", ".join([f"{int(run.kept.sum())} samples", *left])
    clock = ""
    if run.clock_offset_s or run.clock_deviation_s is not None:
        spread = f" ± {1e3 * 2 * run.clock_deviation_s:.2g}" if run.clock_deviation_s else ""
        clock = f"; its clock is {1e3 * run.clock_offset_s:.4g}{spread} ms late"
    yield "recording", f"{name}: {counts}{clock}"
    for words in run.driven_by:
        yield "", words


def _left_out(found: Fit) -> Iterator[tuple[str, str]]:
    for key, why in found.left_out:
        yield "not fitted", f"{key}: {why}"


def _next(experiment: Experiment | None) -> Iterator[tuple[str, str]]:
    if experiment is not None:
        yield "next", experiment.words
        widths = (f"{key} ± {_percent(own)}" for key, own in experiment.half_widths.items())
        yield "", f"then expected: {', '.join(widths)}"


def _mesh(found: Fit) -> str:
    edges, bias = found.mesh["edges_per_section"], found.mesh["bias_sd"]
    words = f"{edges} edges a section"
    return f"{words}; a finer one would move no number by more than {bias:.2g} sd"
