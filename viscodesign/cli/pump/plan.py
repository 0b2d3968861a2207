"""`viscodesign pump plan`: a spec in, its pump's motion and its limits out."""

from __future__ import annotations

from viscodesign.cli.options import Answer, Overrides, ResultFiles, Spec
from viscodesign.cli.specs import read_pumped
from viscodesign.errors import PumpError, RunFailedError

EXAMPLE = """\b
Examples:
  viscodesign pump plan leg.yaml
  viscodesign pump plan leg.yaml --set "pump.max_pressure=140 kPa abs"
  viscodesign pump plan leg.yaml --set pump.home=500 --json"""


def command(
    spec: Spec,
    overrides: Overrides = None,
    *,
    files: ResultFiles,
    answer: Answer,
) -> None:
    """Turn wanted pressures into the pump's motion, and check it against its limits.

    Simulates the spec with its coupled model; checks what limits its kind of pump (torque,
    speed, travel, suction, battery; or range and rate) at each moment; names the smallest
    changes where a limit is exceeded; and simulates what the pump would do instead. Writes
    plan.csv, plan.json and plan.png. Exits with 4 where the plan is infeasible.
    """
    from viscodesign import plan
    from viscodesign.cli.progress import progress
    from viscodesign.cli.run_folders import folder_for
    from viscodesign.cli.texts.plan_text import plan_lines
    from viscodesign.pump.planning.demand_kinds import pump_of
    from viscodesign.pump.report.plan_folder import plan_document, write_plan
    from viscodesign.report.folder import new_folder

    scene = read_pumped(spec, overrides)
    pump_of(scene)
    folder, remark = folder_for(scene, files.output)
    answer.remark(remark)
    with (
        new_folder(folder, force=files.force),
        progress(answer.quiet, "planning", first="planning") as advance,
    ):
        found = plan(scene, progress=advance)
    paths = write_plan(found, folder, **files.writing)
    answer.give(plan_document(found), plan_lines(found, folder, paths), paths)
    if found.status != "complete":
        raise RunFailedError(f"{found.failure}\npartial results are in {folder}")
    if not found.is_feasible:
        names = ", ".join(dict.fromkeys(v.name for v in found.infeasible))
        raise PumpError(
            f"{found.name}: the pump cannot reproduce this profile: {names}\n"
            f"the plan, labelled infeasible, is in {folder}"
        )
