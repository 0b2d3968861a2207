"""The ends of travel against switches that are only computed."""

from __future__ import annotations

from typing import Any

import pytest

from tests.pumps import pump as settings_of
from tests.rig.full import BrokenPins
from viscodesign.errors import InterruptedRunError, PumpError
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.boards.arbotix_ros import Simulated
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.kinds.servo_calibration import BACK_OFF, find_travel
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.device import DirectLine
from viscodesign.pump.simulated.plant import Plant
from viscodesign.pump.simulated.ros import SWITCH_DISTANCE, Ros
from viscodesign.pump.simulated.servo import SimulatedServo


class Vented(Plant):
    def advance(self, seconds: float, positions: Any) -> Any:
        return 0.0 * positions


class Bed:
    """A vented pump with switches just outside of 300 to 500 counts, standing at 400."""

    def __init__(self, normally: str = "closed", **broken: float) -> None:
        switches = {"low": "D1", "high": "D2", "normally": normally}
        spec = settings_of(home=400, travel=(300, 500), limit_switches=switches)
        self.servo = SimulatedServo(1, 18, 400)
        self.servo.supply(11.1)
        bench = SimulatedBench([self.servo], [ServoDrive(spec)], Vented())
        self.clock = SteppedClock()
        line = DirectLine(Ros(bench, BrokenPins(bench, broken=dict(broken))), self.clock)
        free = spec.model_copy(update={"travel": (0, 1023)})
        self.pump = ServoPump(
            Simulated(line, [1]),
            free,
            [1],
            PressureReadings([None], 0.0),
            self.clock,
        )


@pytest.mark.parametrize("normally", ["closed", "open"])
def test_both_ends_are_found_and_backed_off_from(normally: str) -> None:
    bed = Bed(normally)
    low, high = find_travel(bed.pump, lambda: False)
    # Switches stand a little outside of the travel that the spec names.
    assert low == pytest.approx(300 - SWITCH_DISTANCE + BACK_OFF, abs=4)
    assert high == pytest.approx(500 + SWITCH_DISTANCE - BACK_OFF, abs=4)
    assert bed.servo.position == pytest.approx(low, abs=4)


def test_a_broken_wire_is_a_pressed_switch_and_told() -> None:
    bed = Bed(D1=1)
    with pytest.raises(PumpError, match="low end is pressed on the way"):
        find_travel(bed.pump, lambda: False)
    assert abs(bed.servo.position - 400) < 5


def test_a_search_without_a_switch_ends_at_the_servos_own_limit() -> None:
    bed = Bed(D2=0)
    with pytest.raises(PumpError, match="without a switch being pressed"):
        find_travel(bed.pump, lambda: False)


def test_a_wish_to_stop_is_obeyed_and_the_plunger_held() -> None:
    bed = Bed()
    with pytest.raises(InterruptedRunError):
        find_travel(bed.pump, lambda: bed.servo.position > 450)
    before = bed.servo.position
    bed.clock.sleep(2.0)
    assert bed.servo.position == pytest.approx(before, abs=3)


def test_a_port_that_dies_while_it_is_armed_is_told_as_such() -> None:
    for moment in range(12):
        bed = Bed()
        line, sent = bed.pump.board.line, []
        write = line.write

        def dying(data: bytes, write: Any = write, sent: Any = sent, moment: int = moment) -> None:
            sent.append(data)
            if len(sent) > moment:
                raise PumpError("the port is gone")
            write(data)

        line.write = dying
        with pytest.raises(PumpError, match="the port is gone"):
            find_travel(bed.pump, lambda: False)
