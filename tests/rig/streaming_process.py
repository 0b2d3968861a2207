"""A `pump stream` in a process of its own, and what its log says of it."""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tests.scenes import ROOT


@dataclass
class StreamingProcess:
    """A `pump stream` under way."""

    process: subprocess.Popen[str]
    folder: Path

    def log(self) -> list[dict[str, Any]]:
        """What the process has logged so far."""
        path = self.folder / "log.jsonl"
        lines = path.read_text().splitlines() if path.exists() else []
        return [json.loads(line) for line in lines if line.endswith("}")]

    def count(self) -> int:
        """How far the stream has come."""
        return sum(entry["kind"] == "tick" for entry in self.log())

    def wait_for(self, count: int) -> None:
        """Wait until the stream has come so far, for two minutes at most."""
        limit = time.monotonic() + 120
        while self.count() < count:
            assert self.process.poll() is None, self.process.communicate()
            assert time.monotonic() < limit
            time.sleep(0.02)

    def end(self) -> tuple[int, str]:
        """Exit code and standard error."""
        _, err = self.process.communicate(timeout=60)
        return self.process.returncode, err


@contextlib.contextmanager
def stream_process(
    spec: Path, board: str, port: str, changes: Sequence[str], desk: Path
) -> Iterator[subprocess.Popen[str]]:
    """The process of `pump stream` in an empty folder, which writes to ``run`` there."""
    words = ["pump", "stream", str(spec), "--board", board, "--port", port]
    words += ["--yes", "-o", str(desk / "run")]
    words += [word for change in changes for word in ("--set", change)]
    process = subprocess.Popen(
        [sys.executable, "-m", "viscodesign", *words],
        cwd=desk,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        yield process
    finally:
        process.kill()
        process.communicate()
