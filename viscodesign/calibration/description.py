"""Whether a fitted model describes the recordings at all.

Intervals hold for a model that is right but for noise. One that leaves more than that has numbers
that make up for what it lacks, and these may be off by any factor, however narrow the interval.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.calibration.misfit import Misfit
from viscodesign.calibration.pattern import GroupExcess
from viscodesign.calibration.recorded_columns import KINDS
from viscodesign.effects.allowed_sets import AllowedSets
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.mismatch import Mismatch
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied

DESCRIBED_UP_TO = 2.0
"""Mean square of what is left of any group of channels, over that of its noise, up to which a
model describes it."""
IDENTIFIED_UP_TO = 4.0
"""The same up to which numbers count as identified: what is left is then twice the noise. In trials
with a wrong length, or without effects that act, intervals held the truth up to 4.0; from
6.2 on numbers were off by up to a factor of 26, with half widths of 5 to 9 %
(`benchmarks/results/mismatch_trials.md`)."""


def mismatch_of(
    scene: Scene, misfit: Misfit, values: np.ndarray, groups: Sequence[GroupExcess]
) -> Mismatch | None:
    """What these values leave; None where the model describes every group of channels."""
    worst = max(groups, key=lambda own: own.mean_square)
    if not worst.mean_square > max(DESCRIBED_UP_TO, worst.by_chance):
        return None
    model, noise = misfit.models[worst.run], worst.noise
    apart = misfit.deviations(values)[worst.run][:, worst.channels]
    row, place = worst_sample(apart / noise)
    channel = model.channels[worst.channels[place]]
    effects = frozenset().union(*(own.function.effects for own in misfit.models))
    return Mismatch(
        mean_square=worst.mean_square,
        identified_up_to=IDENTIFIED_UP_TO,
        file=model.recording.file,
        header=channel.header,
        time_s=float(model.recording.time[row]),
        residual=float(apart[row, place]),
        noise=float(noise[place]),
        unit=KINDS[channel.measured].unit,
        effects=tuple(sorted(effects)),
        effects_left_out=tuple(sorted(_forbidden_effects(scene) - effects)),
    )


def worst_sample(residuals: np.ndarray) -> tuple[int, int]:
    """Row and column of residuals (T, c) where most is left, of both neighbours, too.

    A marker that is lost in one row tells nothing of the model. Samples that were left out as gross
    count: where the model is wrong, they may be good ones.
    """
    size = np.abs(np.where(np.isfinite(residuals), residuals, 0.0))
    beside = np.pad(size, ((1, 1), (0, 0)), mode="edge")
    shared = np.median(np.stack([beside[:-2], size, beside[2:]]), axis=0)
    # The one among those that share it which is itself the largest, and was measured.
    row, column = np.unravel_index(int(np.argmax(np.minimum(shared, size))), size.shape)
    return int(row), int(column)


def _forbidden_effects(scene: Scene) -> frozenset[str]:
    """Effects that the scene would have if its spec turned none off."""
    free = copied(scene, {"effects": scene.effects.with_modes({})})
    possible, allowed = (AllowedSets(SceneQuantities(own)).everything for own in (free, scene))
    return frozenset(possible - allowed)
