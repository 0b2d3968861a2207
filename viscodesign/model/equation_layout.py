"""What equations and unknowns a structure has, without their formulas."""

from __future__ import annotations

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.boundary_work import WorkSplit
from viscodesign.model.graph import Component
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.unknowns import Unknowns


@dataclass(frozen=True)
class EquationLayout:
    """Plain data of one structure."""

    rod_form: RodForm
    network_form: NetworkForm
    states: Unknowns
    algebraics: Unknowns
    statics: Unknowns
    """Unknowns of the equilibrium: pressures, flows that are not formulas, the rod's shape."""
    rates: tuple[str, ...]
    """Powers whose integrals the balances need [W]; those that depend on time alone come last."""
    integrals: int
    """How many of them an integrator integrates: the others depend on time alone."""
    work_splits: dict[str, WorkSplit]
    """How works of forces along paths are integrated, by name."""
    fed: tuple[Component, ...]
    driven: tuple[str, ...]
    """Inlets whose pressure is given, in the order of the state `inflow`."""
    sealed: tuple[Component, ...]
    storing: tuple[str, ...]
    """Nodes other than bellows that store fluid."""
    incompressible: bool
    """Whether the amount of fluid in a bellow equals its volume."""
    contacts: tuple[str, ...]
    """Names of the points that may touch something; their forces are states that no equation
    changes."""

    @property
    def time_only_integrals(self) -> int:
        """How many depend on time alone."""
        return len(self.rates) - self.integrals
