"""How a run ended, how accurate it is, and what to do where it fell short."""

from __future__ import annotations

from viscodesign.effects.select import NUMBERS
from viscodesign.postprocess.terminations import broken_balance
from viscodesign.results.trajectory import Accuracy, Status
from viscodesign.simulation.error_control import ERROR_CONTROL, ErrorParts, Verifier
from viscodesign.simulation.judged_effects import JUDGING
from viscodesign.simulation.solve_once import Run

NOT_VERIFIED = "not verified"
METHOD = (
    f"time: {ERROR_CONTROL.time_share:g} of the last change of the tip when the tolerance was "
    "divided by ten; space: its last change when the edge length was halved; neglected effects: "
)
ESTIMATED = (
    f"{NUMBERS.stated_per_estimated:g} times the difference between two estimates, with and "
    "without them"
)
TOGETHER = (
    f"all parts together: {JUDGING.stated_per_measured:g} times the distance to a solution with "
    f"all effects, {JUDGING.coarser_tolerance:g} times the tolerance and half the edges (up to "
    "twice that where their number is odd), and what neglected effects do by the estimates; at "
    f"least {JUDGING.stated_per_estimated:g} times the latter"
)
APART = (
    f"all parts together: {JUDGING.stated_per_told_apart:g} times the difference between two "
    "solutions, with and without the neglected effects, and the last change of the tip when the "
    f"tolerance was divided by {JUDGING.coarser_tolerance:g} and the edge length halved"
)
MEASURED = (
    f"{JUDGING.stated_per_told_apart:g} times the difference between two solutions, with and "
    "without them, or that and what the latter lacks of the run, if that is more"
)


def outcome_of(
    verifier: Verifier, run: Run, accuracy: Accuracy, verify: bool
) -> tuple[Status, str | None]:
    """How the run ended, and the message where it ended badly."""
    if run.solution.interrupted:
        if not len(run.motion.time):
            raise KeyboardInterrupt  # before the first output: there is nothing to keep
        return "interrupted", f"interrupted at t = {run.motion.time[-1]:.6g} s"
    if verifier.interrupted:
        return "interrupted", (
            "interrupted while verifying: the run finished, but its error could not be estimated"
        )
    if run.motion.failure is not None:
        return "failed", str(run.motion.failure)
    reached = float(run.motion.time[-1]) if run.motion.time.size else 0.0
    if broken := broken_balance(run.motion.invariants, reached):
        return "failed", str(broken)
    error = accuracy.estimated_tip_error_m
    if verify and error is None:
        return "failed", (
            f"the run finished, but its error could not be estimated: {verifier.stalled}"
        )
    if error is not None and error > accuracy.requested_m:
        return "failed", _too_inaccurate(verifier, accuracy, error)
    return "complete", None


def _too_inaccurate(verifier: Verifier, accuracy: Accuracy, error: float) -> str:
    """The message of a run whose error remained above the requested accuracy."""
    parts = (
        ("time", accuracy.time_m, "check the last shapes for an instability"),
        ("space", accuracy.space_m, "check the last shapes for a kink"),
        ("neglected effects", accuracy.omitted_m, "--set effects.others=on includes them all"),
    )
    _, _, remedy = max(parts, key=lambda part: part[1] or 0.0)
    breakdown = ", ".join(f"{name} {1e3 * (size or 0.0):.3g} mm" for name, size, _ in parts)
    if verifier.stalled:
        breakdown += f"; {verifier.stalled}"
    return (
        f"requested accuracy of {1e3 * accuracy.requested_m:.3g} mm at the tip not reached: "
        f"estimated error {1e3 * error:.3g} mm after {verifier.solutions} solutions "
        f"({breakdown}). Relax `accuracy`, or {remedy}."
    )


def accuracy_of(verifier: Verifier, parts: ErrorParts | None, verify: bool) -> Accuracy:
    """What is known of the error of the tip."""
    if parts is None:
        ended = "" if not verify else ": the solution or its refinement did not reach the end"
        return Accuracy(
            verifier.requested_m, None, NOT_VERIFIED + ended, omitted_m=verifier.neglected_m
        )
    return Accuracy(
        verifier.requested_m,
        parts.total_m,
        _method(verifier, parts),
        time_m=parts.time_m,
        space_m=parts.space_m,
        omitted_m=parts.neglected_m,
    )


def _method(verifier: Verifier, parts: ErrorParts) -> str:
    """How the error was found."""
    if parts.time_m is None:
        return APART if verifier.measured_neglected else TOGETHER
    return METHOD + (MEASURED if verifier.measured_neglected else ESTIMATED)
