"""An AX servo that moves a plunger by rack and pinion: what it can do, in closed form."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol.registers import COUNTS_PER_TURN, SPEED_UNIT, speed_register
from viscodesign.pump.drive import Load, PlungerDrive
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.pumps.servo_motor import SERVOS, ServoType


@dataclass(frozen=True)
class ServoDrive(PlungerDrive):
    """Servo, pinion and plunger; a step is a count. Torques are positive where it pushes in."""

    step_name: ClassVar[str] = "count"
    gear_key: ClassVar[str] = "pinion_diameter"

    pump: ServoPumpSpec

    @property
    def servo(self) -> ServoType:
        """The servo's data."""
        return SERVOS[self.pump.servo]

    @property
    def radius(self) -> float:
        """Pitch radius of the pinion [m]."""
        return self.pump.pinion_diameter / 2

    @property
    def step(self) -> float:
        return math.pi * self.pump.pinion_diameter / COUNTS_PER_TURN

    @property
    def load(self) -> Load:
        return Load("torque", "N m", "nm", self.radius)

    @property
    def play(self) -> float:
        return self.pump.gear_play

    @property
    def stall_words(self) -> str:
        return f"stall torque at {self.pump.supply_voltage:g} V"

    def torque(self, pressure: Any, direction: Any = 0.0) -> Any:
        """Torque at the pinion that balances the plunger [N m]: a rigid gear without losses.

        ``pressure`` and ``direction`` as for `force`.
        """
        return self.force(pressure, direction) * self.radius

    @property
    def stall_load(self) -> float:
        r"""Torque at which the servo stalls at the supply voltage [N m].

        .. math:: \tau_V = \tau_s V / V_0

        Constant motor resistance: current and torque at stall follow the voltage.
        """
        return self.servo.stall_torque * self.pump.supply_voltage / self.servo.rated_voltage

    def speed_left(self, force: Any) -> Any:
        r"""Plunger speed that the servo still has against a force [m/s]; zero beyond its stall.

        .. math:: v = r \omega_0 (V / V_0 - F r / \tau_s)

        The straight line of a motor of constant flux. A force that helps (negative) makes it
        no faster than it is without load: the servo holds its speed.
        """
        voltage = self.pump.supply_voltage / self.servo.rated_voltage
        share = np.maximum(force * self.radius, 0.0) / self.servo.stall_torque
        return self.servo.no_load_speed * np.maximum(voltage - share, 0.0) * self.radius

    @property
    def speed_step(self) -> float:
        """Resolution of the plunger speeds that the servo can be set to [m/s]."""
        return 2 * math.pi * SPEED_UNIT * self.radius

    def speed_register(self, speed: float) -> int:
        """The value of Moving Speed that a stream would send for a plunger speed [m/s]."""
        return speed_register(speed / (2 * math.pi * self.radius))

    def current(self, torque: Any) -> Any:
        r"""Current that a torque draws, without electronics [A]: :math:`I_s |\tau| / \tau_s`."""
        return self.servo.stall_current * np.abs(torque) / self.servo.stall_torque

    def battery_life(self, current: float) -> float:
        """Time in which a mean current [A] empties the battery [s]; infinite without any."""
        return self.pump.battery_capacity / current if current > 0.0 else math.inf
