"""Specs of several actuators in the commands that take them beside specs of one."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from viscodesign.cli.specs import SpecResult
from viscodesign.errors import InterruptedRunError, RunFailedError, ViscodesignError

if TYPE_CHECKING:
    from viscodesign.cli.simulate import RunOptions
    from viscodesign.results.several_runs import SeveralRuns
    from viscodesign.scene.several_scene import SeveralScene


def checked_several(scene: SeveralScene, lines: bool) -> SpecResult:
    """Every actuator's check; ``lines``: whether people read it."""
    from viscodesign.checks.check_several import check_several
    from viscodesign.cli.check import check_lines
    from viscodesign.studies.stated_uncertainty import stated_deviations

    found = check_several(scene)
    for own in scene.scenes.values():
        stated_deviations(own)
    document = {
        "name": scene.name,
        "actuators": {name: own.document() for name, own in found.items()},
    }
    distinct = {id(own): own for own in found.values()}.values()
    told = [["", *check_lines(own)] for own in distinct] if lines else []
    return SpecResult(document, [line for own in told for line in own][1:])


def simulated_several(scene: SeveralScene, folder: Path, options: RunOptions) -> SpecResult:
    """Simulate several actuators and write their files."""
    from viscodesign.cli.progress import progress
    from viscodesign.report.folder import new_folder
    from viscodesign.report.several_folder import write_several
    from viscodesign.studies.simulate_several import simulate_several

    with new_folder(folder, force=options.files.force), progress(options.answer.quiet) as advance:
        found = simulate_several(scene, **options.solving, progress=advance, scratch=folder)
    files = write_several(found, folder, **options.writing)
    document = {**found.summary(), "files": [str(file) for file in files]}
    lines = [] if options.answer.json else _lines(found, folder)
    return SpecResult(document, lines, _incomplete(found, folder))


def _lines(found: SeveralRuns, folder: Path) -> list[str]:
    from viscodesign.cli.texts.run_text import summary_lines

    lines = []
    for name, run in found.runs.items():
        source = ", ".join(found.sources[name].values()) or "tubes"
        if (other := found.equal_to.get(name)) is not None:
            lines += [f"{name}, fed by {source}: equal to {other}, and solved with it", ""]
            continue
        own = folder / name
        files = sorted(own.iterdir()) if own.is_dir() else []
        lines += [f"{name}, fed by {source}", *summary_lines(run, own, files), ""]
    for shared in found.coupled:
        names = " and ".join(shared.actuators)
        lines.append(
            f"{names} share fluid: one system, whose error, effects and balances these are"
        )
    for source, told in found.supplies().items():
        lines.append(
            f"{source} feeds {', '.join(told['feeds'])}: {1e6 * told['volume_swing_m3']:.3g} mL of "
            f"fluid at ambient density, up to {1e6 * told['largest_flow_m3_s']:.3g} mL/s"
        )
    return [*lines, f"{folder}: a folder for each, and trajectory.csv of all"]


def _incomplete(found: SeveralRuns, folder: Path) -> ViscodesignError | None:
    kept = f"partial results are in {folder}"
    if found.status == "interrupted":
        left = f"; not begun: {', '.join(found.interrupted)}" if found.interrupted else ""
        return InterruptedRunError(f"{found.name}: the run is interrupted{left}\n{kept}")
    if found.status == "failed":
        return RunFailedError(f"{found.failure}\n{kept}")
    return None
