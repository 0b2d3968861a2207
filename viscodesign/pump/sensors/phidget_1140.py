"""The Phidgets 1140, an absolute gas pressure sensor from 20 to 400 kPa.

kPa = ratio / 0.002421 + 3.478, with ratio = output over supply. Source: the vendor's library
(phidget22 3.26, sensor type 1140), whose figures agree with its sensing element, MPXH6400A;
that one's data sheet gives 1.5 % of span as its error, 0 to 85 degC, and 0.2 to 4.8 V at 5 V.
"""

from __future__ import annotations

SLOPE = 0.002421 / 1e3
"""Ratio for a pascal."""
OFFSET = 3.478e3
"""[Pa]"""
LOWEST = 20e3
HIGHEST = 400e3
"""Absolute [Pa], between which it is valid."""
ACCURACY = 5.7e3
"""[Pa]"""
LOWEST_RATIO = 20 / 1024
HIGHEST_RATIO = 1003 / 1024
"""Beyond these the sensor is open or shorted."""


def absolute_pressure(ratio: float) -> float:
    """[Pa]"""
    return ratio / SLOPE + OFFSET


def ratio_of(pressure: float) -> float:
    """Of an absolute pressure [Pa]."""
    return (pressure - OFFSET) * SLOPE
