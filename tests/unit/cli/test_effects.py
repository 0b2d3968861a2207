"""`effects`: the catalogue tells of itself."""

from __future__ import annotations

import json
from pathlib import Path
from typing import ClassVar

import pytest

from viscodesign.effects import select
from viscodesign.effects.catalogue import catalogue
from viscodesign.effects.gravity import Gravity

from .conftest import Call


class Buoyancy(Gravity):
    """The ambient fluid carries a part of the weight.

    It acts at the middle
    of the displaced volume.
    """

    name: ClassVar[str] = "buoyancy"
    formula: ClassVar[str] = "rho_a / rho"
    needs: ClassVar[tuple[str, ...]] = ("gravity",)
    validity: ClassVar[str] = "A fluid at rest."
    source: ClassVar[str] = "Archimedes."
    keys: ClassVar[tuple[str, ...]] = ("ambient.density",)


@pytest.fixture
def with_buoyancy(monkeypatch: pytest.MonkeyPatch) -> None:
    """A catalogue with one effect more."""
    known = {**catalogue(), "buoyancy": Buoyancy}
    monkeypatch.setattr("viscodesign.effects.catalogue.catalogue", lambda: known)


def words(text: str) -> str:
    return " ".join(text.split())


def test_the_catalogue_in_order_with_summary_and_weight(call: Call) -> None:
    outcome = call("effects")
    assert (outcome.status, outcome.err) == (0, "")
    told = words(outcome.out)
    places = []
    for name, kind in catalogue().items():
        first = words((kind.__doc__ or "").split("\n\n")[0])
        entry = f"{name} {first} weight = {kind.formula}"
        assert entry in told
        places.append(told.index(entry))
    assert places == sorted(places)


@pytest.mark.parametrize("name", catalogue())
def test_every_effect_has_a_page(call: Call, name: str) -> None:
    outcome = call("effects", name)
    kind = catalogue()[name]
    told = words(outcome.out)
    assert outcome.status == 0
    for fact in (words(kind.__doc__ or ""), kind.formula, kind.validity, kind.source, *kind.keys):
        assert fact in told
    assert f"effects.{name}" in told


@pytest.mark.usefixtures("with_buoyancy")
def test_a_new_effect_is_described_without_further_changes(call: Call) -> None:
    assert "buoyancy" in call("effects").out
    lines = call("effects", "buoyancy").out.splitlines()
    assert lines[:2] == [
        "buoyancy: The ambient fluid carries a part of the weight.",
        "  It acts at the middle of the displaced volume.",
    ]
    told = words(" ".join(lines))
    assert "weight rho_a / rho" in told
    assert "validity A fluid at rest." in told
    assert "source Archimedes." in told
    assert "spec keys effects.buoyancy, ambient.density" in told
    assert "Without gravity it is not applicable" in told


@pytest.mark.usefixtures("with_buoyancy")
def test_the_document_of_one(call: Call) -> None:
    document = json.loads(call("effects", "buoyancy", "--json").out)
    (told,) = document["effects"]
    assert told.pop("decision").startswith("`effects.buoyancy: on` includes it")
    assert told == {
        "name": "buoyancy",
        "summary": "The ambient fluid carries a part of the weight.",
        "documentation": "The ambient fluid carries a part of the weight.\n\n"
        "It acts at the middle of the displaced volume.",
        "formula": "rho_a / rho",
        "validity": "A fluid at rest.",
        "source": "Archimedes.",
        "references": [],
        "keys": ["effects.buoyancy", "ambient.density"],
        "options": [],
        "needs": ["gravity"],
        "follows_others": True,
    }


def test_the_document_of_all(call: Call, tmp_path: Path) -> None:
    outcome = call("effects", "--json", "-o", tmp_path)
    document = json.loads(outcome.out)
    assert [told["name"] for told in document["effects"]] == list(catalogue())
    assert (tmp_path / "effects.json").read_text() == outcome.out
    assert call("effects", "-q").out == ""


def test_the_page_quotes_how_the_selection_decides(call: Call) -> None:
    rule = words((select.__doc__ or "").split("\n\n")[1])
    assert rule in words(call("effects", "gravity").out)
    assert rule not in words(call("effects", "tip_load").out)
    assert "where a spec defines it" in words(call("effects", "tip_load").out)


@pytest.mark.parametrize("json_words", [(), ("--json",)])
def test_an_unknown_name(call: Call, json_words: tuple[str, ...]) -> None:
    outcome = call("effects", "gravty", *json_words)
    assert (outcome.status, bool(outcome.out)) == (2, bool(json_words))
    assert "gravty: no such effect; did you mean 'gravity'?" in outcome.err
    far = call("effects", "zzz")
    assert far.status == 2
    assert far.err == "zzz: no such effect. `viscodesign effects` lists them\n"
