"""A gait as lines of text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.check_text import notice_lines
from viscodesign.cli.texts.layout import files_row, number, seconds, table
from viscodesign.results.walk_study import WalkStudy


def walk_lines(study: WalkStudy, folder: Path, files: Sequence[Path]) -> list[str]:
    """Advance, step, pumps, feet, balances, warnings, files."""
    motion = study.motion
    warnings = notice_lines(study.warnings)
    return [
        f"{study.name}: {len(study.advances_by_cycle_m)} cycles of {number(motion.period, 's')}",
        *table(list(_facts(study))),
        "",
        *table(list(_feet(study))),
        "",
        *(["warnings", *warnings, ""] if warnings else []),
        *table([files_row(folder, files)]),
    ]


def _facts(study: WalkStudy) -> Iterator[tuple[str, str]]:
    if not study.refusal:
        advance, speed = study.advance_per_cycle_m, study.speed_body_lengths_per_s
        way = "forward" if advance > 0 else "backward"
        yield "advance", f"{number(1e3 * abs(advance), 'mm')} a cycle, {way}"
        yield "speed", f"{number(speed)} body lengths a second"
    change, cycle = (number(1e2 * v, "%") for v in (study.step_halving_change, study.cycle_change))
    step = number(1e3 * study.steps_s[-1], "ms")
    yield "step", f"{step}; halving it moved the advance by {change}, the last cycle by {cycle}"
    body, feet = (number(1e3 * v, "mm") for v in (study.body_path_error_m, study.feet_path_error_m))
    yield "error", f"body's path within {body}, feet's within {feet}, by halving the step"
    for name, pump in study.pumps.items():
        last, whole = (number(1e6 * v, "mL") for v in (pump.volume_m3, pump.run_volume_m3))
        asked = (
            f"{last} in the last cycle, {whole} in the run; {number(1e6 * pump.flow_m3_s, 'mL/s')}"
        )
        told = {True: "; the pump can", False: "; more than the pump can", None: ""}
        yield f"pump {name}", asked + told[pump.is_feasible]
    found = study.invariants
    yield (
        "contact",
        f"penetration {number(1e6 * found.worst_penetration_m, 'um')}, "
        f"friction's work {number(1e3 * found.friction_work_j, 'mJ')}",
    )
    yield (
        "balances",
        f"forces {number(found.force_imbalance_rel)} of the weight, "
        f"gas {number(found.gas_mass_imbalance_rel)} of the contents, "
        f"energy {number(found.energy_imbalance_rel)} of the work",
    )
    yield "energy", _energy(study)
    speedup = study.motion.time[-1] / study.solve_cpu_s
    words = f"the last solution {number(speedup)} times as fast as the robot (processor time)"
    yield "time", f"{seconds(study.total_s)}; {words}"


def _energy(study: WalkStudy) -> str:
    """What the last cycle takes and where it goes."""
    energy = study.energy
    work = [f"{name} {number(1e3 * own, 'mJ')}" for name, own in energy.cycle_work_j.items()]
    lost = [f"{name} {number(1e3 * own, 'mJ')}" for name, own in energy.cycle_loss_j.items()]
    return f"in the last cycle, work of {', '.join(work)}; lost in {', '.join(lost)}"


def _feet(study: WalkStudy) -> Iterator[tuple[str, ...]]:
    yield ("foot, last cycle", "lift", "on the ground", "sliding", "normal force", "friction")
    for name, foot in study.feet.items():
        yield (
            name,
            number(1e3 * foot.lift_m, "mm"),
            number(1e2 * foot.stance_share, "%"),
            number(1e2 * foot.slide_share, "%"),
            f"up to {number(foot.peak_normal_n, 'N')}",
            f"up to {number(foot.peak_friction_n, 'N')}",
        )
