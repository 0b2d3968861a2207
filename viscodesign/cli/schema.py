"""`viscodesign schema`: the spec's JSON Schema, for editors."""

from __future__ import annotations

from viscodesign.cli.options import Answer, Output

EXAMPLE = """\b
Example:
  viscodesign schema > spec.schema.json
Then let your editor find it, by a first line in the spec:
  # yaml-language-server: $schema=spec.schema.json"""


def command(
    output: Output = None,
    *,
    answer: Answer,
) -> None:
    """Print the JSON Schema of a spec.

    Editors use it to complete and check a spec. It is JSON with or without --json. With -o
    also writes DIR/spec.schema.json.
    """
    from viscodesign.cli.output import json_text, say, write_text
    from viscodesign.loading import schema

    document = json_text(schema())
    if output is not None:
        write_text(output / "spec.schema.json", document + "\n", overwrite=True)
    if not answer.quiet or answer.json:
        say(document)
