"""A type of servo is one entry: whatever asks for a type finds it there."""

from __future__ import annotations

from typing import get_args

import pytest

from tests.pumps import pump
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.servo_pump import axis_limits
from viscodesign.pump.servo_motor import SERVOS, ServoType, model_title
from viscodesign.pump.simulated.motor import MOTORS
from viscodesign.pump.simulated.servo import SimulatedServo
from viscodesign.scene.pumps.servo import ServoPumpSpec


def test_every_type_may_be_named_in_a_spec() -> None:
    assert set(get_args(ServoPumpSpec.model_fields["servo"].annotation)) == set(SERVOS)


@pytest.mark.parametrize("name", SERVOS)
def test_a_type_is_planned_simulated_and_identified_from_its_entry(name: str) -> None:
    kind: ServoType = SERVOS[name]
    servo = SimulatedServo(model=kind.model)
    assert servo.get(registers.MODEL) == kind.model
    assert servo.get(registers.MAX_TORQUE) == kind.max_torque
    assert model_title(kind.model) == kind.title
    # Without friction, at the supply of a spec.
    free = MOTORS[kind.model].no_load_speed * 11.1 / 12.0
    assert axis_limits(pump(servo=name)).top_speed == pytest.approx(free)


def test_another_model_is_told_by_its_number() -> None:
    assert model_title(29) == "model 29"
