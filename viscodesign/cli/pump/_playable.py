"""What the pump cannot do is not played, unless as far as it goes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.errors import PumpError

if TYPE_CHECKING:
    from viscodesign.pump.planning.result import PumpPlan

Achievable = Annotated[
    bool,
    typer.Option("--achievable", help="Play what the pump can do where it cannot do all of it."),
]


def refuse_unplayable(plan: PumpPlan, achievable: bool) -> None:
    """Raise `PumpError` with every reason; ``achievable``: the user takes less than was wanted."""
    if plan.status != "complete":
        raise PumpError(f"the plan is {plan.status}: {plan.failure}")
    if plan.is_feasible or achievable:
        return
    bad = [f"  {v.message}" for v in plan.verdicts if v.severity == "infeasible"]
    remedy = "`pump plan` says what to change; --achievable plays what the pump can do"
    raise PumpError("\n".join(["the pump cannot play this:", *bad, remedy]))
