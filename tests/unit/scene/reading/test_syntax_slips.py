"""Text that is not YAML is told by the likely slip and its own line."""

from __future__ import annotations

import pytest

from tests.scenes import CONFIGS
from viscodesign import load
from viscodesign.errors import MAX_LISTED_FAULTS, SpecError

LEG = (CONFIGS / "leg_4_air.yaml").read_text(encoding="utf-8")


def refusal(text: str) -> str:
    with pytest.raises(SpecError) as caught:
        load(text)
    return str(caught.value)


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("  length:109 mm", "no space behind the colon of 'length:'"),
        ("  length： 109 mm", "contains fullwidth colon (U+FF1A)"),
        ("\u00a0\u00a0length: 109 mm", "contains no-break space (U+00A0)"),
        ("  len\u200bgth:109 mm", "contains zero width space (U+200B)"),
        ("\tlength: 109 mm", "indented with a tab"),
        ("  length: 109: mm", "a value with a colon needs quotes"),
        ("  length: %109", "a value that begins with '%' needs quotes"),
        ("  length: @109", "a value that begins with '@' needs quotes"),
        ("  length: `109`", "a value that begins with '`' needs quotes"),
        ("  length: '109 mm", "a quote opens here that is not closed"),
        ('  length: "109 mm', "a quote opens here that is not closed"),
    ],
)
def test_a_slip_is_named_on_its_own_line(written: str, told: str) -> None:
    lines = LEG.splitlines()
    at = next(k for k, line in enumerate(lines) if line.startswith("  length:"))
    lines[at] = written
    assert refusal("\n".join(lines)).startswith(f"<text>:{at + 1}: not YAML: {told}")


def test_other_faults_keep_the_words_of_the_parser() -> None:
    assert "did not find expected ',' or ']'" in refusal("a: [1, 2\n")


def test_a_text_with_the_line_ends_of_old_is_no_path() -> None:
    assert load(LEG.replace("\n", "\r")) == load(LEG)


@pytest.mark.parametrize(
    ("key", "told"),
    [
        ("run.accuracy", "did you mean 'accuracy', outside of 'run'?"),
        ("fluid.temperature", "did you mean 'temperature', outside of 'fluid'?"),
        ("actuator.tube_radius", "did you mean 'network.tube_radius'?"),
        ("bellows.tube_length", "did you mean 'network.tube_length'?"),
        ("network.viscosity", "did you mean 'fluid.viscosity'?"),
        ("input.max_steps", "did you mean 'run.max_steps'?"),
        ("run.gravity", "did you mean 'loads.gravity'?"),
        ("\u0430ctuator", "(contains cyrillic small letter a (U+0430)); did you mean 'actuator'?"),
    ],
)
def test_a_key_of_another_section_is_shown_there(key: str, told: str) -> None:
    with pytest.raises(SpecError) as caught:
        load(LEG, {key: "1"})
    assert told in str(caught.value)


@pytest.mark.parametrize("name", ["CON", "nul", "Lpt1", "com7.yaml", "aux.leg", "leg."])
def test_a_name_is_a_folder_on_every_system(name: str) -> None:
    with pytest.raises(SpecError, match="cannot name a folder on Windows"):
        load(LEG, {"name": name})
    assert load(LEG, {"name": "console"}).name == "console"


@pytest.mark.parametrize("given", ["none", "down", "moon", "mono", "non-linear"])
def test_short_words_are_not_suggested_for_what_only_has_their_letters(given: str) -> None:
    for key in ("effects", "loads.gravity"):
        with pytest.raises(SpecError) as caught:
            load(LEG, {key: given})
        assert "did you mean" not in str(caught.value)


def test_only_unknown_keys_that_are_listed_are_compared_with_known_ones() -> None:
    """A hint takes a millisecond: 30,000 of them took half a minute."""
    with pytest.raises(SpecError) as caught:
        load("".join(f"k{k}: 1\n" for k in range(500)))
    explained = [fault for fault in caught.value.faults if "Allowed here" in fault.message]
    assert MAX_LISTED_FAULTS - 10 < len(explained) <= MAX_LISTED_FAULTS
    assert len(caught.value.faults) > 500
    assert str(caught.value).count("\n") == MAX_LISTED_FAULTS
