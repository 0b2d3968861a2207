"""What the numbers of such actuators are: the one table of usual and of possible ranges.

A number outside of its usual range gets a warning with the likely slip, one outside of the
possible range is refused. Ranges are wide on purpose: they catch slips of prefix, unit and
exponent, and judge no design. `PAPER` is the actuator of the paper, 109 mm long with sixteen
bellows. The bounds are our choice: round numbers around what the words of each range name, taken
from no table.
"""

from __future__ import annotations

from viscodesign.lazy_dataclass import dataclass

PAPER = "the paper's leg and its pump, from far smaller ones to a few metres"
CHANNELS = "the paper's tubes, from capillaries of microfluidics to hoses"
ELASTOMERS = "gels of silicone (some kPa) to the hardest polyurethanes and nylons (some 100 MPa)"
TUBE_WALLS = "soft silicone (some 100 kPa) to steel (200 GPa)"
FLUIDS = "gases (hydrogen 9e-6 Pa*s) to syrups and honey (10 Pa*s)"
LIQUID_METALS = "foams to elastomers filled with metal"
BULK_MODULI = "liquids with bubbles (some MPa) to mercury (25 GPa)"
ROOM = "where elastomers are elastic, between glass transition and decay"
GASES = "sulphur hexafluoride (57) to hydrogen (4124 J/(kg*K))"
PRESSURES = "high balloons (1 kPa) to pressure vessels and the sea at 1 km (10 MPa)"
KELVIN_VOIGT = "elastomers that ring (some us) to memory foams (some s)"
HOLLOW = "thin bellows of which a hundredth is solid, to bodies stiffer than a solid one by ribs"
WHOLE = "experiments, from a millisecond to a week"


@dataclass(frozen=True)
class PlausibleRange:
    """The range of a key's numbers, in SI."""

    key: str
    unit: str
    low: float
    high: float
    source: str
    slips: tuple[float | str, ...] = (1e-3, 1e-6, 1e-9, 1e3, 1e6, 1e9)
    """Likely factors of a slip, the likeliest first; or 'exponent' (a lost sign), 'celsius'."""
    possible: tuple[float, float] = (0.0, float("inf"))
    """Outside of it no matter is, and nothing could be built."""


_LENGTH = (1e-3, 1e-9, 1e-6, 1e3)
"""Bare millimetres, Mm for mm, bare micrometres, kilometres."""
_LONGEST = (0.0, 1e6)
"""A tube of 12 km is solved like any other; beyond, the unit is wrong."""
_STIFF = (1e9, 1e3, 1e-3, 1e6, 1e-6)
"""mPa for MPa, kPa for MPa, GPa for MPa, bare MPa."""
_FLUID = ("exponent", 1e-3, 1e3, 1e-6)

_PERCENT = (1e-2, 1e2)
"""A number of percent without its sign, and the other way round."""

RANGES = (
    PlausibleRange("actuator.length", "m", 1e-3, 3.0, PAPER, _LENGTH, _LONGEST),
    PlausibleRange("actuator.height", "m", 3e-4, 1.0, PAPER, _LENGTH, _LONGEST),
    PlausibleRange("actuator.width", "m", 2e-4, 1.0, PAPER, _LENGTH, _LONGEST),
    PlausibleRange("actuator.youngs_modulus", "Pa", 2e3, 5e8, ELASTOMERS, _STIFF, (0.0, 2e12)),
    PlausibleRange("actuator.density", "kg/m^3", 20.0, 8e3, LIQUID_METALS, (1e3, 1e-3)),
    PlausibleRange("actuator.solid_fraction", "", 0.02, 1.0, HOLLOW, _PERCENT),
    PlausibleRange("actuator.extension_factor", "", 2e-3, 3.0, HOLLOW, _PERCENT),
    PlausibleRange("actuator.bending_factor", "", 2e-3, 3.0, HOLLOW, _PERCENT),
    PlausibleRange("bellows.collapse_fraction", "", 0.0, 0.8, HOLLOW, _PERCENT),
    PlausibleRange("actuator.damping_time", "s", 0.0, 10.0, KELVIN_VOIGT, (1e-3, 1e-6)),
    PlausibleRange("bellows.height", "m", 1e-4, 0.3, PAPER, _LENGTH, _LONGEST),
    PlausibleRange("bellows.width", "m", 1e-4, 0.3, PAPER, _LENGTH, _LONGEST),
    PlausibleRange("bellows.length", "m", 1e-4, 0.5, PAPER, _LENGTH, _LONGEST),
    PlausibleRange("network.tube_radius", "m", 2e-6, 0.02, CHANNELS, _LENGTH, _LONGEST),
    PlausibleRange("network.tube_length", "m", 1e-5, 100.0, CHANNELS, _LENGTH, _LONGEST),
    PlausibleRange("network.feed_line.radius", "m", 2e-6, 0.02, CHANNELS, _LENGTH, _LONGEST),
    PlausibleRange("network.feed_line.length", "m", 1e-5, 100.0, CHANNELS, _LENGTH, _LONGEST),
    PlausibleRange("network.tube_wall.youngs_modulus", "Pa", 1e4, 3e11, TUBE_WALLS, _STIFF),
    PlausibleRange("network.tube_wall.thickness", "m", 1e-6, 0.02, CHANNELS, _LENGTH, _LONGEST),
    PlausibleRange("fluid.viscosity", "Pa*s", 5e-6, 100.0, FLUIDS, _FLUID),
    PlausibleRange("fluid.density", "kg/m^3", 0.02, 2e4, FLUIDS, (1e3, 1e-3), (0.0, 1e6)),
    PlausibleRange("fluid.gas_constant", "J/(kg*K)", 30.0, 4.2e3, GASES, (1e3, 1e-3)),
    PlausibleRange("fluid.bulk_modulus", "Pa", 1e6, 3e10, BULK_MODULI, _STIFF),
    PlausibleRange("temperature", "K", 233.15, 473.15, ROOM, ("celsius",), (1.0, 5e3)),
    PlausibleRange("ambient_pressure", "Pa", 1e3, 1e7, PRESSURES, (1e3, 1e2, 1e5)),
    PlausibleRange("run.duration", "s", 1e-6, 1e6, WHOLE, (1e-3, 1e3)),
)
