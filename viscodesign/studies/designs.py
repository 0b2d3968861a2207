"""Rows of designs: every combination of values, or a Latin hypercube between bounds."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from viscodesign.errors import SpecError
from viscodesign.studies.key_values import refused
from viscodesign.studies.swept_keys import SweptKey

MAX_DESIGNS = 1_000_000
"""Designs of one table."""
Design = tuple[Any, ...]
"""One value per key: a number in SI, or a setting as it was given."""


def grid(keys: Sequence[SweptKey]) -> list[Design]:
    """Every combination of the keys' values; the last key varies fastest."""
    values = [key.values.grid() for key in keys]
    count = math.prod(map(len, values))
    if count > MAX_DESIGNS:
        sizes = " * ".join(str(len(own)) for own in values)
        raise SpecError.plain(
            f"{sizes} = {count:,} combinations are more than {MAX_DESIGNS:,}; take fewer values, "
            "or draw designs with --sample N"
        )
    return list(itertools.product(*values))


def latin_hypercube(keys: Sequence[SweptKey], count: int, seed: int) -> list[Design]:
    """Designs drawn so that every key has one value in each of ``count`` equal parts of its range.

    A list of values is drawn in equal parts. The same seed draws the same designs.
    """
    if not 1 <= count <= MAX_DESIGNS:
        raise SpecError.plain(f"sample: must be from 1 to {MAX_DESIGNS:,} designs; got {count}")
    for key in keys:
        if key.values.count is not None:
            message = f"a sample has no grid: write {key.name}=low..high"
            raise refused(key.name, f"{message} without :{key.values.count}")
    from scipy.stats import qmc

    sampler = qmc.LatinHypercube(len(keys), seed=np.random.default_rng(seed))
    shares = sampler.random(count)
    columns = [key.values.at(shares[:, k]) for k, key in enumerate(keys)]
    return list(zip(*columns, strict=True))
