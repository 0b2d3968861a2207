"""`viscodesign check`: all that is known of a spec without solving it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from viscodesign.cli.options import Answer, Output, Overrides, Specs
from viscodesign.cli.output import json_text, write_text
from viscodesign.cli.specs import SpecResult, read_any, run_specs

if TYPE_CHECKING:
    from viscodesign import Check, RobotScene

EXAMPLE = """\b
Examples:
  viscodesign check leg.yaml
  viscodesign check leg.yaml --set fluid=water --json
  viscodesign check configs/*.yaml"""


def command(
    specs: Specs,
    overrides: Overrides = None,
    output: Output = None,
    *,
    answer: Answer,
) -> None:
    """Validate specs and weigh every effect.

    Prints timescales, the decision on every effect, facts of the network and warnings;
    solves nothing. `-` reads a spec from standard input. With -o also writes DIR/check.json.
    A valid spec with warnings exits with 0; of several specs the largest exit code counts.
    """
    silent = answer.json or answer.quiet

    def run(spec: Path) -> SpecResult:
        from viscodesign import RobotScene, check
        from viscodesign.scene.several_scene import SeveralScene

        scene = read_any(spec, overrides)
        if isinstance(scene, RobotScene):
            return _robot_result(scene, silent=silent)
        if isinstance(scene, SeveralScene):
            from viscodesign.cli.several import checked_several

            return checked_several(scene, lines=not silent)
        found = check(scene)
        return SpecResult(found.document(), [] if silent else check_lines(found))

    def keep(document: dict[str, Any]) -> None:
        if output is not None:
            write_text(output / "check.json", json_text(document) + "\n", overwrite=True)

    run_specs(specs, run, answer, keep)


def _robot_result(scene: RobotScene, *, silent: bool) -> SpecResult:
    """Every design of a robot, one after the other."""
    from viscodesign.cli.texts.check_text import full_notice_lines
    from viscodesign.robot.robot_check import check_robot

    found = check_robot(scene)
    limit = found.sway_limit_n
    sways = f"; sways from {limit:.4g} N on, at the spec's gauge pressure"
    known = sways if 0.0 < limit < math.inf else ""
    head = f"{found.name}: {found.legs} legs, {found.weight_n:.4g} N{known}"
    warnings = full_notice_lines(found.warnings)
    of_body = ["warnings", *warnings] if warnings else []
    designs = (line for own in found.designs.items() for line in _design_lines(*own))
    lines = [head, *of_body, *designs]
    return SpecResult(found.document(), [] if silent else lines)


def _design_lines(name: str, found: Check) -> list[str]:
    return ["", f"actuator {name}, by itself", *check_lines(found)]


def check_lines(found: Check) -> list[str]:
    """A check for people."""
    from viscodesign.cli.texts.check_text import (
        full_notice_lines,
        quadrant_lines,
        scale_lines,
        verdict_lines,
    )
    from viscodesign.cli.texts.layout import wrap

    warnings = full_notice_lines(found.warnings)
    return [
        *quadrant_lines(found.classification),
        "",
        *scale_lines(found.classification),
        "",
        *verdict_lines(found.effects),
        "",
        "network",
        *(line for fact in found.facts for line in wrap(fact, "  ", "    ")),
        "",
        *(["warnings", *warnings] if warnings else ["no warnings"]),
    ]
