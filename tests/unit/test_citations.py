"""What a run is told to cite."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from tests.scenes import CONFIGS
from tests.trajectories import made_run, verdict
from viscodesign.citations import CASADI, citations_of, every_work, own_sources
from viscodesign.cli.main import main
from viscodesign.effects.catalogue import catalogue
from viscodesign.references import PAPER, LiteratureReference
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.fluid import named_fluids
from viscodesign.solve.transient import solver_catalogue

NEEDED = {
    "article": {"author", "title", "journal", "year"},
    "book": {"author", "title", "publisher", "year"},
}


def every_reference() -> Iterator[LiteratureReference]:
    yield from (PAPER, CASADI)
    for family in (catalogue(), solver_catalogue(), named_fluids()):
        for member in family.values():
            yield from member.references


def a_run(fluid: str = "{name: water}", solver: str = "idas", **changes: object) -> Trajectory:
    made = made_run(spec_text=f"fluid: {fluid}\n", settings={"solver": solver})
    return replace(made, **changes)  # type: ignore[arg-type]


def keys(run: Trajectory) -> list[str]:
    return [citation.reference.key for citation in citations_of(run)]


def test_entries_are_complete_and_can_be_read_as_bibtex() -> None:
    found = {reference.key: reference for reference in every_reference()}
    assert len(found) >= 15
    assert len({reference.fields["title"] for reference in found.values()}) == len(found)
    for key, reference in found.items():
        assert NEEDED[reference.kind] <= set(reference.fields), key
        assert re.fullmatch(r"[a-z]+\d{4}", key)
        assert key.endswith(reference.fields["year"])
        text = reference.bibtex
        assert text.count("{") == text.count("}")
        assert text.isascii()


def test_every_work_is_listed_with_its_identifier() -> None:
    works = {work.key: work.text for work in every_work()}
    assert {reference.key for reference in every_reference()} <= set(works)
    assert works["churchill1977"] == (
        "Churchill, S. W. (1977). Friction-factor equation spans all fluid-flow regimes. "
        "Chemical Engineering 84(24), 91-92"
    )
    assert works["matia2023"].startswith("Matia, Yoav et al. (2023). Harnessing Nonuniform")
    assert works["andersson2019"].endswith("11, 1-36, https://doi.org/10.1007/s12532-018-0139-4")
    assert not any(mark in text for text in works.values() for mark in ("{", "\\", " and others"))


def test_effects_without_a_work_say_where_they_are_from(
    capsys: pytest.CaptureFixture[str],
) -> None:
    effects = (
        verdict("fluid_inertance", True),
        verdict("flow_regime", True),
        verdict("damping", False),
    )
    told = own_sources(a_run(effects=effects))
    assert told == ["effect fluid_inertance: Momentum of a parabolic profile."]
    assert main(["effects", "flow_regime"]) == 0
    assert "Friction-factor equation spans all fluid-flow regimes" in " ".join(
        capsys.readouterr().out.split()
    )


def test_a_run_cites_what_it_used() -> None:
    effects = (verdict("flow_regime", True), verdict("material_curve", False), verdict("new", True))
    found = keys(a_run(effects=effects))
    assert found[:2] == ["viscodesign", "matia2023"]
    assert {"churchill1977", "wagner2002", "huber2009", "hindmarsh2005"} <= set(found)
    assert not {"fritsch1984", "steinebach2023", "lemmon2000"} & set(found)
    assert len(set(found)) == len(found)


@pytest.mark.parametrize(
    ("fluid", "key"), [("{name: glycerol-water}", "cheng2008"), ("{name: air}", "lemmon2004")]
)
def test_fluids_of_the_library_are_cited_and_those_of_the_spec_not(fluid: str, key: str) -> None:
    assert key in keys(a_run(fluid))
    given = fluid.replace("}", ", viscosity: 1e-3 Pa*s, density: 1e3 kg/m^3}")
    assert key not in keys(a_run(given))


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run = tmp_path / "run"
    spec = str(CONFIGS / "leg_4_air.yaml")
    words = ["simulate", spec, "-o", str(run), "-q", "--no-plots", "--no-report"]
    assert main([*words, "--no-verify", "--set", "run.duration=100 ms"]) == 0
    assert main(["cite", str(run), "-o", str(tmp_path)]) == 0
    said = capsys.readouterr().out
    assert said == (tmp_path / "references.bib").read_text()
    assert "% the model of bellows, tubes and rod; effect" in said
    assert main(["cite", str(tmp_path)]) == 2
