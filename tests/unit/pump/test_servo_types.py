"""A type of servo is one entry: whatever asks for a type finds it there."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.pumps import pump
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.registers import COUNT_ANGLE
from viscodesign.pump.ax.servo_pump import axis_limits
from viscodesign.pump.simulated.servo import SimulatedServo
from viscodesign.scene.pumps.servo_motor import SERVOS, ServoType, model_title

ROW_ALONE = """
from viscodesign.scene.pumps import servo_motor
servo_motor.SERVOS["own"] = servo_motor.ServoType("OWN-1", 99, 3.0, 2.0, 7.0)
from tests.pumps import pump
from viscodesign.errors import SpecError
from viscodesign.pump.ax.servo_pump import axis_limits
from viscodesign.pump.simulated.servo import SimulatedServo
from viscodesign.pump.ax.protocol.registers import MODEL
from viscodesign.scene.pumps.servo import ServoPumpSpec
from tests.scenes import leg
print(leg("pump.servo=own", config="leg_16_pump").pump.servo)
print(axis_limits(pump(servo="own")).top_speed > 0.0, SimulatedServo(model=99).get(MODEL) == 99)
print(ServoPumpSpec.model_json_schema()["properties"]["servo"]["enum"])
try:
    leg("pump.servo=owm", config="leg_16_pump")
except SpecError as error:
    print(error)
"""


def test_a_row_alone_makes_a_type_that_a_spec_may_name() -> None:
    ran = subprocess.run(
        [sys.executable, "-c", ROW_ALONE], capture_output=True, text=True, timeout=60, check=False
    )
    names = [*SERVOS, "own"]
    assert ran.stderr == ""
    assert ran.stdout.splitlines()[:3] == ["own", "True True", str(names)]
    assert f"must be one of {', '.join(names)}; got 'owm'" in ran.stdout


@pytest.mark.parametrize("name", SERVOS)
def test_a_type_is_planned_simulated_and_identified_from_its_entry(name: str) -> None:
    kind: ServoType = SERVOS[name]
    servo = SimulatedServo(model=kind.model)
    assert servo.get(registers.MODEL) == kind.model
    assert servo.get(registers.MAX_TORQUE) == kind.max_torque
    assert model_title(kind.model) == kind.title
    # Without friction, at the supply of a spec.
    free = kind.no_load_speed / COUNT_ANGLE * 11.1 / 12.0
    assert axis_limits(pump(servo=name)).top_speed == pytest.approx(free)


def test_another_model_is_told_by_its_number() -> None:
    assert model_title(29) == "model 29"
