"""A simulation is a function of its arguments: nothing that ran before it, or beside it, matters."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.scenes import ROOT, leg
from viscodesign import Scene, Trajectory, simulate

SHORT = ("run.duration=1.5 s", "run.output_interval=0.1 s", "bellows.count=6")
SCENES: tuple[tuple[str, ...], ...] = (
    # Equal structures with other numbers, which share formulas:
    *((*SHORT, f"network.tube_length={length} mm") for length in (20, 30, 40, 50)),
    # Other effects, other solvers, other graphs:
    (*SHORT, "effects={others: on, fluid_inertance: off}"),
    (*SHORT, "effects={inertia: on, others: off}", "actuator.damping_time=0 s"),
    (*SHORT, "effects={gravity: on, others: off}", "loads.gravity=on"),
    (
        *SHORT,
        "effects={pressure_distribution: on, others: off}",
        "network.layout=crossed",
        "bellows.count=8",
    ),
)
NUMBERS = range(len(SCENES))


def scene(number: int) -> Scene:
    return leg(*SCENES[number])


def bits(found: Trajectory) -> str:
    """A digest of every number of a motion, and of the verdicts and warnings beside it."""
    told = [repr((v.name, v.taken, v.contribution_m)) for v in found.effects]
    told += [repr((w.code, w.message, w.time_s)) for w in found.warnings]
    told += [found.status, repr(found.accuracy)]
    arrays = (found.time, found.tip, found.pressure, found.volume, found.flow, found.shape)
    digest = hashlib.sha256("\n".join(told).encode())
    for array in arrays:
        digest.update(array.tobytes())
    return digest.hexdigest()


def solved(number: int) -> str:
    return bits(simulate(scene(number), verify=False))


FRESH = """
import os, sys
from tests.contract.test_same_bits import NUMBERS, solved

for number in NUMBERS:
    if not (child := os.fork()):
        print(solved(number), flush=True)
        os._exit(0)
    if os.waitpid(child, 0)[1]:
        sys.exit(f"scene {number} has no digest")
"""
"""Imports everything once; then every scene has a process of its own that has simulated nothing."""


@pytest.fixture(scope="module")
def fresh() -> list[str]:
    """Of every scene, its digest from a process that has simulated nothing else."""
    done = subprocess.run(
        [sys.executable, "-c", FRESH],
        cwd=ROOT,
        check=True,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    digests = done.stdout.split()
    assert len(digests) == len(SCENES)
    return digests


@settings(max_examples=12)
@given(order=st.lists(st.sampled_from(NUMBERS), min_size=2, max_size=8), threads=st.integers(1, 8))
def test_scenes_in_any_order_and_beside_each_other_give_the_bits_of_a_fresh_process(
    fresh: list[str], order: list[int], threads: int
) -> None:
    if threads == 1:
        found = [solved(number) for number in order]
    else:
        with ThreadPoolExecutor(threads) as pool:
            found = list(pool.map(solved, order))
    assert found == [fresh[number] for number in order]


def test_equal_structures_in_three_threads_do_not_share_an_integrator(fresh: list[str]) -> None:
    with ThreadPoolExecutor(3) as pool:
        assert list(pool.map(solved, [0, 1, 2, 3, 2, 1])) == [fresh[k] for k in (0, 1, 2, 3, 2, 1)]


def test_a_digest_is_not_blind() -> None:
    assert solved(0) != solved(1)


def test_classify_warns_of_what_check_warns_of() -> None:
    from viscodesign import check, classify

    curve = (
        "bellows.curve={rows: ["
        + ", ".join(
            json.dumps([p, 3.413e-9 * p, 5.7e-6 * p, 2.6e-8 * p]) for p in (-90e3, 0.0, 90e3)
        )
        + "]}"
    )
    sucked = leg(
        "effects={collapse: off, material_curve: on}",
        "input={kind: sine, amplitude: 60 kPa, frequency: 0.5 Hz}",
        curve,
        config="leg_4_air",
    )
    told = {w.code for w in check(sucked).warnings}
    assert {w.code for w in classify(sucked).warnings} == told - {"needed_effect_off"}
