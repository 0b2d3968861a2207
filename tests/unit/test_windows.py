"""Without the modules that only POSIX has: a spec is read, simulated and written; a port says what it needs."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.scenes import CONFIGS, ROOT

BLOCKED = ("fcntl", "termios", "resource", "pwd", "grp", "tty", "pty", "syslog")
PREPARE = f"""
import signal, sys
for name in {BLOCKED!r}:
    sys.modules[name] = None  # importing it raises ImportError, as on Windows
for name in ("SIGHUP", "SIGQUIT"):
    delattr(signal, name)
"""
LEG = str(CONFIGS / "leg_4_air.yaml")
QUICK = ("--set", "run.duration=0.2 s")


def on_windows(code: str, *words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", PREPARE + code, *words],
        capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip


COMMAND = "from viscodesign.cli.main import main\nsys.exit(main())"


def test_every_module_can_be_imported() -> None:
    code = """
import importlib, pkgutil, viscodesign
needs_ports = {"viscodesign.pump.bus.serial_line"}
for found in pkgutil.walk_packages(viscodesign.__path__, "viscodesign."):
    if found.name not in needs_ports | {"viscodesign.__main__"} and ".native.source" not in found.name:
        importlib.import_module(found.name)
"""
    done = on_windows(code)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_run_is_simulated_and_written(tmp_path: Path) -> None:
    done = on_windows(COMMAND, "simulate", LEG, "-o", str(tmp_path / "run"), *QUICK)
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "run" / "summary.json").exists()
    again = on_windows(COMMAND, "simulate", LEG, "-o", str(tmp_path / "run"), *QUICK)
    assert again.returncode == 0
    assert not [file for file in (tmp_path / "run").iterdir() if file.name.startswith(".")]


@pytest.mark.parametrize(
    "words", [["check", LEG], ["classify", LEG], ["effects"], ["schema"], ["init", "--list"]]
)
def test_commands_answer(words: list[str]) -> None:
    done = on_windows(COMMAND, *words)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("words", [["ports"], ["status", "--board", "dynamixel", "--port", "COM3"]])
def test_a_port_says_what_it_needs(words: list[str]) -> None:
    done = on_windows(COMMAND, "pump", *words)
    assert done.returncode == 4
    assert "need pyserial" in done.stderr
    assert "Traceback" not in done.stderr
