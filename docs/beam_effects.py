"""What shear and rotary inertia change of the beam's prediction, and what `fit` finds of it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from beam_validation import FITTED, KEYS, PAYLOADS, SPECS, BeamRun, predicted
from measured_swing import COMPARED

from viscodesign import fit, load

SWITCHED = {
    "shear": {"effects.shear": "on"},
    "no rotary inertia": {"effects.rotary_inertia": "off"},
}
"""Changes of the model without shear, at the same numbers."""
EFFECTS_HEAD = ("recording", "change", "place of rest", "first swing", "period", "tip, at most")


def effects_rows(runs: Sequence[BeamRun]) -> list[tuple[str, ...]]:
    """One row a load and effect: by how much the quantities grow, and how far the tip moves."""
    rows = []
    for own in runs:
        for words, changes in SWITCHED.items():
            model = own.model.changed(changes)
            other = predicted(model, own.name, own.measured)
            known = own.predicted.time <= COMPARED
            apart = np.hypot(*(other.predicted.tip - own.predicted.tip)[known].T)
            rows.append(
                (f"`{own.name}`", words, f"{1e3 * (other.static - own.static):+.3f} mm",
                 f"{1e3 * (other.predicted.lowest - own.predicted.lowest):+.3f} mm",
                 f"{1e3 * (other.predicted.period - own.predicted.period):+.2f} ms",
                 f"{1e3 * float(apart.max()):.2f} mm")
            )  # fmt: skip
    return rows


FIT_HEAD = ("number", "value", "its 95 % interval", "counts as identified")


def fit_rows(folder: Path) -> tuple[list[tuple[str, ...]], str]:
    """What `fit` finds of the fitted recording, all 4 s of it, and what it says of the model."""
    found = fit(
        load(SPECS / "beam.yaml"),
        f"{folder / FITTED}.csv@loads.payload={PAYLOADS[FITTED]} kg",
        list(KEYS),
        markers=SPECS / "beam_markers.yaml",
        next_experiment=False,
    )
    rows = [
        (f"`{own.key}`", f"{own.value:.4g} {own.unit}",
         f"{own.low:.4g} to {own.high:.4g} {own.unit}" if own.low and own.high else "open",
         "yes" if own.is_identified else "no")
        for own in found.numbers
    ]  # fmt: skip
    worst = found.mismatch
    told = (
        "The model describes the recording to its noise."
        if worst is None
        else "The model does not describe the recording to its noise of "
        f"{1e3 * worst.noise:.2g} mm: the mean square of what is left is {worst.mean_square:.3g} "
        f"times that of the noise."
    )
    return rows, told
