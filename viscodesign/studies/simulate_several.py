"""Several actuators side by side: each distinct one is solved once, what shares fluid as one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from viscodesign._version import __version__
from viscodesign.errors import SolveError, UsageError, described
from viscodesign.results.coupled_motion import CoupledMotion
from viscodesign.results.several_runs import SeveralRuns
from viscodesign.results.trajectory import RunInterruptedError, Trajectory
from viscodesign.scene.fluid_links import LinkedGroup
from viscodesign.scene.joined_scene import JoinedScene
from viscodesign.scene.reading.write import part_yaml, resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.scene.several_scene import SeveralScene
from viscodesign.scene.spec_part import copied
from viscodesign.simulation.member_runs import coupled_motion, member_runs, with_section_names
from viscodesign.simulation.solve_once import Progress
from viscodesign.studies.simulate import simulate
from viscodesign.studies.stated_uncertainty import stated_deviations


def simulate_several(
    scene: SeveralScene,
    *,
    verify: bool = True,
    prove: bool = False,
    uncertainty: bool = True,
    progress: Progress | None = None,
    scratch: Path | None = None,
) -> SeveralRuns:
    """Compute the motions of several actuators, each as `simulate` does.

    Those that share inputs of given pressure alone change nothing in each other: equal ones are
    solved once. Those that share fluid are solved as one system, with one set of effects and one
    error. Arguments as of `simulate`. An actuator whose solution does not even begin is among
    ``failures``, and the others go on; Ctrl-C leaves out what is not done.

    Raises `SpecError` where an actuator has no bounded solution, and before anything is solved for
    what `uncertainty` cannot say.
    """
    if not isinstance(scene, SeveralScene):
        given = described(scene)
        raise UsageError(
            f"expected several actuators, such as load_several('legs.yaml') returns; got {given}"
        )
    equal_to = equal_actuators(scene)
    alone = [name for name in scene.scenes if name not in equal_to]
    groups = zip(scene.groups, scene.joined, strict=True)
    parts: list[tuple[tuple[str, ...], Scene, LinkedGroup | None]] = [
        *(((name,), scene.scenes[name], None) for name in alone),
        *((group.names, joined, group) for group, joined in groups),
    ]
    for _, own, _ in parts if uncertainty and scene.uncertainty is not None else ():
        stated_deviations(own)
    runs: dict[str, Trajectory] = {}
    failures: dict[str, str] = {}
    coupled: list[CoupledMotion] = []
    stopped = False
    for k, (names, own, group) in enumerate(parts):
        run: Trajectory | None
        try:
            run = simulate(
                own,
                verify=verify,
                prove=prove,
                uncertainty=uncertainty,
                progress=_part(progress, k, len(parts)),
                scratch=scratch,
            )
        except SolveError as error:
            failures |= dict.fromkeys(names, with_section_names(own, str(error)))
            continue
        except RunInterruptedError as error:
            stopped, run = True, error.trajectory
        if run is not None and group is not None:
            assert isinstance(own, JoinedScene)
            runs |= member_runs(scene, own, run)
            coupled.append(coupled_motion(group, own, run))
        elif run is not None:
            runs[names[0]] = run
        if stopped:
            break
    for name, other in equal_to.items():
        if other in runs:
            runs[name] = _renamed(runs[other], scene.scenes[name])
        elif other in failures:
            failures[name] = failures[other]
    left = tuple(n for n in scene.actuators if stopped and n not in runs and n not in failures)
    return SeveralRuns(
        name=scene.name,
        runs={name: runs[name] for name in scene.actuators if name in runs},
        equal_to={name: other for name, other in equal_to.items() if name in runs},
        sources={name: scene.sources_of(name) for name in scene.actuators},
        failures=failures,
        interrupted=left,
        coupled=tuple(coupled),
        spec_text=part_yaml(scene),
        spec_sha256=scene.source.sha256,
        version=__version__,
    )


def equal_actuators(scene: SeveralScene) -> Mapping[str, str]:
    """Actuators that equal an earlier one in all but their names, and which."""
    first: dict[bytes, str] = {}
    found: dict[str, str] = {}
    for name, own in scene.scenes.items():
        other = first.setdefault(copied(own, {"name": "any"}).digest, name)
        if other != name:
            found[name] = other
    return found


def _part(progress: Progress | None, place: int, count: int) -> Progress | None:
    """The progress of one of several runs as that of all."""
    if progress is None:
        return None
    return lambda share: progress((place + share) / count)


def _renamed(run: Trajectory, scene: Scene) -> Trajectory:
    """The run of an equal actuator under its own name."""
    named = replace(run.classification, name=scene.name)
    text = resolved_yaml(scene)
    return replace(run, name=scene.name, spec_text=text, classification=named)
