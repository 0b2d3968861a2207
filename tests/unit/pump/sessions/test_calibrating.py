"""Home and travel shown by hand."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from tests.pumps import bench
from tests.rig.bus import BusAdapter
from tests.rig.pty import PtyServer
from tests.scenes import leg
from viscodesign import pump
from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.sessions.calibrating import Calibration
from viscodesign.pump.simulated.bench import SimulatedBench

SCENE = leg("pump.sensor=null", config="leg_16_pump")


@pytest.fixture
def servos() -> SimulatedBench:
    made = bench(1)
    made.servos[0].supply(11.1)
    return made


@pytest.fixture
def address(servos: SimulatedBench) -> Iterator[pump.BoardAddress]:
    with PtyServer(BusAdapter(servos), WallClock()) as server:
        yield pump.BoardAddress("dynamixel", server.port)


def shown(*counts: int) -> Callable[[str, Callable[[], int]], int]:
    """Somebody who moves the plunger to these counts, one after the other."""
    given = iter(counts)

    def by_hand(task: str, read: Callable[[], int]) -> int:
        assert "move the plunger" in task
        assert 0 <= read() <= 1023
        return next(given)

    return by_hand


def test_three_positions_become_home_and_travel(
    address: pump.BoardAddress, servos: SimulatedBench
) -> None:
    asked: list[str] = []

    def confirm(text: str) -> bool:
        asked.append(text)
        return True

    found = pump.calibrate(SCENE, address, confirm=confirm, by_hand=shown(150, 950, 400))
    assert found == Calibration(400, (150, 950))
    assert asked[0].endswith("Is it vented?")
    assert servos.servos[0].get(registers.CW_LIMIT) == 150
    assert servos.servos[0].get(registers.CCW_LIMIT) == 950
    assert not servos.servos[0].get(registers.TORQUE_ENABLE)


@pytest.mark.parametrize(
    ("counts", "message"),
    [((950, 150, 400), "pump.push: up; correct it"), ((150, 950, 990), "is not between the ends")],
)
def test_positions_that_cannot_be_are_refused(
    address: pump.BoardAddress,
    servos: SimulatedBench,
    counts: tuple[int, ...],
    message: str,
) -> None:
    before = servos.servos[0].get(registers.CW_LIMIT)
    with pytest.raises(PumpError, match=message):
        pump.calibrate(SCENE, address, confirm=lambda text: True, by_hand=shown(*counts))
    assert servos.servos[0].get(registers.CW_LIMIT) == before


def test_without_consent_or_a_hand_nothing_is_written(address: pump.BoardAddress) -> None:
    with pytest.raises(UsageError, match="nothing moved"):
        pump.calibrate(SCENE, address, confirm=lambda text: False, by_hand=shown())
    with pytest.raises(UsageError, match="has to be moved by hand"):
        pump.calibrate(SCENE, address, confirm=lambda text: True)
