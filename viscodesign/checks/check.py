"""Everything that is known of a scene without solving it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from viscodesign.checks.classify import classification
from viscodesign.checks.refusals import refuse_beyond_numbers, refuse_unsolvable
from viscodesign.checks.scene_warnings import verdict_notices
from viscodesign.checks.table_cover import input_notes
from viscodesign.effects.select import select_effects
from viscodesign.estimate.joined_quantities import quantities_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Classification, Notice, Verdict, check_document
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class Check:
    """Verdicts, warnings and facts of a scene."""

    name: str
    """That of the scene."""
    classification: Classification
    """Timescales and quadrant."""
    effects: tuple[Verdict, ...]
    """The decision on every effect."""
    warnings: tuple[Notice, ...]
    """What the user should know."""
    facts: tuple[str, ...]
    """The network in words."""

    def document(self) -> dict[str, Any]:
        """The check as one JSON-ready object, under the names of a run's summary."""
        return check_document(self.classification, self.effects, self.facts)


def check(scene: Scene) -> Check:
    """Weigh every effect and test every assumption that needs no solution.

    Raises `SpecError` where the scene has no bounded solution.
    """
    quantities = quantities_of(scene)
    refuse_beyond_numbers(quantities)
    selection = select_effects(quantities)
    verdicts, active = selection.verdicts, selection.active
    refuse_unsolvable(quantities, active)
    found = classification(quantities, active)
    found = replace(found, warnings=(*verdict_notices(quantities, verdicts), *found.warnings))
    facts = (*_facts(quantities), *input_notes(quantities))
    return Check(scene.name, found, verdicts, found.warnings, facts)


def _facts(quantities: SceneQuantities) -> list[str]:
    """The network in words."""
    graph = quantities.graph
    facts = [
        f"{len(graph.bellows)} bellows in {graph.sections} sections, {len(graph.tubes)} tubes, "
        f"{len(graph.junctions)} junctions, {len(graph.inlets)} inlets"
    ]
    for component in graph.components():
        loops = len(component.tubes) - (len(component.nodes) - 1)
        source = f"fed by {', '.join(component.inlets)}" if component.inlets else "sealed"
        shape = "a tree" if loops == 0 else f"{loops} loop{'s' if loops > 1 else ''}"
        facts.append(f"network of {len(component.bellows)} bellows, {source}: {shape}")
    facts += graph.remarks()
    return facts
