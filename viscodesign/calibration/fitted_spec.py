"""The spec with fitted numbers, and their intervals as comments."""

from __future__ import annotations

from collections.abc import Sequence

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.results.fit_result import FittedNumber
from viscodesign.scene.reading.document import read_document
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.scene import Scene


def fitted_scene(scene: Scene, numbers: Sequence[FittedNumber]) -> Scene:
    """The scene with the fitted numbers, checked like a loaded one."""
    keys = FreeKeys(scene, [own.key for own in numbers])
    return keys.validated([own.value for own in numbers])


def spec_text(scene: Scene, numbers: Sequence[FittedNumber]) -> str:
    """A fitted scene as a spec, each fitted number with its interval behind it."""
    text = resolved_yaml(scene)
    places = read_document(text.encode(), "").lines
    lines = text.splitlines()
    keys = FreeKeys(scene, [own.key for own in numbers])
    for number, own in zip(keys.numbers, numbers, strict=True):
        line = places.get(number.path)
        if line is not None:
            lines[line - 1] += f"  # {interval_words(own)}"
    return "\n".join([*lines, ""])


def interval_words(number: FittedNumber) -> str:
    """What is known of a number, in words."""
    if number.edge:
        return f"not identified: at its {number.edge} search bound; {number.start:.6g} before"
    if number.why_unknown == "mismatch":
        return f"not identified: the model does not describe the data; {number.start:.6g} before"
    if number.low is None and number.high is None:
        return f"not identified by the data; {number.start:.6g} before"
    if number.low is None or number.high is None:
        end = f"below {number.high:.5g}" if number.low is None else f"above {number.low:.5g}"
        return f"95 %: {end}; the other end is not identified"
    words = f"95 %: {number.low:.6g} to {number.high:.6g}"
    return words if number.is_identified else f"{words}; hardly identified"
