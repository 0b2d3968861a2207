"""What turns a simulated servo: its motor and gear against a load.

Torque and speed lie on a straight line between stall and no load, and scale with the supply. The
maker does not state friction, heating and cooling: they are assumed.
"""

from __future__ import annotations

from viscodesign.pump.ax.protocol.registers import COUNT_ANGLE
from viscodesign.scene.pumps.servo_motor import ServoType

FRICTION = 0.1  # of gear and plunger [N m]
HEATING = 1.0  # rate at which the case heats at stall [K/s]
COOLING_TIME = 300.0  # [s]


def motor_speed(servo: ServoType, output: float, voltage: float, load: float) -> float:
    """Speed [counts/s] at an ``output`` of -1 to 1 of what the supply gives.

    ``load``: torque that pushes towards higher counts [N m].
    """
    torque = output * servo.stall_torque * voltage / servo.rated_voltage + load
    if abs(torque) <= FRICTION:
        return 0.0
    excess = torque - FRICTION if torque > 0.0 else torque + FRICTION
    return servo.no_load_speed / COUNT_ANGLE * excess / servo.stall_torque


def motor_output(servo: ServoType, speed: float, voltage: float, load: float) -> float:
    """Output at which it turns at a speed that is not zero; the inverse of `motor_speed`."""
    friction = FRICTION if speed > 0.0 else -FRICTION
    torque = speed * COUNT_ANGLE / servo.no_load_speed * servo.stall_torque + friction - load
    return torque / (servo.stall_torque * voltage / servo.rated_voltage)
