"""Several actuators side by side: each distinct one is solved once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from viscodesign._version import __version__
from viscodesign.errors import SolveError, UsageError, described
from viscodesign.exploration.simulate import simulate
from viscodesign.results.several_runs import SeveralRuns
from viscodesign.results.trajectory import RunInterruptedError, Trajectory
from viscodesign.scene.reading.write import part_yaml, resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.scene.several_scene import SeveralScene
from viscodesign.scene.spec_part import copied
from viscodesign.simulation.solve_once import Progress


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

    They share inputs of given pressure alone, so that what happens in one changes nothing in the
    others: equal ones are solved once. Arguments as of `simulate`. An actuator whose solution
    does not even begin is among ``failures``, and the others go on; Ctrl-C leaves out what is
    not done.

    Raises `SpecError` where an actuator has no bounded solution.
    """
    if not isinstance(scene, SeveralScene):
        given = described(scene)
        raise UsageError(
            f"expected several actuators, such as load_several('legs.yaml') gives; got {given}"
        )
    equal_to = equal_actuators(scene)
    solved = [name for name in scene.scenes if name not in equal_to]
    runs: dict[str, Trajectory] = {}
    failures: dict[str, str] = {}
    stopped = False
    for k, name in enumerate(solved):
        try:
            runs[name] = simulate(
                scene.scenes[name],
                verify=verify,
                prove=prove,
                uncertainty=uncertainty,
                progress=_part(progress, k, len(solved)),
                scratch=scratch,
            )
        except SolveError as error:
            failures[name] = str(error)
        except RunInterruptedError as error:
            stopped = True
            if error.trajectory is not None:
                runs[name] = error.trajectory
            break
    for name, other in equal_to.items():
        if other in runs:
            runs[name] = _renamed(runs[other], scene.scenes[name])
        elif other in failures:
            failures[name] = failures[other]
    left = tuple(n for n in scene.scenes if stopped and n not in runs and n not in failures)
    return SeveralRuns(
        name=scene.name,
        runs={name: runs[name] for name in scene.scenes if name in runs},
        equal_to={name: other for name, other in equal_to.items() if name in runs},
        sources={name: scene.sources_of(name) for name in scene.scenes},
        failures=failures,
        interrupted=left,
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
