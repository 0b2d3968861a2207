"""Pressures: the sensor's line, its rails, its zero, and a frozen one."""

from __future__ import annotations

import sys
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.pumps import bench, stepped
from tests.rig.full import BrokenPins
from viscodesign.errors import PumpError
from viscodesign.pump.boards.arbotix_ros import ArbotixRos
from viscodesign.pump.boards.dynamixel import Dynamixel
from viscodesign.pump.sensors.pressure_sensors import (
    SensorError,
    absolute_pressure,
    board_sensor,
    phidget_sensor,
    pressure_of,
    ratio_of,
)
from viscodesign.pump.simulated.device import DirectLine
from viscodesign.pump.simulated.ros import Ros


@pytest.mark.parametrize(
    ("kilopascals", "count"), [(20, 40), (101.3, 242), (140, 338), (241.3, 589), (400, 983)]
)
def test_the_line_of_the_sensor(kilopascals: float, count: int) -> None:
    # Ten-bit counts from the vendor's formula.
    assert int(ratio_of(1e3 * kilopascals) * 1024) == pytest.approx(count, abs=1)


@given(st.floats(20e3, 400e3))
def test_the_line_goes_both_ways(pressure: float) -> None:
    assert absolute_pressure(ratio_of(pressure)) == pytest.approx(pressure)


@pytest.mark.parametrize("ratio", [0.0, 19 / 1024, 1004 / 1024, 1.0])
def test_rails_are_no_pressures(ratio: float) -> None:
    with pytest.raises(SensorError, match="open or shorted"):
        pressure_of(ratio)


@pytest.mark.parametrize("ratio", [30 / 1024, 1000 / 1024])
def test_what_is_out_of_range_is_no_pressure(ratio: float) -> None:
    with pytest.raises(SensorError, match="20 to 400 kPa"):
        pressure_of(ratio)


def test_the_board_gives_the_pressure_within_its_eight_bits() -> None:
    pump = bench(1)
    board = ArbotixRos(DirectLine(Ros(pump), stepped()))
    read = board_sensor(board, 0)
    assert read() == pytest.approx(101_325, abs=1613 / 2 + 1)
    pump.pressures = pump.pressures + 20e3
    assert read() == pytest.approx(121_325, abs=1613 / 2 + 1)


@pytest.mark.parametrize("rail", [0.0, 1.0])
def test_a_cut_wire_is_a_fault(rail: float) -> None:
    pump = bench(1)
    pins = BrokenPins(pump, broken={"A0": rail})
    with pytest.raises(SensorError, match="open or shorted"):
        board_sensor(ArbotixRos(DirectLine(Ros(pump, pins), stepped())), 0)()


def test_a_board_without_pins_is_refused() -> None:
    with pytest.raises(PumpError, match="has no analog inputs"):
        board_sensor(Dynamixel(DirectLine(Ros(bench(1)), stepped())), 0)


# -- the vendor's library, stood in for -----------------------------------------------------


class VendorError(Exception):
    pass


class Input:
    """What the library's object is asked."""

    trouble: Exception | None = None
    closed = 0

    def setChannel(self, channel: int) -> None:  # noqa: N802
        self.channel = channel

    def openWaitForAttachment(self, milliseconds: int) -> None:  # noqa: N802
        if self.trouble:
            raise self.trouble

    def getVoltageRatio(self) -> float:  # noqa: N802
        if self.trouble:
            raise self.trouble
        return ratio_of(150e3)

    def close(self) -> None:
        type(self).closed += 1


@pytest.fixture
def vendor(monkeypatch: pytest.MonkeyPatch) -> type[Input]:
    class Attached(Input):
        pass

    device: Any = ModuleType("Phidget22.Devices.VoltageRatioInput")
    device.VoltageRatioInput = Attached
    failure: Any = SimpleNamespace(PhidgetException=VendorError)
    monkeypatch.setitem(sys.modules, "Phidget22", ModuleType("Phidget22"))
    monkeypatch.setitem(sys.modules, "Phidget22.Devices", ModuleType("Phidget22.Devices"))
    monkeypatch.setitem(sys.modules, "Phidget22.Devices.VoltageRatioInput", device)
    monkeypatch.setitem(sys.modules, "Phidget22.PhidgetException", failure)
    return Attached


def test_a_phidget_gives_its_ratio(vendor: type[Input]) -> None:
    with phidget_sensor(3) as read:
        assert read() == pytest.approx(150e3)
        vendor.trouble = VendorError("detached")
        with pytest.raises(SensorError, match="detached"):
            read()
        assert vendor.closed == 0
    assert vendor.closed == 1


@pytest.mark.parametrize(
    ("trouble", "words"), [(VendorError("0x3"), "plugged in"), (OSError("libusb"), "libusb-1.0")]
)
def test_a_phidget_that_is_not_there(vendor: type[Input], trouble: Exception, words: str) -> None:
    vendor.trouble = trouble
    with pytest.raises(SensorError, match=words), phidget_sensor(0):
        pass
    assert vendor.closed == 1


def test_a_missing_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "Phidget22", None)
    with pytest.raises(PumpError, match=r"viscodesign\[phidgets\]"), phidget_sensor(0):
        pass
