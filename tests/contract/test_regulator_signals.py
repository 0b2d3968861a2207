"""A real process that streams to a pressure regulator on a pseudo-terminal, and its signals."""

from __future__ import annotations

import json
import os
import signal
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.rig.pty import PtyServer
from tests.rig.streaming_process import StreamingProcess, stream_process
from tests.scenes import CONFIGS
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.simulated.regulator import SimulatedRegulator
from viscodesign.scene.pumps.regulator import RegulatorSpec

pytestmark = pytest.mark.skipif(os.name != "posix", reason="POSIX signals and terminals")

SPEC = CONFIGS / "leg_16_regulator.yaml"
CHANGES = [
    "input={kind: sine, amplitude: 1 kPa, mean: 4 kPa, frequency: 0.05 Hz}",
    "run={duration: 10 s, output_interval: 0.1 s}",
    "effects={inertia: off, damping: off}",
]
"""Planned soon; with its lead-in it plays for 20 s, and no test lets it end."""
REQUESTS = 8
"""At most between a signal and the hold: what is left of a tick, and the outlet as it is."""


@dataclass
class Regulating(StreamingProcess):
    """A `pump stream` under way, and the regulator that it commands."""

    device: SimulatedRegulator
    server: PtyServer

    def sent(self) -> list[tuple[float, str]]:
        """When each command was sent, by the process's own log."""
        return [
            (entry["monotonic_s"], bytes.fromhex(entry["hex"]).decode().strip())
            for entry in self.log()
            if entry["kind"] == "tx"
        ]

    def count(self) -> int:
        """Set-points so far."""
        return sum(command.startswith("SET") for _, command in self.sent())


@pytest.fixture
def regulating(tmp_path: Path) -> Iterator[Regulating]:
    device = SimulatedRegulator(RegulatorSpec(full_scale=100e3))
    with (
        PtyServer(device, WallClock()) as server,
        stream_process(SPEC, "regulator", server.port, CHANGES, tmp_path) as process,
    ):
        yield Regulating(process, tmp_path / "run", device, server)


def test_a_signal_holds_the_outlet_as_it_is(regulating: Regulating) -> None:
    regulating.wait_for(20)
    regulating.process.send_signal(signal.SIGTERM)
    asked = time.monotonic()
    status, err = regulating.end()
    assert status == 130, err
    later = [command for moment, command in regulating.sent() if moment > asked]
    last = max(k for k, command in enumerate(later) if command.startswith("SET"))
    assert last <= REQUESTS
    assert later[-1] == "REQ"  # what it holds was read back
    assert "verified" in err
    beside = json.loads((regulating.folder / "record.json").read_text())
    assert (beside["status"], beside["hold_verified"]) == ("interrupted", True)


def test_a_second_signal_vents(regulating: Regulating) -> None:
    regulating.wait_for(10)
    regulating.process.send_signal(signal.SIGINT)
    regulating.process.send_signal(signal.SIGTERM)
    status, err = regulating.end()
    assert status == 130, err
    with regulating.server.lock:
        assert regulating.device.set_point == 0
    assert "it vents, verified" in err
