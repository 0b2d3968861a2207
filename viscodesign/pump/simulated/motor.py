"""What turns a servo: its motor and gear against a load.

Torque and speed lie on a straight line between stall and no load, and scale with the
supply (figures at 12 V: ROBOTIS e-manual, AX-12A and AX-18A). Friction, and what heat the
windings take and give, are assumptions: the manual is silent about them.
"""

from __future__ import annotations

from dataclasses import dataclass

from viscodesign.pump.servo_motor import COUNT_ANGLE, SERVOS

NOMINAL_VOLTAGE = 12.0


@dataclass(frozen=True)
class Motor:
    """A kind of servo."""

    stall_torque: float
    """At 12 V [N m]."""
    no_load_speed: float
    """At 12 V [counts/s]."""
    friction: float = 0.1
    """Of gear and plunger [N m]; assumed."""
    heating: float = 1.0
    """Of the case, at stall [K/s]; assumed."""
    cooling_time: float = 300.0
    """[s]; assumed."""

    def speed(self, output: float, voltage: float, load: float) -> float:
        """Counts a second.

        ``output`` -1 to 1 of what the supply gives; ``load`` torque that pushes towards
        higher counts [N m].
        """
        torque = output * self.stall_torque * voltage / NOMINAL_VOLTAGE + load
        if abs(torque) <= self.friction:
            return 0.0
        excess = torque - self.friction if torque > 0.0 else torque + self.friction
        return self.no_load_speed * excess / self.stall_torque

    def output(self, speed: float, voltage: float, load: float) -> float:
        """What it takes to turn at a speed that is not zero; the inverse of `speed`."""
        friction = self.friction if speed > 0.0 else -self.friction
        torque = speed / self.no_load_speed * self.stall_torque + friction - load
        return torque / (self.stall_torque * voltage / NOMINAL_VOLTAGE)


MOTORS = {
    servo.model: Motor(servo.stall_torque, servo.no_load_speed / COUNT_ANGLE)
    for servo in SERVOS.values()
}
"""By model number."""
