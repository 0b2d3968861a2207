"""A plunger and its drive in numbers and words, and what keeps it from being planned."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import names_with
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.physics import gas
from viscodesign.pump.drive import PlungerDrive
from viscodesign.pump.planning.demand import fed_by_each
from viscodesign.pump.planning.result import PumpCourse
from viscodesign.results.findings import Notice
from viscodesign.scene.scene import Scene

if TYPE_CHECKING:
    from viscodesign.pump.plunger.plunger_demand import PlungerDemand


def plunger_faults(scene: Scene, drive: PlungerDrive) -> Iterator[tuple[str, str]]:
    """Keys of a scene that keep a syringe from being planned, each with what to correct."""
    pump, fluid = drive.pump, scene.fluid
    if not fluid.is_gas and fluid.bulk_modulus is None:
        yield (
            "fluid",
            f"the stiffness of {fluid.name}, which the pump pushes, is unknown; give viscosity, "
            "density and gas_constant or bulk_modulus under fluid",
        )
    if drive.filled_at_home <= 0.0:
        yield (
            "pump.syringe_stroke",
            f"{1e3 * pump.syringe_stroke:.4g} mm is not enough: from home ({pump.home} "
            f"{drive.step_name}s) the travel {list(pump.travel)} draws the plunger out by "
            f"{-1e3 * drive.range[0]:.4g} mm. Use a longer syringe, a smaller {drive.gear_key} or "
            "a shorter travel, or state filled_length",
        )
    elif drive.filled_at_home > pump.syringe_stroke:
        yield (
            "pump.filled_length",
            f"{1e3 * drive.filled_at_home:.4g} mm are longer than pump.syringe_stroke, the whole "
            f"barrel of {1e3 * pump.syringe_stroke:.4g} mm",
        )


def plunger_numbers(demand: PlungerDemand) -> dict[str, float]:
    """What the drive of an inlet is, and what the plan takes of it."""
    pump, drive, barrel = demand.pump, demand.drive, demand.barrel
    step, steps, load = drive.step_name, demand.axis.unit, drive.load
    slow = barrel.compliance(demand.scene.gauge_pressure, 0.0) + _network_compliance(demand)
    fast = demand.least_compliance
    return {
        "stall_pressure_pa_gauge": drive.stall_pressure,
        "no_load_flow_m3_s": float(drive.speed_left(0.0)) * drive.area,
        "travel_volume_m3": (pump.travel[1] - pump.travel[0]) * drive.volume_per_step,
        f"volume_per_{step}_m3": drive.volume_per_step,
        f"{steps}_per_ml": 1e-6 / drive.volume_per_step,
        f"{steps}_per_kpa_fast": 1e3 * fast / drive.volume_per_step,
        f"{steps}_per_kpa_slow": 1e3 * slow / drive.volume_per_step,
        f"kpa_per_{step}_fast": 1e-3 * drive.volume_per_step / fast,
        "filled_length_m": drive.filled_at_home,
        "highest_pressure_pa_gauge": float(demand.pressure.max()),
        "lowest_pressure_pa_gauge": float(demand.pressure.min()),
        f"largest_{load.name}_{load.suffix}": float(np.max(np.abs(demand.load))),
        "largest_flow_m3_s": float(np.max(np.abs(demand.velocity))) * drive.area,
        "lead_in_s": demand.lead_s,
    }


def plunger_words(demand: PlungerDemand) -> dict[str, str]:
    """The drive for people: sentences by their headings."""
    n, load, steps = demand.numbers(), demand.drive.load, demand.axis.unit
    kpa = {name: n[f"{name}_pressure_pa_gauge"] / 1e3 for name in ("stall", "lowest", "highest")}
    ids = dict(zip(demand.scene.inputs, demand.pump.axes(len(demand.scene.inputs)), strict=True))
    return {
        "drive": f"{demand.device}, id {ids[demand.inlet]}, for the inlet '{demand.inlet}'",
        "stall": f"{kpa['stall']:.4g} kPa gauge",
        steps: f"{n[f'{steps}_per_ml']:.3g} per mL; per kPa {n[f'{steps}_per_kpa_fast']:.3g} at "
        f"first, {n[f'{steps}_per_kpa_slow']:.3g} once the actuator has followed",
        "travel": f"{1e6 * n['travel_volume_m3']:.3g} mL; {1e3 * n['filled_length_m']:.4g} mm of "
        "the barrel filled at home",
        "needs": f"{kpa['lowest']:.4g} to {kpa['highest']:.4g} kPa gauge, "
        f"{n[f'largest_{load.name}_{load.suffix}']:.3g} {load.unit}, "
        f"{1e6 * n['largest_flow_m3_s']:.3g} mL/s",
        "lead-in": f"{n['lead_in_s']:.3g} s from home to the pressure of the start",
    }


def _network_compliance(demand: PlungerDemand) -> float:
    """Compliance of all bellows that an inlet feeds, wall and gas, by the linear law [m3/Pa]."""
    scene, bellow = demand.scene, SceneQuantities(demand.scene).bellow
    part = next(c for c in scene.graph.components() if demand.inlet in c.inlets)
    one = bellow.compliance
    if not _gas_effects_off(scene):
        absolute = scene.ambient_pressure + scene.gauge_pressure
        one += gas.gas_compliance(bellow.rest_volume, absolute, scene.fluid.polytropic_exponent)
    return fed_by_each(scene) * len(part.bellows) * one / len(part.inlets)


def _gas_effects_off(scene: Scene) -> list[str]:
    """Names of the effects that make the gas compressible and are not switched on."""
    names = names_with(Trait.COMPRESSIBLE_FLUID)
    return [name for name in names if scene.effects.mode(name) != "on"]


def gas_notices(demands: Sequence[PlungerDemand]) -> Iterator[Notice]:
    """Gas that the plunger would have to compress, and the model leaves out."""
    scene = demands[0].scene
    off = _gas_effects_off(scene)
    if not (scene.fluid.is_gas and off):
        return
    swing = max(float(np.ptp(d.pressure)) for d in demands)
    bellows = fed_by_each(scene) * len(scene.graph.bellows)
    rest = bellows * SceneQuantities(scene).bellow.rest_volume
    yield Notice(
        "gas_not_counted",
        f"effects.{off[0]} is off, so the gas in the bellows counts as incompressible: up to "
        f"{1e6 * rest * swing / scene.ambient_pressure:.3g} mL that the plunger would have to move "
        "for its compression are left out",
    )


def range_rows(
    course: PumpCourse, pump: Any, steps: np.ndarray, unit: str
) -> list[tuple[str, str]]:
    """Range of the plungers, in ``steps`` of a ``unit``, and of the pressures, for people."""
    volume, pressure = 1e6 * course.columns["volume_m3"], course.pressure / 1e3
    low, high = pump.travel
    return [
        (
            "plunger",
            f"{steps.min():.0f} to {steps.max():.0f} {unit} (travel {low} to {high}), "
            f"{volume.min():.3g} to {volume.max():.3g} mL from home",
        ),
        ("pressure", f"{pressure.min():.2f} to {pressure.max():.2f} kPa gauge"),
    ]
