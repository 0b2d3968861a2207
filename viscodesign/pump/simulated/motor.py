"""What turns a servo: its motor and gear against a load.

Torque and speed lie on a straight line between stall and no load, and scale with the supply
(figures at 12 V: ROBOTIS e-manual, AX-12A and AX-18A). The manual does not give friction, heating
and cooling: they are assumed.
"""

from __future__ import annotations

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol.registers import COUNT_ANGLE
from viscodesign.scene.pumps.servo_motor import SERVOS

NOMINAL_VOLTAGE = 12.0


@dataclass(frozen=True)
class Motor:
    """The motor of a type of servo, at 12 V."""

    stall_torque: float
    """[N m]"""
    no_load_speed: float
    """[counts/s]"""
    friction: float = 0.1
    """Friction of gear and plunger [N m]."""
    heating: float = 1.0
    """Rate at which the case heats at stall [K/s]."""
    cooling_time: float = 300.0
    """[s]"""

    def speed(self, output: float, voltage: float, load: float) -> float:
        """Speed [counts/s] at an ``output`` of -1 to 1 of what the supply gives.

        ``load``: torque that pushes towards higher counts [N m].
        """
        torque = output * self.stall_torque * voltage / NOMINAL_VOLTAGE + load
        if abs(torque) <= self.friction:
            return 0.0
        excess = torque - self.friction if torque > 0.0 else torque + self.friction
        return self.no_load_speed * excess / self.stall_torque

    def output(self, speed: float, voltage: float, load: float) -> float:
        """Output at which it turns at a speed that is not zero; the inverse of `speed`."""
        friction = self.friction if speed > 0.0 else -self.friction
        torque = speed / self.no_load_speed * self.stall_torque + friction - load
        return torque / (self.stall_torque * voltage / NOMINAL_VOLTAGE)


MOTORS = {
    servo.model: Motor(servo.stall_torque, servo.no_load_speed / COUNT_ANGLE)
    for servo in SERVOS.values()
}
"""By model number."""
