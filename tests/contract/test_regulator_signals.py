"""A real process that streams to a pressure regulator on a pseudo-terminal, and its signals."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.rig.pty import PtyServer
from tests.scenes import CONFIGS, ROOT
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.simulated.regulator import SimulatedRegulator
from viscodesign.scene.pumps.regulator import HIGHEST_SET_POINT

pytestmark = pytest.mark.skipif(os.name != "posix", reason="POSIX signals and terminals")

CHANGES = [
    "input={kind: sine, amplitude: 1 kPa, mean: 4 kPa, frequency: 0.05 Hz}",
    "run={duration: 10 s, output_interval: 0.1 s}",
    "effects={inertia: off, damping: off}",
]
"""Planned soon; with its lead-in it plays for 20 s, and no test lets it end."""
REQUESTS = 8
"""At most between a signal and the hold: what is left of a tick, and the outlet as it is."""


@dataclass
class Regulating:
    """A `pump stream` under way, and the regulator that it commands."""

    process: subprocess.Popen[str]
    device: SimulatedRegulator
    server: PtyServer
    folder: Path

    def sent(self) -> list[tuple[float, str]]:
        """When each command was sent, by the process's own log."""
        path = self.folder / "log.jsonl"
        lines = path.read_text().splitlines() if path.exists() else []
        entries = [json.loads(line) for line in lines if line.endswith("}")]
        return [
            (entry["monotonic_s"], bytes.fromhex(entry["hex"]).decode().strip())
            for entry in entries
            if entry["kind"] == "tx"
        ]

    def wait_for_set_points(self, count: int) -> None:
        limit = time.monotonic() + 120
        while sum(command.startswith("SET") for _, command in self.sent()) < count:
            assert self.process.poll() is None, self.process.communicate()
            assert time.monotonic() < limit
            time.sleep(0.05)

    def end(self) -> tuple[int, str]:
        """Exit code and standard error."""
        _, err = self.process.communicate(timeout=60)
        return self.process.returncode, err


@pytest.fixture
def regulating(tmp_path: Path) -> Iterator[Regulating]:
    device = SimulatedRegulator(100e3, HIGHEST_SET_POINT, 0.2)
    with PtyServer(device, WallClock()) as server:
        words = ["pump", "stream", str(CONFIGS / "leg_16_regulator.yaml"), "--board", "regulator"]
        words += ["--port", server.port, "--yes", "-o", str(tmp_path / "run")]
        words += [word for change in CHANGES for word in ("--set", change)]
        process = subprocess.Popen(
            [sys.executable, "-m", "viscodesign", *words],
            cwd=tmp_path,
            env=os.environ | {"PYTHONPATH": str(ROOT)},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        try:
            yield Regulating(process, device, server, tmp_path / "run")
        finally:
            process.kill()
            process.communicate()


def test_a_signal_holds_the_outlet_as_it_is(regulating: Regulating) -> None:
    regulating.wait_for_set_points(20)
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
    regulating.wait_for_set_points(10)
    regulating.process.send_signal(signal.SIGINT)
    regulating.process.send_signal(signal.SIGTERM)
    status, err = regulating.end()
    assert status == 130, err
    with regulating.server.lock:
        assert regulating.device.set_point == 0
    assert "it vents, verified" in err
