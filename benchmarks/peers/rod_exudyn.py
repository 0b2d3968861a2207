"""The rod by Exudyn: cubic ANCF cables or quadratic geometrically exact beams, generalised-alpha.

A uniform intrinsic curvature k of an elastic rod is a couple EI k on its free tip: both
put the same potential, -EI k phi(L), into the energy. So it enters as a torque, by a
symbolic user function that Exudyn evaluates in C++. The cable has neither shear nor
rotary inertia; the beam has both, so stiff and so small that they do not matter here.

As an expert would: dense solver, modified Newton with a tolerance that fits the step,
nothing written, the tip by a sensor kept in memory. A call starts from the initial state.
"""

from __future__ import annotations

import math
import sys
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
import rod

SHEAR_STIFFNESS = 1e6
"""Of the beams [N]; EI/(GA L^2) = 4e-6."""
ROTARY_INERTIA = 1e-9
"""Of the beams [kg m]; over m L^2 3e-7."""
SPECTRAL_RADIUS = 0.9
NEWTON_TOLERANCE = 1e-5
LADDERS = {
    "cycle_fast": [
        *[(2, h) for h in (1e-2, 5e-3, 2e-3, 1e-3, 5e-4)],
        *[(4, h) for h in (1e-3, 5e-4, 2e-4)],
    ],
    "cycle_slow": [
        *[(1, h) for h in (5e-2, 2.5e-2)],
        *[(2, h) for h in (5e-2, 2.5e-2, 1e-2, 5e-3, 2e-3)],
        *[(4, h) for h in (1e-2, 5e-3, 2e-3)],
    ],
    "release": [
        *[(4, h) for h in (5e-4, 2.5e-4, 1e-4)],
        *[(8, h) for h in (2.5e-4, 1e-4, 5e-5, 2.5e-5)],
        *[(16, h) for h in (5e-5, 2.5e-5, 1e-5)],
    ],
    "release_heavy": [
        *[(2, h) for h in (1e-3, 5e-4)],
        *[(4, h) for h in (5e-4, 2.5e-4, 1e-4)],
        *[(8, h) for h in (1e-4, 5e-5, 2.5e-5)],
        *[(16, h) for h in (2.5e-5, 1e-5)],
    ],
}
"""Elements and step [s], in whole parts of the output interval."""


class Exudyn(ABC):
    """One kind of element."""

    name: ClassVar[str]

    def __init__(self, case: rod.RodCase) -> None:
        self.case = case

    def settings(self) -> list[dict[str, Any]]:
        """Elements and steps, coarse to fine."""
        return [{"elements": n, "step_s": h} for n, h in LADDERS[self.case.name]]

    @abstractmethod
    def element(self, items: Any) -> Any:
        """Template of an element, from the module of items."""

    @abstractmethod
    def tip_marker(self, mbs: Any, items: Any, made: dict[str, Any], length: float) -> int:
        """Where the couple acts."""

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Assemble."""
        sys.exudynFast = True  # the build without range checks
        import exudyn
        import exudyn.beams
        import exudyn.itemInterface as items  # noqa: N813

        case, count = self.case, setting["elements"]
        container = exudyn.SystemContainer()
        mbs = container.AddSystem()
        template = self.element(items)
        made = exudyn.beams.GenerateBeamElementsAlongLine(
            mbs,
            [0, 0, 0],
            [rod.LENGTH, 0, 0],
            count,
            template,
            gravity=[0, case.gravity, 0],
            groundConstraintsStart=[True] * (4 if len(template.nodeNumbers) == 2 else 3),
        )
        function = None
        if case.gravity == 0.0:
            marker = self.tip_marker(mbs, items, made, rod.LENGTH / count)
            function = self._couple(exudyn, mbs, items, marker)
        sensor = mbs.AddSensor(
            items.SensorNode(
                nodeNumber=made["nodes"][-1],
                storeInternal=True,
                writeToFile=False,
                outputVariableType=exudyn.OutputVariableType.Position,
            )
        )
        mbs.Assemble()
        options = self._options(exudyn, setting)
        keep = (container, function)

        def run() -> np.ndarray:
            assert keep
            mbs.SolveDynamic(options, showHints=False)
            return np.asarray(mbs.GetSensorStoredData(sensor))[:, [2, 1]]

        return run

    def _couple(self, exudyn: Any, mbs: Any, items: Any, marker: int) -> Any:
        """The couple on the tip [N m], compiled."""
        import exudyn.utilities

        case, half = self.case, rod.BENDING_STIFFNESS * rod.CURVATURE / 2
        symbolic = exudyn.symbolic
        load = mbs.AddLoad(items.LoadTorqueVector(markerNumber=marker, loadVector=[0, 0, 0]))

        def torque(mbs: Any, t: Any, load: Any) -> Any:
            return symbolic.Vector([0, 0, half * (1 - symbolic.cos(2 * math.pi / case.period * t))])

        made = exudyn.utilities.CreateSymbolicUserFunction(
            mbs, torque, "loadVectorUserFunction", load
        )
        mbs.SetLoadParameter(load, "loadVectorUserFunction", made)
        return made

    def _options(self, exudyn: Any, setting: dict[str, Any]) -> Any:
        case, options = self.case, exudyn.SimulationSettings()
        time = options.timeIntegration
        time.endTime = case.duration
        time.numberOfSteps = round(case.duration / setting["step_s"])
        time.generalizedAlpha.spectralRadius = SPECTRAL_RADIUS
        time.newton.useModifiedNewton = True
        time.newton.relativeTolerance = NEWTON_TOLERANCE
        time.newton.absoluteTolerance = 1e-10
        options.linearSolver.solverType = exudyn.LinearSolverType.EXUdense
        options.solution.file.write = False
        options.solution.sensors.writePeriod = float(case.times[1])
        return options


class Cables(Exudyn):
    """Cubic, without shear."""

    name = "Exudyn 1.13 (cubic cables)"

    def element(self, items: Any) -> Any:
        return items.ObjectANCFCable2D(
            massPerLength=rod.MASS_PER_LENGTH,
            bendingStiffness=rod.BENDING_STIFFNESS,
            axialStiffness=rod.EXTENSION_STIFFNESS,
        )

    def tip_marker(self, mbs: Any, items: Any, made: dict[str, Any], length: float) -> int:
        marker = items.MarkerBodyRigid(
            bodyNumber=made["elements"][-1], localPosition=[length, 0, 0]
        )
        return int(mbs.AddMarker(marker))


class Beams(Exudyn):
    """Quadratic, with shear."""

    name = "Exudyn 1.13 (quadratic beams)"

    def element(self, items: Any) -> Any:
        return items.ObjectBeamGeometricallyExact2D(
            nodeNumbers=[0, 0, 0],
            massPerLength=rod.MASS_PER_LENGTH,
            crossSectionInertia=ROTARY_INERTIA,
            bendingStiffness=rod.BENDING_STIFFNESS,
            axialStiffness=rod.EXTENSION_STIFFNESS,
            shearStiffness=SHEAR_STIFFNESS,
        )

    def tip_marker(self, mbs: Any, items: Any, made: dict[str, Any], length: float) -> int:
        return int(mbs.AddMarker(items.MarkerNodeRigid(nodeNumber=made["nodes"][-1])))
