"""What the numbers of such actuators are: the one table of usual and of possible ranges.

A number outside of its usual range gets a warning with the likely slip, one outside of the
possible range is refused. Ranges are wide on purpose: they catch slips of prefix, unit and
exponent, and judge no design. `PAPER` is the actuator of the paper, 109 mm long with sixteen
bellows. The bounds are our choice: round numbers around what the words of each range name, taken
from no table.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from viscodesign.lazy_dataclass import dataclass

PAPER = "the paper's leg and its pump, from far smaller ones to a few metres"
CHANNELS = "the paper's tubes, from capillaries of microfluidics to hoses"
ELASTOMERS = "gels of silicone (some kPa) to the hardest polyurethanes and nylons (some 100 MPa)"
TUBE_WALLS = "soft silicone (some 100 kPa) to steel (200 GPa)"
FLUIDS = "gases (hydrogen 9e-6 Pa*s) to syrups and honey (10 Pa*s)"
LIQUID_METALS = "foams to elastomers filled with metal"
BULK_MODULI = "liquids with bubbles (some 10 MPa) to mercury (25 GPa)"
ROOM = "where elastomers are elastic, between glass transition and decay"
GASES = "sulphur hexafluoride (57) to hydrogen (4124 J/(kg*K))"
PRESSURES = "high balloons (1 kPa) to pressure vessels and the sea at 1 km (10 MPa)"
KELVIN_VOIGT = (
    "elastomers that ring (some us) to memory foams (a loss factor of 1 at 1 Hz is 0.16 s)"
)
HOLLOW = "thin bellows of which a hundredth is solid, to bodies stiffer than a solid one by ribs"
RATIOS = "foams (0.1) to rubber (0.5)"
LOSSES = "rounded edges (0.04) to screens and orifices (10)"
GRAVITY = "small moons to centrifuges"
WHOLE = "experiments, from a millisecond to a week"
TURNS = "one turn either way"
SYRINGES = "syringes of 10 uL to 1 L"
SERVOS = "small servos with rack and pinion"
VOLTAGES = "two cells to four (the servos are made for 9 to 12 V)"
BATTERIES = "a coin cell (10 mAh) to a car's (100 Ah)"
REGULATORS = "electro-pneumatic regulators of 1 kPa to 5 MPa"
FRICTION = "polished surfaces (0.02) to soft rubber (3)"
CAPS = "what a glass or plastic syringe holds"


@dataclass(frozen=True)
class PlausibleRange:
    """The range of a key's numbers, in SI. Every tube or input of a spec has those of its kind:
    their names or numbers are `*` in the key.
    """

    key: str
    unit: str
    low: float
    high: float
    source: str
    slips: tuple[float | str, ...] = (1e-3, 1e-6, 1e-9, 1e3, 1e6, 1e9)
    """Likely factors of a slip, the likeliest first; or 'exponent' (a lost sign), 'celsius',
    'degrees'."""
    possible: tuple[float, float] = (0.0, math.inf)
    """Outside of it no matter is, and nothing could be built."""
    either_sign: bool = False
    """Whether the bounds are those of the size."""
    or_none: bool = False
    """Whether zero is usual, too."""
    whose: str = "such actuators have"
    """What has such numbers."""
    requirement: str = ""
    """What a number must do, where its range in words would be no help."""

    def holds(self, value: float) -> bool:
        """Whether a number is a usual one."""
        size = abs(value) if self.either_sign else value
        return (self.or_none and value == 0.0) or self.low <= size <= self.high


_LENGTH = (1e-3, 1e-9, 1e-6, 1e3)
"""Bare millimetres, Mm for mm, bare micrometres, kilometres."""
_LONGEST = (0.0, 1e6)
"""A tube of 12 km is solved like any other; beyond, the unit is wrong."""
_STIFF = (1e9, 1e3, 1e-3, 1e6, 1e-6)
"""mPa for MPa, kPa for MPa, GPa for MPa, bare MPa."""
_FLUID = ("exponent", 1e-3, 1e3, 1e-6)
_PERCENT = (1e-2, 1e2)
"""A number of percent without its sign, and the other way round."""
_ANGLE = ("degrees", 1e-3)
ANY = (-math.inf, math.inf)
"""No value is impossible: a large one is solved like any other."""


def _length(key: str, low: float, high: float, source: str) -> PlausibleRange:
    return PlausibleRange(key, "m", low, high, source, _LENGTH, _LONGEST)


def _share(
    key: str, low: float, high: float, source: str = HOLLOW, *, or_none: bool = False
) -> PlausibleRange:
    return PlausibleRange(key, "", low, high, source, _PERCENT, or_none=or_none)


def _tubes() -> Iterator[PlausibleRange]:
    """Ranges of tubes, alike, changed or listed; a pump's hoses may be longer than a body's."""
    for key in ("tube_radius", "changes.*.radius", "tubes.*.radius", "feed_line.radius"):
        yield _length(f"network.{key}", 2e-6, 0.02, CHANNELS)
    for key in ("tube_length", "changes.*.length", "tubes.*.length"):
        yield _length(f"network.{key}", 2e-4, 10.0, CHANNELS)
    yield _length("network.feed_line.length", 2e-3, 100.0, CHANNELS)
    yield PlausibleRange("network.tube_wall.youngs_modulus", "Pa", 1e4, 3e11, TUBE_WALLS, _STIFF)
    yield _length("network.tube_wall.thickness", 5e-6, 0.02, CHANNELS)
    yield _share("network.tube_wall.poissons_ratio", 0.02, 0.5, RATIOS, or_none=True)
    for key in ("entrance_loss", "exit_loss"):
        yield _share(f"network.{key}", 0.01, 10.0, LOSSES, or_none=True)


def _ground() -> Iterator[PlausibleRange]:
    """Ranges of a surface beside the actuator, and of the tip that touches it."""
    for key in ("point.x", "point.z", "centre.x", "centre.z"):
        where = f"loads.ground.{key}"
        yield PlausibleRange(
            where, "m", 1e-3, 3.0, PAPER, _LENGTH, ANY, either_sign=True, or_none=True
        )
    yield PlausibleRange("loads.ground.normal", "rad", -6.3, 6.3, TURNS, _ANGLE, ANY)
    yield _length("loads.ground.radius", 1e-4, 3.0, PAPER)
    yield PlausibleRange("loads.ground.foot_radius", "m", 1e-4, 0.3, PAPER, _LENGTH, or_none=True)
    yield _share("loads.ground.friction", 0.02, 3.0, FRICTION, or_none=True)


def _pump() -> Iterator[PlausibleRange]:
    yield _length("pump.syringe_diameter", 4e-4, 0.15, SYRINGES)
    yield _length("pump.syringe_stroke", 2e-3, 0.5, SYRINGES)
    yield _length("pump.filled_length", 1e-3, 0.5, SYRINGES)
    yield _length("pump.pinion_diameter", 2e-3, 0.2, SERVOS)
    yield PlausibleRange("pump.supply_voltage", "V", 6.0, 16.0, VOLTAGES)
    yield PlausibleRange(
        "pump.dead_volume", "m^3", 1e-8, 1e-3, SYRINGES, (1e-3, 1e-6, 1e3), or_none=True
    )
    yield PlausibleRange("pump.battery_capacity", "A*s", 30.0, 4e5, BATTERIES, (3.6, 1e3, 1e-3))
    yield PlausibleRange("pump.plunger_friction", "N", 0.02, 200.0, SERVOS, or_none=True)
    yield PlausibleRange("pump.gear_play", "counts", 0.0, 30.0, SERVOS, _PERCENT)
    yield PlausibleRange("pump.max_pressure", "Pa", 300.0, 2e6, CAPS)
    yield PlausibleRange("pump.full_scale", "Pa", 1e3, 5e6, REGULATORS)
    yield PlausibleRange("pump.rate_limit", "Pa/s", 500.0, 2e7, REGULATORS)
    yield PlausibleRange("pump.response_time", "s", 1e-3, 20.0, REGULATORS, or_none=True)
    yield _share("pump.error", 1e-4, 0.5, REGULATORS)
    yield _share("pump.following_error", 2e-3, 1.0, REGULATORS)


RANGES = (
    _length("actuator.length", 1e-3, 3.0, PAPER),
    _length("actuator.height", 3e-4, 1.0, PAPER),
    _length("actuator.width", 2e-4, 1.0, PAPER),
    PlausibleRange("actuator.youngs_modulus", "Pa", 2e3, 5e8, ELASTOMERS, _STIFF, (0.0, 2e12)),
    PlausibleRange("actuator.density", "kg/m^3", 20.0, 8e3, LIQUID_METALS, (1e3, 1e-3)),
    _share("actuator.solid_fraction", 0.02, 1.0),
    _share("actuator.extension_factor", 2e-3, 3.0),
    _share("actuator.bending_factor", 2e-3, 3.0),
    _share("actuator.shear_factor", 2e-3, 3.0),
    PlausibleRange(
        "actuator.damping_time", "s", 2e-6, 0.3, KELVIN_VOIGT, (1e-3, 1e-6, 1e3), or_none=True
    ),
    _length("bellows.height", 1e-4, 0.3, PAPER),
    _length("bellows.width", 1e-4, 0.3, PAPER),
    _length("bellows.length", 1e-4, 0.5, PAPER),
    _share("bellows.collapse_fraction", 1e-3, 0.8, or_none=True),
    *_tubes(),
    PlausibleRange("fluid.viscosity", "Pa*s", 5e-6, 100.0, FLUIDS, _FLUID),
    PlausibleRange("fluid.density", "kg/m^3", 0.02, 2e4, FLUIDS, (1e3, 1e-3), (0.0, 1e6)),
    PlausibleRange("fluid.gas_constant", "J/(kg*K)", 30.0, 4.2e3, GASES, (1e3, 1e-3)),
    PlausibleRange("fluid.bulk_modulus", "Pa", 1e7, 3e10, BULK_MODULI, _STIFF),
    PlausibleRange("temperature", "K", 233.15, 473.15, ROOM, ("celsius",), (1.0, 5e3)),
    PlausibleRange("ambient_pressure", "Pa", 1e3, 1e7, PRESSURES, (1e3, 1e2, 1e5)),
    PlausibleRange(
        "loads.gravity.acceleration", "m/s^2", 0.05, 1e3, GRAVITY, (1e-3, 1e3), or_none=True
    ),
    PlausibleRange("loads.gravity.tilt", "rad", -6.3, 6.3, TURNS, _ANGLE, ANY),
    PlausibleRange("run.duration", "s", 1e-6, 1e6, WHOLE, (1e-3, 1e3)),
    PlausibleRange("inputs.*.phase", "rad", -12.6, 12.6, TURNS, _ANGLE, ANY),
    *_ground(),
    *_pump(),
)
