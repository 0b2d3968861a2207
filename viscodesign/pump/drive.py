"""A plunger that a servo moves by rack and pinion: what it can do, in closed form."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.pumps.servo_motor import LARGEST_SPEED, SERVOS, SPEED_UNIT, ServoType

COUNTS_PER_TURN = 1024 * 360.0 / 300.0
"""The servo's 1024 counts span 300 degrees (e-manual of AX-12A and AX-18A, Goal Position)."""


@dataclass(frozen=True)
class Drive:
    """Servo, pinion and barrel of one plunger.

    Positions are pushed in from home, positive towards the outlet. Pressures are gauge: the
    ambient pushes on the plunger's other side. Torques are positive where the servo pushes in.
    """

    pump: ServoPumpSpec

    @property
    def servo(self) -> ServoType:
        """The servo's data."""
        return SERVOS[self.pump.servo]

    @property
    def area(self) -> float:
        """Cross section of the barrel [m2]."""
        return math.pi * self.pump.syringe_diameter**2 / 4

    @property
    def radius(self) -> float:
        """Pitch radius of the pinion [m]."""
        return self.pump.pinion_diameter / 2

    @property
    def advance_per_count(self) -> float:
        """Travel of the rack per count [m]; positive whichever way counts push."""
        return math.pi * self.pump.pinion_diameter / COUNTS_PER_TURN

    @property
    def volume_per_count(self) -> float:
        """Volume swept per count, the finest step [m3]."""
        return self.area * self.advance_per_count

    @property
    def _sign(self) -> int:
        return 1 if self.pump.push == "up" else -1

    def position(self, count: float) -> float:
        """Plunger position [m] at a servo count."""
        return self._sign * (count - self.pump.home) * self.advance_per_count

    def count(self, position: float) -> float:
        """Servo count, not rounded, at a plunger position [m]."""
        return self.pump.home + self._sign * position / self.advance_per_count

    @property
    def range(self) -> tuple[float, float]:
        """Plunger positions at the ends of travel, withdrawn first [m]."""
        low, high = sorted(self.position(count) for count in self.pump.travel)
        return low, high

    @property
    def filled_at_home(self) -> float:
        """Length of barrel in front of the plunger at home [m]."""
        stated = self.pump.filled_length
        return self.pump.syringe_stroke + self.range[0] if stated is None else stated

    def torque(self, pressure: Any, direction: Any = 0.0) -> Any:
        r"""Torque at the pinion that balances the plunger [N m].

        .. math:: \tau = (p A + F d) r

        ``pressure`` p gauge [Pa]; ``direction`` d is 1 where the plunger moves in against its
        friction F, -1 where it moves out, 0 at rest. A rigid gear without losses.
        """
        friction = self.pump.plunger_friction * direction
        return (pressure * self.area + friction) * self.radius

    @property
    def stall_torque(self) -> float:
        r"""Torque at which the servo stalls at the supply voltage [N m].

        .. math:: \tau_V = \tau_s V / V_0

        Constant motor resistance: current and torque at stall follow the voltage.
        """
        return self.servo.stall_torque * self.pump.supply_voltage / self.servo.rated_voltage

    @property
    def stall_pressure(self) -> float:
        r"""Gauge pressure at which the pump stalls, without friction [Pa]: :math:`\tau_V/(r A)`."""
        return self.stall_torque / (self.radius * self.area)

    def speed_left(self, torque: Any) -> Any:
        r"""Plunger speed that the servo still has against a torque [m/s]; zero beyond its stall.

        .. math:: v = r \omega_0 (V / V_0 - \tau / \tau_s)

        The straight line of a motor of constant flux. A torque that helps (negative) makes it
        no faster than it is without load: the servo holds its speed.
        """
        voltage = self.pump.supply_voltage / self.servo.rated_voltage
        share = np.maximum(torque, 0.0) / self.servo.stall_torque
        return self.servo.no_load_speed * np.maximum(voltage - share, 0.0) * self.radius

    def speed_register(self, speed: float) -> int:
        """Nearest value of Moving Speed for a plunger speed [m/s]; never 0, which is full speed."""
        return min(max(round(abs(speed) / self.radius / SPEED_UNIT), 1), LARGEST_SPEED)

    def current(self, torque: Any) -> Any:
        r"""Current that a torque draws, without electronics [A]: :math:`I_s |\tau| / \tau_s`."""
        return self.servo.stall_current * np.abs(torque) / self.servo.stall_torque

    def battery_life(self, current: float) -> float:
        """Time in which a mean current [A] empties the battery [s]; infinite without any."""
        return self.pump.battery_capacity / current if current > 0.0 else math.inf
