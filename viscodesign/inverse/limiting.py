"""What keeps a design from coming nearer, in words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import traits_of
from viscodesign.inverse.confirmation import Confirmation
from viscodesign.inverse.number_search import NumberDesign
from viscodesign.inverse.search_task import SearchTask

MAX_NAMES = 4


def limiting_reason(task: SearchTask, best: NumberDesign, run: Confirmation | None) -> str:
    """Why a design is not met."""
    parts = list(_distance_words(task, best, run))
    if task.stop.asked:
        parts.append("interrupted: this is the best so far, not confirmed")
        if not task.log.evaluations:
            parts.append("its distances are those of a linear network and a rod of arcs")
    elif task.log.is_cut:
        parts.append(f"ended by its budget of {task.budget_s:g} s; give it a larger one")
    elif best.status == "unfinished":
        parts.append("its evaluations are used up; go on with its spec.yaml as `spec`")
    if best.at_bounds:
        shown = ", ".join(best.at_bounds[:MAX_NAMES])
        more = len(best.at_bounds) - MAX_NAMES
        parts.append(f"at their bounds: {shown}" + (f" and {more} more" if more > 0 else ""))
    elif best.status == "converged" and best.names:
        parts.append("no bound is active: these numbers can do no better, others must be free")
    if run is not None and best.status == "converged" and _is_lost_in_flow(task, run):
        parts.append(
            "without the losses at the ends of tubes and at high Reynolds numbers it would be "
            f"{1e3 * (task.log.quick_m or 0.0):.2g} mm: free network.tube_radius or "
            "fluid.viscosity, or a longer period"
        )
    return "; ".join(parts)


def _is_lost_in_flow(task: SearchTask, run: Confirmation) -> bool:
    """Whether slow flow would follow the path, and the run's flow does not."""
    quick, is_lossy = task.log.quick_m, Trait.FLOW_LOSSES in traits_of(run.effects)
    return quick is not None and quick <= task.tolerance_m and is_lossy


def _distance_words(
    task: SearchTask, best: NumberDesign, run: Confirmation | None
) -> Iterator[str]:
    found = best.distance if run is None else run.distance
    place = task.wanted.points[found.place].tolist()
    if found.rms_m > task.tolerance_m or not found.strays:
        yield (
            f"the tip stays {1e3 * found.rms_m:.3g} mm (rms) from the path, "
            f"{1e3 * found.worst_m:.3g} mm at {_point_words(place)}; "
            f"allowed are {1e3 * task.tolerance_m:.3g} mm"
        )
    if found.strays and found.excess_m is not None and found.excess_at is not None:
        if found.rms_m <= task.tolerance_m:
            yield f"the tip passes the wanted points at {1e3 * found.rms_m:.3g} mm (rms)"
        yield (
            f"between the wanted points the tip strays from the path, up to "
            f"{1e3 * found.excess_m:.3g} mm at {_point_words(found.excess_at)}"
        )


def _point_words(point: Sequence[float]) -> str:
    """A point [m] in millimetres."""
    x, z = (1e3 * own for own in point)
    return f"({x:.3g}, {z:.3g}) mm"
