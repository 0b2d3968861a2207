"""What the estimated error leaves in doubt although the tip is as accurate as requested."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Accuracy, Trajectory
from viscodesign.scene.whole_spec import MIN_ACCURACY
from viscodesign.simulation.error_control import ERROR_CONTROL, Verifier
from viscodesign.storage.disk_arrays import blocks

FLOW_ERROR_WARNED = 0.02
"""Estimated error of a flow, of the largest in the network, from which a warning is given."""
ROUND_OFF = 1e-12
"""Part of the length by which the tip of an actuator at rest may move."""
RESOLVED_SHARE = 0.1
"""Error that is recommended, as a share of the motion."""


def doubts(
    found: Trajectory, accuracy: Accuracy, verifier: Verifier, *, is_driven: bool
) -> tuple[Notice, ...]:
    """A warning of a motion that is not resolved at all, or of flows that hardly are.

    ``is_driven``: whether any input changes.
    """
    unresolved = _unresolved_motion(found, accuracy, is_driven)
    return (unresolved,) if unresolved else tuple(uncertain_flows(found, verifier))


def _unresolved_motion(found: Trajectory, accuracy: Accuracy, is_driven: bool) -> Notice | None:
    """A warning where the stated error exceeds all that the tip does."""
    error = accuracy.estimated_tip_error_m
    size = _motion_size(found, is_driven) if error is not None and len(found.tip) else None
    if error is None or size is None or error <= size:
        return None
    enough = 100 * RESOLVED_SHARE * size / found.length
    return Notice(
        "unresolved_motion",
        f"the stated error of {1e3 * error:.3g} mm exceeds the whole motion of the tip, "
        f"{1e3 * size:.3g} mm: neither the tip nor pressures and flows are resolved; "
        + (
            f"set `accuracy` to {enough:.2g} % or less"
            if enough >= 100 * MIN_ACCURACY
            else "the input is too small for any accuracy"
        ),
        "tip",
    )


def _motion_size(found: Trajectory, is_driven: bool) -> float | None:
    """Largest distance of the tip from its start, or where it stands still from that of the
    straight actuator [m]; None where nothing acts on it.
    """
    least = ROUND_OFF * found.length
    moved = _farthest(found, found.tips(slice(1)))
    if moved > least or is_driven:
        return moved
    bent = _farthest(found, np.array([0.0, found.length]))
    return bent if bent > least else None


def _farthest(found: Trajectory, place: np.ndarray) -> float:
    """Largest distance of a tip from a place (2,), or from its own (1, rods, 2) [m]."""
    return max(
        float(np.max(np.hypot(*(found.tips(rows) - place).T)))
        for rows in blocks(len(found.tip), found.tip)
    )


def uncertain_flows(found: Trajectory, verifier: Verifier) -> Iterator[Notice]:
    """A warning where smaller steps change the flows, even if the tip stays."""
    apart = verifier.flows_apart
    if apart is None or ERROR_CONTROL.time_share * apart.share <= FLOW_ERROR_WARNED:
        return
    if apart.row >= len(found.time):
        return  # a finer solution ended before, and says so itself
    tube = found.tubes[apart.tube]
    yield Notice(
        "uncertain_flows",
        f"the flow in {tube} has an estimated error of "
        f"{100 * ERROR_CONTROL.time_share * apart.share:.2g} % of the peak flow; tighten "
        "`accuracy` if you use flows",
        tube,
        float(found.time[apart.row]),
    )
