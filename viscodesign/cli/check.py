"""`viscodesign check`: all that is known of a spec without solving it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from viscodesign.cli.options import Debug, Json, Output, Overrides, Quiet, Spec

if TYPE_CHECKING:
    from viscodesign import Check

EXAMPLE = """\b
Examples:
  viscodesign check leg.yaml
  viscodesign check leg.yaml --set fluid=water --json"""


def command(
    spec: Spec,
    overrides: Overrides = None,
    output: Output = None,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Validate a spec and weigh every effect.

    Prints timescales, the decision on every effect, facts of the network and warnings;
    solves nothing. With -o also writes DIR/check.json. A valid spec with warnings exits
    with 0.
    """
    from viscodesign import check, load
    from viscodesign.cli.output import json_text, say, write_text

    found = check(load(spec, overrides or ()))
    document = json_text(found.document())
    if output is not None:
        write_text(output / "check.json", document + "\n", overwrite=True)
    if json:
        say(document)
    elif not quiet:
        say("\n".join(_lines(found)))


def _lines(found: Check) -> list[str]:
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
