"""What only a real process shows: pipes, full disks, interrupts, start-up."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.scenes import ROOT

from .conftest import CONFIGS

COMMAND = [sys.executable, "-m", "viscodesign"]
PIPES = pytest.mark.skipif(os.name != "posix", reason="POSIX pipes and signals")


def test_python_m_viscodesign() -> None:
    done = subprocess.run([*COMMAND, "--version"], capture_output=True, text=True, check=True)
    assert done.stdout.startswith("viscodesign ")


@pytest.mark.parametrize(("own", "threads"), [({}, "1"), ({"OPENBLAS_NUM_THREADS": "3"}, "3")])
def test_a_process_has_one_thread_for_matrices_unless_told(
    own: dict[str, str], threads: str
) -> None:
    lines = [
        "import os, sys",
        "from viscodesign.cli.main import main",
        "assert 'numpy' not in sys.modules",
        "sys.argv = ['viscodesign', '--version']",
        "main()",
        "print(os.environ['OPENBLAS_NUM_THREADS'])",
    ]
    others = {k: v for k, v in os.environ.items() if k != "OPENBLAS_NUM_THREADS"}
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(lines)],
        capture_output=True, text=True, check=True, env=others | own,
    )  # fmt: skip
    assert done.stdout.splitlines()[-1] == threads


@PIPES
@pytest.mark.parametrize("words", [["--help"], ["init", "--list"], ["schema"], ["check"]])
def test_a_reader_that_leaves_early_causes_no_message(words: list[str]) -> None:
    spec = [str(CONFIGS / "leg_16_straight_air.yaml")] if words == ["check"] else []
    process = subprocess.Popen(
        [*COMMAND, *words, *spec], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert process.stdout is not None
    process.stdout.close()
    assert process.stderr is not None
    assert process.stderr.read() == b""
    process.stderr.close()
    process.wait(timeout=30)


@PIPES
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_under_stdout_is_one_line() -> None:
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [*COMMAND, "init", "--list"], stdout=full, stderr=subprocess.PIPE, text=True
        )
    assert done.returncode == 3
    assert done.stderr == "standard output: No space left on device\n"


def test_no_traceback_for_a_binary_spec(tmp_path: Path) -> None:
    spec = tmp_path / "leg.yaml"
    spec.write_bytes(bytes(range(256)))
    done = subprocess.run([*COMMAND, "check", str(spec)], capture_output=True, text=True)
    assert done.returncode == 2
    assert done.stdout == ""
    assert "Traceback" not in done.stderr


@PIPES
def test_an_interrupt_is_130_and_no_traceback(tmp_path: Path) -> None:
    program = (
        "import os, signal\n"
        "from viscodesign.cli import main as entry\n"
        "def wait(words):\n"
        "    os.kill(os.getpid(), signal.SIGINT)\n"
        "    while True: pass\n"
        "entry._run = wait\n"
        "raise SystemExit(entry.main(['simulate']))\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 128 + signal.SIGINT
    assert done.stderr == "interrupted\n"


@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-"])
def test_closed_outputs_do_not_stop_a_run(closed: str, tmp_path: Path) -> None:
    spec = CONFIGS / "leg_4_water_auto.yaml"
    command = (
        f"{sys.executable} -m viscodesign simulate {spec} --no-plots -o {tmp_path / 'run'} {closed}"
    )
    done = subprocess.run(["sh", "-c", command], cwd=ROOT, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "run" / "summary.json").exists()


HEAVY = ("scipy", "pandas", "pint", "matplotlib", "numpy.ma")


def test_a_verified_run_without_pictures_imports_nothing_heavy(tmp_path: Path) -> None:
    program = (
        "import sys; from viscodesign.cli.main import main\n"
        "spec, folder = sys.argv[1:]\n"
        "status = main(['simulate', spec, '-o', folder, '-q', '--no-plots'])\n"
        f"print(status, [name for name in {HEAVY!r} if name in sys.modules])"
    )
    call = [sys.executable, "-c", program, str(CONFIGS / "leg_16_straight_air.yaml"), str(tmp_path)]
    done = subprocess.run(call, capture_output=True, text=True, check=True)
    assert done.stdout == "0 []\n"


CLOSED = pytest.mark.skipif(os.name != "posix", reason="closes outputs by a POSIX shell")


@CLOSED
@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-", "<&-", "<&- >&- 2>&-"])
@pytest.mark.parametrize("words", ["--help", "init --list", "check {spec}", "effects --json"])
def test_closed_outputs_change_no_exit_code(closed: str, words: str) -> None:
    spec = CONFIGS / "leg_4_air.yaml"
    line = f'"{sys.executable}" -m viscodesign {words.format(spec=spec)} {closed}'
    done = subprocess.run(["sh", "-c", line], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")


@PIPES
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
@pytest.mark.parametrize(
    "words",
    [
        ["--help"],
        ["check", "--help"],
        ["--version"],
        ["schema"],
        ["check", str(CONFIGS / "leg_4_air.yaml")],
    ],
)
def test_a_full_disk_under_any_text_is_one_line(words: list[str]) -> None:
    with open("/dev/full", "w") as full:
        done = subprocess.run([*COMMAND, *words], stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 3
    assert done.stderr == "standard output: No space left on device\n"


def test_an_interrupt_of_what_is_imported_shows_no_traceback() -> None:
    program = (
        "import sys; from viscodesign.cli.main import main\n"
        "class Interrupting:\n"
        "    def find_spec(self, name, path=None, target=None):\n"
        "        if name.partition('.')[0] == 'typer':\n"
        "            raise KeyboardInterrupt\n"
        "sys.meta_path.insert(0, Interrupting())\n"
        "sys.exit(main(['check', 'leg.yaml']))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "interrupted\n")
