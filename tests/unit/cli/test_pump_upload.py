"""`pump upload` from its words to the packets on a port, and to its exit code."""

from __future__ import annotations

import json
import os
import signal
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.plans import made_plan, planner
from tests.pose_rig import TRAVEL, Watched, swing
from tests.poses_h import read_poses_h
from tests.pumps import HOME, Weights, bench
from tests.rig.pty import PtyServer
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.boards.arbotix import Arbotix
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.poses.engine import LOOP, PLAY
from viscodesign.pump.profile import Profile
from viscodesign.pump.simulated.pypose import PyPose
from viscodesign.pump.simulated.ros import Ros

from .conftest import Call, Outcome

PUMP = f"pump={{syringe_diameter: 34.9 mm, home: {HOME}, travel: [{TRAVEL[0]}, {TRAVEL[1]}]}}"
SHORT = swing(duration=0.99, amplitude=15.0)

Upload = Callable[..., Outcome]


@pytest.fixture
def upload(call: Call, leg: Path, monkeypatch: pytest.MonkeyPatch) -> Upload:
    """`pump upload` of a made plan; opening a port resets nothing here."""
    monkeypatch.setattr(Arbotix, "boot", 0.0)

    def run(*words: object, profile: Profile = SHORT, feasible: bool = True) -> Outcome:
        plan = made_plan(profile, feasible=feasible)
        monkeypatch.setattr("viscodesign.pump.sessions.uploading.plan_pump", planner(plan))
        return call("pump", "upload", leg, "--set", PUMP, *map(str, words))

    return run


@pytest.fixture
def pump() -> Watched:
    """One servo, calibrated, that presses into nothing."""
    made = Watched(bench(1, plant=Weights([0.0])))
    made.supply(11.1)
    made.servos[0].set(registers.CW_LIMIT, TRAVEL[0])
    made.servos[0].set(registers.CCW_LIMIT, TRAVEL[1])
    return made


@pytest.fixture
def port(pump: Watched) -> Iterator[str]:
    with PtyServer(PyPose(pump), WallClock()) as server:
        yield server.port


def packets(outcome: Outcome) -> list[str]:
    return [line.strip() for line in outcome.out.splitlines() if line.startswith("  FF FF FD")]


# -- without a port -------------------------------------------------------------------------------


@pytest.mark.parametrize("how", ["--play", "--loop"])
def test_a_dry_run_shows_plan_and_packets_and_opens_nothing(upload: Upload, how: str) -> None:
    outcome = upload("--dry-run", how, "--port", "/dev/there-is-none")
    assert (outcome.status, outcome.err) == (0, "")
    for words in ("[dry run] no port is opened", "off by at most", "counts", "mL", "kPa gauge"):
        assert words in outcome.out
    start = str(LOOP if how == "--loop" else PLAY)
    assert packets(outcome).count(start) == 1
    assert ("48 48 48" in outcome.out) == (how == "--loop")


def test_a_dry_run_without_motion_starts_nothing(upload: Upload) -> None:
    sent = packets(upload("--dry-run"))
    assert str(PLAY) not in sent
    assert str(LOOP) not in sent


def test_the_header_is_written_once(upload: Upload, tmp_path: Path) -> None:
    file = tmp_path / "poses.h"
    outcome = upload("--export", file, "--loop")
    assert (outcome.status, outcome.err) == (0, "")
    assert f"written: {file}" in outcome.out
    text = file.read_text()
    assert "00ff00ff" in text
    assert len(read_poses_h(text).moves) > 1
    again = upload("--export", file)
    assert again.status == 2
    assert "--force" in again.err
    assert file.read_text() == text
    assert upload("--export", file, "--force", "--quiet") == Outcome(0, "", "")


def test_the_fit_is_drawn(upload: Upload, tmp_path: Path) -> None:
    file = tmp_path / "upload.png"
    outcome = upload("--picture", file)
    assert (outcome.status, outcome.err) == (0, "")
    assert file.read_bytes().startswith(b"\x89PNG")
    assert upload("--picture", file).status == 2


def test_json_is_one_document(upload: Upload, tmp_path: Path) -> None:
    outcome = upload("--export", tmp_path / "poses.h", "--json")
    document = json.loads(outcome.out)
    assert document["status"] == "written"
    assert 0.0 < document["largest_error_counts"] < 1.5
    assert document["largest_error_pa"] == pytest.approx(100 * document["largest_error_counts"])
    assert document["duration_s"] == pytest.approx(document["wanted_duration_s"], abs=0.033)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--play", "--loop", "--dry-run"), "mutually exclusive"),
        (("--play",), "--port is missing"),
        (("--board", "dynamixel", "--dry-run"), "takes no poses; those go to arbotix"),
        (("--board", "arbotics", "--dry-run"), "did you mean 'arbotix'?"),
        (("--tolerance", "1 mm", "--dry-run"), "tolerance '1 mm'"),
    ],
)
def test_wrong_options_are_refused(upload: Upload, words: tuple[str, ...], told: str) -> None:
    outcome = upload(*words)
    assert outcome.status == 2
    assert told in outcome.err


def test_a_fit_above_the_tolerance_is_refused_with_its_error(upload: Upload) -> None:
    outcome = upload("--dry-run", "--tolerance", "0.1 counts")
    assert outcome.status == 4
    assert "the tolerance is 0.1 counts" in outcome.err
    assert "pump stream" in outcome.err


def test_what_the_pump_cannot_do_is_refused_unless_asked_for(upload: Upload) -> None:
    outcome = upload("--dry-run", feasible=False)
    assert outcome.status == 4
    assert "pump.max_pressure allows 25 kPa" in outcome.err
    assert upload("--dry-run", "--achievable", feasible=False).status == 0


def test_servo_ids_that_poses_cannot_have_are_refused(upload: Upload) -> None:
    outcome = upload("--dry-run", profile=swing((2,)))
    assert outcome.status == 4
    assert "takes poses of the servos 1 to 1 only" in outcome.err


# -- on a port ------------------------------------------------------------------------------------


def test_a_loaded_upload_says_that_it_is_volatile(upload: Upload, port: str, pump: Watched) -> None:
    outcome = upload("--port", port)
    assert outcome.status == 0
    assert "RAM only" in outcome.out
    assert pump.goals == []
    assert pump.servos[0].get(registers.TORQUE_ENABLE) == 0


def test_without_a_terminal_nothing_is_played(upload: Upload, port: str, pump: Watched) -> None:
    outcome = upload("--port", port, "--play")
    assert outcome.status == 2
    assert "add --yes" in outcome.err
    assert "off by at most" in outcome.err
    assert pump.servos[0].get(registers.TORQUE_ENABLE) == 0


def test_it_plays_once(upload: Upload, port: str, pump: Watched, tmp_path: Path) -> None:
    log = tmp_path / "bytes.jsonl"
    outcome = upload("--port", port, "--play", "--yes", "--json", "--log", log)
    assert outcome.status == 0, outcome.err
    document = json.loads(outcome.out)
    assert (document["status"], document["hold_verified"]) == ("complete", True)
    counts = [row[0] for row in pump.goals]
    assert max(counts) == pytest.approx(HOME + 30, abs=2)
    assert counts[-1] == pytest.approx(HOME, abs=2)
    kinds = [json.loads(line)["kind"] for line in log.read_text().splitlines()]
    assert kinds[0] == "opened"
    assert {"tx", "rx", "found", "ended", "closed"} <= set(kinds)


def test_it_plays_on_the_simulated_board(upload: Upload) -> None:
    outcome = upload("--board", "simulated", "--play", "--yes", "--json")
    assert outcome.status == 0, outcome.err
    assert json.loads(outcome.out)["status"] == "complete"
    assert "found simulated, nothing real moves" in outcome.err


def test_a_loop_ends_by_control_c(upload: Upload, port: str, pump: Watched) -> None:
    def interrupt() -> None:
        while len(pump.goals) < 1.5 * 30:
            threading.Event().wait(0.05)
        os.kill(os.getpid(), signal.SIGINT)

    waiting = threading.Thread(target=interrupt)
    waiting.start()
    outcome = upload("--port", port, "--loop", "--yes")
    waiting.join()
    assert outcome.status == 130
    assert "cannot be interrupted and ends in about" in outcome.err
    assert "holds at" in outcome.err
    played = len(pump.goals)
    threading.Event().wait(0.3)
    assert len(pump.goals) == played


def test_another_firmware_is_reported(upload: Upload) -> None:
    with PtyServer(Ros(bench(1)), WallClock()) as server:
        outcome = upload("--port", server.port, "--play", "--yes")
    assert outcome.status == 4
    assert "the board arbotix-ros" in outcome.err


def test_a_servo_with_low_voltage_is_not_moved(upload: Upload, port: str, pump: Watched) -> None:
    pump.supply(9.5)
    outcome = upload("--port", port, "--play", "--yes")
    assert outcome.status == 4
    assert "9.5 V" in outcome.err
    assert pump.goals == []


def test_a_missing_servo_is_reported(upload: Upload) -> None:
    with PtyServer(PyPose(bench(3)), WallClock()) as server:
        outcome = upload("--port", server.port, "--play", "--yes")
    assert outcome.status == 4
    assert "id 1 did not answer" in outcome.err
