"""Every command and every block of Python on a page can be run, word by word."""

from __future__ import annotations

import re
import shlex
import shutil
from collections.abc import Iterator
from contextlib import redirect_stdout
from glob import glob
from io import StringIO
from pathlib import Path
from typing import Any

import pytest
import yaml

from tests.desk import set_up
from tests.plans import planned_once
from tests.scenes import ROOT
from tests.thorough import ALL
from viscodesign.cli.main import main

BLOCK = re.compile(r"^```(sh|python|yaml)\n(.*?)^```", re.DOTALL | re.MULTILINE)
ELSEWHERE = {"tutorial.md": "tests/unit/test_site.py", "library.md": "tests/unit/test_library.py"}
"""Pages whose blocks are run by tests of their own, in their order in an empty folder."""
PAGES = [
    page
    for page in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))
    if page.name not in ELSEWHERE
]
LONG = {"commands.md", "contact.md", "several.md"}
"""Pages that take half of the time of all, for commands and scenes that other tests run."""
NOT_RUN = {
    "/dev/tty": "needs a pump at a serial port; tests/unit/pump play the same on simulated bytes",
    "--board dynamixel": "needs a pump",
    "pump ports": "lists the ports of this machine",
    "make ": "sets up an environment, and runs these tests",
    ".venv/bin/activate": "belongs to that environment",
    "--figure": "minutes: simulates all scenes of a figure; tests/validation has the paper's words",
    "viscodesign accuracy": "minutes, by the clock; tests/unit/cli/test_accuracy.py runs it",
    "accuracy(load": "the same from Python",
    "viscodesign walk": "tens of seconds, for six legs on the ground; tests/unit/robot walks fewer",
    "--crouch 0.85": "seconds, as `viscodesign stand` without it, which is run",
    "Then let your editor": "a sentence between the lines of an example",
    "--sample 10000": "minutes; `--sample 1000` without it is run with fewer rows",
    "load52_b.csv": "its measurement is downloaded; docs/make_validation.py compares it",
    "step_200mbar.csv": "its measurement is downloaded; docs/make_validation.py compares it",
    "configs/wall.yaml": "ten seconds; tests/golden solves it",
    "configs/leg_*.yaml": "minutes: simulates all configs; tests/golden does",
}
"""Parts of commands and of Python that are not run, and why."""
SHORTENED = {
    "sweep": ("--workers", "1", "--verify", "0", "--force"),
    "report runs/leg --film": ("--fps", "4"),
    "pump stream": ("--yes", "--pace", "max"),
}
"""Options added to commands that would take long, wait, or find another sweep in their folder."""
REPLACED = {
    "--sample 1000": "--sample 30",
    "tube_radius=0.2 mm..0.6 mm:9": "tube_radius=0.2 mm..0.6 mm:3",
    "pump plan pump.yaml": "pump plan leg.yaml",
    "pump stream pump.yaml": "pump stream leg.yaml",
}
"""Words replaced for the same reason."""
CAN_FAIL = {"design": 3, "reach": 3}
"""Commands that may exit with another code than 0: this design is not met, this point out of reach."""


def blocks(page: Path) -> list[tuple[str, str]]:
    return BLOCK.findall(page.read_text(encoding="utf-8"))


def commands_of(block: str) -> list[str]:
    """The command lines of a block, continued ones as one, without comments and redirections."""
    lines = block.replace("\\\n", " ").splitlines()
    words = (" ".join(re.sub(r"(?:^|\s)#.*$|\s>\s.*$", "", line).split()) for line in lines)
    return [line for line in words if line]


def reason_not_run(text: str) -> str | None:
    return next((why for part, why in NOT_RUN.items() if part in text), None)


@pytest.fixture(scope="module")
def prepared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    desk = tmp_path_factory.mktemp("desk")
    set_up(desk)
    return desk


@pytest.fixture
def desk(prepared: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A copy of the desk to work at, so that no page sees what another one left."""
    from matplotlib import pyplot

    shutil.copytree(prepared, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("viscodesign.pump.sessions.streaming.plan_pump", planned_once)
    yield tmp_path
    pyplot.close("all")


DONE: set[str] = set()
"""Commands that were run, wherever their files went: other pages need not repeat them."""


def run_command(line: str, desk: Path) -> None:
    for given, other in REPLACED.items():
        line = line.replace(given, other)
    name, *words = shlex.split(line)
    assert name == "viscodesign", line
    words = [
        path for word in words for path in (sorted(glob(word)) if "*.yaml" in word else [word])
    ]
    spec = desk / "leg.yaml"
    small = spec.read_bytes()
    if words[0] == "init":
        (desk / words[1]).unlink(missing_ok=True)
    elif (asked := re.sub(r" -o \S+", "", line)) in DONE:
        return
    else:
        DONE.add(asked)
    for start, more in SHORTENED.items():
        if " ".join(words).startswith(start):
            words += [] if more[0] in words else more
    with redirect_stdout(StringIO()):
        code = main(words)
    assert code in (0, CAN_FAIL.get(words[0], 0)), line
    spec.write_bytes(small)  # where a template was written, the smaller leg stays the reader's


@pytest.mark.parametrize(
    "page", [p for p in PAGES if ALL or p.name not in LONG], ids=lambda page: page.name
)
def test_commands_and_blocks_of_a_page(
    page: Path, desk: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    known: dict[str, Any] = {}
    for kind, text in blocks(page):
        if kind == "sh":
            for line in commands_of(text):
                if reason_not_run(line) is None:
                    run_command(line, desk)
        elif kind == "python":
            if reason_not_run(text) is None:
                exec(compile(text, page.name, "exec"), known)
        else:
            yaml.safe_load(text.replace("{...}", "{}"))
    assert "Traceback" not in capsys.readouterr().err


def test_nothing_is_left_out_without_need() -> None:
    assert all((ROOT / test).exists() for test in ELSEWHERE.values())
    every = "\n".join(text for page in PAGES for kind, text in blocks(page) if kind != "yaml")
    assert [part for part in NOT_RUN if part not in every] == []
    assert [part for part in REPLACED if part not in every] == []
