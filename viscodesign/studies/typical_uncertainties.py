"""What is assumed of coefficients that a spec does not say how well it knows.

Guesses by kind, rounded and on the safe side, for a first answer; `uncertainty` replaces them key
by key. They stand for castings and measurements of one laboratory, and are labelled wherever they
are used.
"""

from __future__ import annotations

from viscodesign.compiled.free_keys import EVERY, TUBE_SIZES
from viscodesign.scene.scene import Scene

TYPICAL = {
    # Of a batch of elastomer, as it cures.
    "actuator.youngs_modulus": "10 %",
    "actuator.damping_time": "50 %",
    "actuator.density": "2 %",
    # Of a casting.
    "actuator.solid_fraction": "3 %",
    "bellows.height": "2 %",
    "bellows.width": "2 %",
    "network.tube_length": "1 %",
    # Of an extruded tube, whose resistance goes with the fourth power.
    "network.tube_radius": "3 %",
    # Of coefficients that are measured or computed of one actuator.
    "actuator.extension_factor": "10 %",
    "actuator.bending_factor": "10 %",
    "actuator.shear_factor": "20 %",
    "bellows.area_per_pressure": "10 %",
    "bellows.angle_per_pressure": "10 %",
    "bellows.extension_per_pressure": "10 %",
    "bellows.area_per_force": "20 %",
    "bellows.area_per_moment": "20 %",
    "fluid.viscosity": "5 %",
}
"""Standard deviations by key."""


def typical_of(scene: Scene, stated: set[str]) -> dict[str, str]:
    """Those of the coefficients that a scene has and does not state.

    Who states a size of all tubes, one by one, states that of the tubes.
    """
    sizes = {f"network.tubes[{EVERY}].{size}": f"network.tube_{size}" for size in TUBE_SIZES}
    stated = stated | {shared for each, shared in sizes.items() if each in stated}
    network, actuator = scene.network, scene.actuator
    absent = {
        "network.tube_length": network.tube_length is None,
        "network.tube_radius": network.tube_radius is None,
        "actuator.shear_factor": actuator.shear_factor is None,
    }
    return {
        key: spread
        for key, spread in TYPICAL.items()
        if key not in stated and not absent.get(key, False)
    }
