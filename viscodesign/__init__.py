"""Design soft actuators that move by the viscosity of their fluid.

    from viscodesign import load, simulate
    trajectory = simulate(load("leg.yaml"))
    trajectory.frame()

`load` reads a spec, `check` and `classify` judge it without solving, `simulate`
follows its motion, `compile` makes a function of its numbers with derivatives, `sweep` puts many
designs in one table, `sensitivity` measures how far each number moves the tip, `design` finds the
numbers and the graph that make the tip follow a path, `reach` finds where it can be, `fit` finds
numbers by measurements, `compare` puts motions beside each other, `accuracy` measures what accuracy
costs in time, `plan` turns its pressures into a pump's motion. `load_robot` reads a robot on such
actuators, `stand` and `walk` compute how it stands and walks. `load_several`, `check_several`,
`classify_several` and `simulate_several` take specs of several actuators. Nothing here prints.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from viscodesign._version import __version__ as __version__
from viscodesign.lazy_names import lazy_names

if TYPE_CHECKING:
    from viscodesign.calibration.fit import fit as fit
    from viscodesign.checks.check import Check as Check
    from viscodesign.checks.check_several import check_several as check_several
    from viscodesign.checks.check_several import classify_several as classify_several
    from viscodesign.checks.classify import classify as classify
    from viscodesign.comparison.compare import compare as compare
    from viscodesign.compiled.function import Batch as Batch
    from viscodesign.compiled.function import CompiledFunction as CompiledFunction
    from viscodesign.compiled.several import CompiledActuators as CompiledActuators
    from viscodesign.errors import SpecError as SpecError
    from viscodesign.errors import ViscodesignError as ViscodesignError
    from viscodesign.inverse.design import design as design
    from viscodesign.inverse.reach import reach as reach
    from viscodesign.loading import load as load
    from viscodesign.loading import load_robot as load_robot
    from viscodesign.loading import load_several as load_several
    from viscodesign.pump.planning.plan import plan as plan
    from viscodesign.pump.planning.result import PumpPlan as PumpPlan
    from viscodesign.results.accuracy_study import (
        AccuracyInterruptedError as AccuracyInterruptedError,
    )
    from viscodesign.results.accuracy_study import AccuracyStudy as AccuracyStudy
    from viscodesign.results.findings import Classification as Classification
    from viscodesign.results.fit_result import Fit as Fit
    from viscodesign.results.path_design import PathDesign as PathDesign
    from viscodesign.results.reach_study import ReachStudy as ReachStudy
    from viscodesign.results.run_comparison import Comparison as Comparison
    from viscodesign.results.run_comparison import (
        ComparisonInterruptedError as ComparisonInterruptedError,
    )
    from viscodesign.results.sensitivity_study import (
        SensitivityInterruptedError as SensitivityInterruptedError,
    )
    from viscodesign.results.sensitivity_study import SensitivityStudy as SensitivityStudy
    from viscodesign.results.several_runs import SeveralRuns as SeveralRuns
    from viscodesign.results.stand_study import StandStudy as StandStudy
    from viscodesign.results.sweep_table import Sweep as Sweep
    from viscodesign.results.trajectory import RunInterruptedError as RunInterruptedError
    from viscodesign.results.trajectory import Trajectory as Trajectory
    from viscodesign.results.walk_study import WalkStudy as WalkStudy
    from viscodesign.robot.compile import compile as compile
    from viscodesign.robot.compiled_robot import CompiledRobot as CompiledRobot
    from viscodesign.robot.stand import stand as stand
    from viscodesign.robot.walk import walk as walk
    from viscodesign.scene.robot_scene import RobotScene as RobotScene
    from viscodesign.scene.scene import Scene as Scene
    from viscodesign.scene.several_scene import SeveralScene as SeveralScene
    from viscodesign.studies.accuracy import accuracy as accuracy
    from viscodesign.studies.check import check as check
    from viscodesign.studies.sensitivity import sensitivity as sensitivity
    from viscodesign.studies.simulate import simulate as simulate
    from viscodesign.studies.simulate_several import simulate_several as simulate_several
    from viscodesign.studies.sweep import sweep as sweep

_HOMES = {
    "AccuracyInterruptedError": ".results.accuracy_study",
    "AccuracyStudy": ".results.accuracy_study",
    "Batch": ".compiled.function",
    "Check": ".checks.check",
    "Classification": ".results.findings",
    "Comparison": ".results.run_comparison",
    "ComparisonInterruptedError": ".results.run_comparison",
    "CompiledActuators": ".compiled.several",
    "CompiledFunction": ".compiled.function",
    "CompiledRobot": ".robot.compiled_robot",
    "Fit": ".results.fit_result",
    "PathDesign": ".results.path_design",
    "ReachStudy": ".results.reach_study",
    "PumpPlan": ".pump.planning.result",
    "RobotScene": ".scene.robot_scene",
    "RunInterruptedError": ".results.trajectory",
    "Scene": ".scene.scene",
    "SensitivityInterruptedError": ".results.sensitivity_study",
    "SensitivityStudy": ".results.sensitivity_study",
    "SpecError": ".errors",
    "StandStudy": ".results.stand_study",
    "Sweep": ".results.sweep_table",
    "Trajectory": ".results.trajectory",
    "ViscodesignError": ".errors",
    "WalkStudy": ".results.walk_study",
    "accuracy": ".studies.accuracy",
    "SeveralRuns": ".results.several_runs",
    "SeveralScene": ".scene.several_scene",
    "check": ".studies.check",
    "check_several": ".checks.check_several",
    "classify_several": ".checks.check_several",
    "load_several": ".loading",
    "simulate_several": ".studies.simulate_several",
    "classify": ".checks.classify",
    "compare": ".comparison.compare",
    "compile": ".robot.compile",
    "design": ".inverse.design",
    "fit": ".calibration.fit",
    "load": ".loading",
    "load_robot": ".loading",
    "plan": ".pump.planning.plan",
    "reach": ".inverse.reach",
    "sensitivity": ".studies.sensitivity",
    "simulate": ".studies.simulate",
    "stand": ".robot.stand",
    "walk": ".robot.walk",
    "sweep": ".studies.sweep",
}
"""Where each name is imported from when it is first asked for: `--help` needs none of them."""

__all__ = ["__version__", *_HOMES]

__getattr__, __dir__ = lazy_names(__name__, _HOMES)
