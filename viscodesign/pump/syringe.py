"""A plunger that a servo moves by rack and pinion: what it can do, in closed form.

Pressures are gauge: the ambient pushes on the plunger's other side.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from viscodesign.pump.servo_motor import COUNT_ANGLE, LARGEST_SPEED, SPEED_UNIT, ServoType


def barrel_area(diameter: float) -> float:
    r"""Cross section of a barrel [m2].

    .. math:: A = \pi d^2 / 4
    """
    return math.pi * diameter**2 / 4


def shaft_torque(
    pressure: Any, diameter: float, pinion_diameter: float, friction: Any = 0.0
) -> Any:
    r"""Torque at the pinion that balances a plunger [N m], positive where the servo pushes in.

    .. math:: \tau = (p A + F) r, \quad r = d_p / 2

    ``pressure`` p gauge [Pa], ``diameter`` of the barrel [m], ``pinion_diameter`` d_p [m], the
    pitch diameter; ``friction`` F [N] of the plunger, positive where it moves in, negative
    where it moves out, zero where it stands. A rigid gear without losses.
    """
    return (pressure * barrel_area(diameter) + friction) * pinion_diameter / 2


def stall_torque(servo: ServoType, voltage: float) -> float:
    r"""Torque at which a servo stalls [N m].

    .. math:: \tau_V = \tau_s V / V_0

    A motor with a constant resistance: current at stall, and torque with it, follow the
    voltage. ``voltage`` V [V]; V_0 is the rated one.
    """
    return servo.stall_torque * voltage / servo.rated_voltage


def stall_pressure(
    servo: ServoType, voltage: float, diameter: float, pinion_diameter: float
) -> float:
    r"""Gauge pressure at which a pump stalls [Pa], without friction.

    .. math:: p = \tau_V / (r A)
    """
    return stall_torque(servo, voltage) * 2 / (pinion_diameter * barrel_area(diameter))


def speed_left(servo: ServoType, voltage: float, torque: Any) -> Any:
    r"""Speed that a servo still has against a torque [rad/s]; zero beyond its stall.

    .. math:: \omega = \omega_0 (V / V_0 - \tau / \tau_s)

    The straight line of a motor of constant flux. A torque that helps (negative) makes it
    no faster than it is without load: the servo holds its speed.
    """
    share = np.maximum(torque, 0.0) / servo.stall_torque
    return servo.no_load_speed * np.maximum(voltage / servo.rated_voltage - share, 0.0)


def flow_rate(speed: Any, diameter: float, pinion_diameter: float) -> Any:
    r"""Volume that a plunger sweeps in a time [m3/s].

    .. math:: Q = \omega r A
    """
    return speed * pinion_diameter / 2 * barrel_area(diameter)


def advance_per_count(pinion_diameter: float) -> float:
    r"""Travel of the rack in one count of the servo [m].

    .. math:: \Delta x = r \Delta\varphi, \quad \Delta\varphi = 300^\circ / 1024
    """
    return pinion_diameter / 2 * COUNT_ANGLE


def counts_per_volume(diameter: float, pinion_diameter: float) -> float:
    """Counts of the servo for a volume [1/m3]: the finest step is one over it."""
    return 1 / (barrel_area(diameter) * advance_per_count(pinion_diameter))


def counts_per_pressure(compliance: float, diameter: float, pinion_diameter: float) -> float:
    r"""Counts of the servo for a pressure [1/Pa].

    .. math:: n = C / (A \Delta x)

    ``compliance`` C [m3/Pa] of all that yields, barrel, line and actuator, near a pressure.
    """
    return compliance * counts_per_volume(diameter, pinion_diameter)


def servo_current(servo: ServoType, torque: Any) -> Any:
    r"""Current that a torque takes [A].

    .. math:: I = I_s |\tau| / \tau_s

    In proportion, as in a motor of constant flux; what its electronics take is left out.
    """
    return servo.stall_current * np.abs(torque) / servo.stall_torque


def battery_life(capacity: float, current: float) -> float:
    """Time in which a mean current [A] empties a capacity [C]; infinite without any [s]."""
    return capacity / current if current > 0.0 else math.inf


def speed_register(speed: float) -> int:
    """What to write into Moving Speed for a speed [rad/s].

    Never 0, which would be full speed: what is slower than one unit takes one.
    """
    return min(max(round(abs(speed) / SPEED_UNIT), 1), LARGEST_SPEED)
