"""What a run is to cite: the works behind its model, its effects, its fluid and its solver."""

from __future__ import annotations

from collections.abc import Iterator

import yaml

from viscodesign._version import __version__
from viscodesign.effects.catalogue import catalogue
from viscodesign.lazy_dataclass import dataclass
from viscodesign.references import PAPER, LiteratureReference
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.fluid import named_fluid, named_fluids
from viscodesign.solve.transient import every_solver

CASADI = LiteratureReference(
    "andersson2019",
    "article",
    {
        "author": "Andersson, Joel A. E. and Gillis, Joris and Horn, Greg and Rawlings, James B. "
        "and Diehl, Moritz",
        "title": "{CasADi} -- {A} software framework for nonlinear optimization "
        "and optimal control",
        "journal": "Mathematical Programming Computation",
        "volume": "11",
        "pages": "1--36",
        "year": "2019",
        "doi": "10.1007/s12532-018-0139-4",
    },
)


@dataclass(frozen=True)
class Citation:
    """A work, and what a run took from it."""

    reference: LiteratureReference
    uses: tuple[str, ...]

    @property
    def bibtex(self) -> str:
        """The entry, after a comment that says what for."""
        return f"% {'; '.join(self.uses)}\n{self.reference.bibtex}"


def citations_of(run: Trajectory) -> list[Citation]:
    """The works behind a run, each once, in the order of its parts."""
    uses: dict[str, list[str]] = {}
    known: dict[str, LiteratureReference] = {}
    for reference, use in _uses(run):
        known.setdefault(reference.key, reference)
        uses.setdefault(reference.key, []).append(use)
    return [Citation(known[key], tuple(dict.fromkeys(own))) for key, own in uses.items()]


def own_sources(run: Trajectory) -> list[str]:
    """Where effects of a run are taken from that build on no work in particular."""
    kinds = [catalogue().get(verdict.name) for verdict in run.effects if verdict.taken]
    return [
        f"effect {kind.name}: {kind.source}"
        for kind in kinds
        if kind is not None and kind.source and not kind.references
    ]


def every_work() -> list[LiteratureReference]:
    """All works that any run can be told to cite, each once, in the order of their keys."""
    effects = (work for kind in catalogue().values() for work in kind.references)
    solvers = (work for kind in every_solver().values() for work in kind.references)
    fluids = (work for kind in named_fluids().values() for work in kind.references)
    every = [PAPER, CASADI, *effects, *solvers, *fluids]
    return [work for _, work in sorted({work.key: work for work in every}.items())]


def _uses(run: Trajectory) -> Iterator[tuple[LiteratureReference, str]]:
    yield _software(run.version), "this program"
    yield PAPER, "the model of bellows, tubes and rod"
    for verdict in run.effects:
        kind = catalogue().get(verdict.name) if verdict.taken else None
        for reference in () if kind is None else kind.references:
            yield reference, f"effect {verdict.name}"
    for reference in _of_fluid(run):
        yield reference, "properties of the fluid"
    yield CASADI, "symbolic balances and derivatives"
    solver = every_solver().get(str(run.settings.get("solver")))
    for reference in () if solver is None else solver.references:
        yield reference, "time integration"


def _of_fluid(run: Trajectory) -> tuple[LiteratureReference, ...]:
    """Name the source of a fluid from the library; none where the spec gives its properties."""
    spec = yaml.safe_load(run.spec_text)
    fluid = spec.get("fluid") if isinstance(spec, dict) else None
    if not isinstance(fluid, dict) or "viscosity" in fluid:
        return ()
    kind = named_fluid(str(fluid.get("name")))
    return () if kind is None else kind.references


def _software(version: str) -> LiteratureReference:
    own = {
        "author": "{the viscodesign authors}",
        "title": "viscodesign: design soft actuators that move by the viscosity of their fluid",
        "version": version or __version__,
        "year": "2026",
        "license": "MIT",
    }
    return LiteratureReference("viscodesign", "software", own)
