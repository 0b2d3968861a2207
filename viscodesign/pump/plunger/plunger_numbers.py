"""A plunger and its drive in numbers and words, and what keeps one from being planned."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import names_with
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.physics import gas
from viscodesign.pump.drive import Drive
from viscodesign.pump.planning.feed_line import fed_by_each
from viscodesign.results.findings import Notice
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.pumps.servo_motor import STEADY_SHARE
from viscodesign.scene.scene import Scene

if TYPE_CHECKING:
    from viscodesign.pump.plunger.plunger_demand import PlungerDemand


def plunger_faults(scene: Scene) -> Iterator[tuple[str, str]]:
    """Keys of a scene that keep a syringe from being planned, each with what to correct."""
    pump, inlets, fluid = scene.pump, list(scene.inputs), scene.fluid
    assert isinstance(pump, ServoPumpSpec), "a plunger's section"
    if isinstance(pump.servo_id, int) and len(inlets) > 1:
        ids = ", ".join(f"{name}: {k}" for k, name in enumerate(inlets, start=1))
        yield (
            "pump.servo_id",
            (
                f"{pump.servo_id} is one servo for {len(inlets)} inlets; give each its own, like "
                f"{{{ids}}}"
            ),
        )
    if not fluid.is_gas and fluid.bulk_modulus is None:
        yield (
            "fluid",
            (
                f"the stiffness of {fluid.name}, which the pump pushes, is unknown; give "
                "viscosity, density and gas_constant or bulk_modulus under fluid"
            ),
        )
    if (drive := Drive(pump)).filled_at_home <= 0.0:
        yield (
            "pump.syringe_stroke",
            (
                f"{1e3 * pump.syringe_stroke:.4g} mm is not enough: from home ({pump.home} counts) "
                f"the travel {list(pump.travel)} draws the plunger out by "
                f"{-1e3 * drive.range[0]:.4g} mm. "
                "Use a longer syringe, a smaller pinion_diameter or a shorter travel, or state "
                "filled_length"
            ),
        )
    elif drive.filled_at_home > pump.syringe_stroke:
        yield (
            "pump.filled_length",
            (
                f"{1e3 * drive.filled_at_home:.4g} mm are longer than pump.syringe_stroke, the "
                f"whole barrel of {1e3 * pump.syringe_stroke:.4g} mm"
            ),
        )


def plunger_numbers(demand: PlungerDemand) -> dict[str, float]:
    """What the drive of an inlet is, and what the plan takes of it."""
    pump, drive, barrel = demand.pump, demand.drive, demand.barrel
    slow = barrel.compliance(demand.scene.gauge_pressure, 0.0) + _network_compliance(demand)
    fast = demand.least_compliance
    speed, torque = (float(np.max(np.abs(v))) for v in (demand.velocity, demand.torque))
    return {
        "stall_pressure_pa_gauge": drive.stall_pressure,
        "steady_pressure_pa_gauge": STEADY_SHARE * drive.stall_pressure,
        "no_load_flow_m3_s": float(drive.speed_left(0.0)) * drive.area,
        "travel_volume_m3": (pump.travel[1] - pump.travel[0]) * drive.volume_per_count,
        "volume_per_count_m3": drive.volume_per_count,
        "counts_per_ml": 1e-6 / drive.volume_per_count,
        "counts_per_kpa_fast": 1e3 * fast / drive.volume_per_count,
        "counts_per_kpa_slow": 1e3 * slow / drive.volume_per_count,
        "kpa_per_count_fast": 1e-3 * drive.volume_per_count / fast,
        "filled_length_m": drive.filled_at_home,
        "highest_pressure_pa_gauge": float(demand.pressure.max()),
        "lowest_pressure_pa_gauge": float(demand.pressure.min()),
        "largest_torque_nm": torque,
        "largest_flow_m3_s": speed * drive.area,
        "largest_current_a": float(drive.current(torque)),
        "mean_current_a": demand.mean_current,
        "fastest_speed_register": float(drive.speed_register(speed)),
        "lead_in_s": demand.lead_s,
    }


def plunger_words(demand: PlungerDemand) -> list[tuple[str, str]]:
    """The drive for people: a heading and a sentence each."""
    n = demand.numbers()
    pressures = ("stall", "steady", "lowest", "highest")
    kpa = {name: n[f"{name}_pressure_pa_gauge"] / 1e3 for name in pressures}
    ids = dict(zip(demand.scene.inputs, demand.pump.axes(len(demand.scene.inputs)), strict=True))
    return [
        ("drive", f"{demand.device}, id {ids[demand.inlet]}, for the inlet '{demand.inlet}'"),
        ("stall", f"{kpa['stall']:.4g} kPa gauge; a fifth of it is {kpa['steady']:.3g} kPa"),
        (
            "counts",
            f"{n['counts_per_ml']:.3g} per mL; per kPa {n['counts_per_kpa_fast']:.3g} at first, "
            f"{n['counts_per_kpa_slow']:.3g} once the actuator has followed",
        ),
        (
            "travel",
            f"{1e6 * n['travel_volume_m3']:.3g} mL; {1e3 * n['filled_length_m']:.4g} mm of the "
            "barrel filled at home",
        ),
        (
            "needs",
            f"{kpa['lowest']:.4g} to {kpa['highest']:.4g} kPa gauge, "
            f"{n['largest_torque_nm']:.3g} N m, {1e6 * n['largest_flow_m3_s']:.3g} mL/s, "
            f"{n['largest_current_a']:.3g} A",
        ),
        ("lead-in", f"{n['lead_in_s']:.3g} s from home to the pressure of the start"),
    ]


def _network_compliance(demand: PlungerDemand) -> float:
    """Of all bellows that an inlet feeds, wall and gas, by the linear law [m3/Pa]."""
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
