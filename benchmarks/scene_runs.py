"""Shared by the studies of drawn scenes: a process per scene, a time limit, lines of JSON.

Every scene runs in a process of its own, which prints a line of JSON for whatever it
finds. The lines go to one file as they come, closed by an `end` line with the wall time
and what went wrong; a second call goes on where the first ended.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml

if TYPE_CHECKING:
    from viscodesign.scene.scene import Scene

Record = dict[str, Any]
FITTED_SEED = 2026
"""Seed of the scenes on which the numbers of choice and of stated errors were chosen."""
UNSEEN_SEED = 90909
"""Seed of scenes that judge them."""


def options(title: str, timeout: float, output: Path) -> argparse.ArgumentParser:
    """Options of every study; ``timeout`` [s] and ``output`` are defaults."""
    parser = argparse.ArgumentParser(description=title)
    parser.add_argument("--scenes", type=int, default=60)
    parser.add_argument("--seed", type=int, default=UNSEEN_SEED)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument(
        "--timeout", type=float, default=timeout, help="time limit of one scene in seconds"
    )
    parser.add_argument(
        "--only", type=int, help="run one scene in this process and print its lines"
    )
    parser.add_argument("--report", action="store_true", help="only report")
    parser.add_argument("--output", type=Path, default=output)
    return parser


def say(records: Iterable[Record]) -> None:
    """Print lines as they come, for the parent process."""
    for record in records:
        print(json.dumps(record), flush=True)


def read(path: Path) -> list[Record]:
    """All result lines of a file."""
    if not path.exists():
        return []
    return [json.loads(line) for line in path.read_text().splitlines()]


def run_all(given: argparse.Namespace, script: str, more: Sequence[str] = ()) -> None:
    """Run the scenes without an `end` line; ``more`` are options of the process."""
    given.output.parent.mkdir(parents=True, exist_ok=True)
    done = {r["index"] for r in read(given.output) if r["kind"] == "end"}
    wanted = [k for k in range(given.scenes) if k not in done]
    with ThreadPoolExecutor(given.jobs) as pool, given.output.open("a") as file:
        for lines in pool.map(lambda k: _in_process(given, script, more, k), wanted):
            file.write(lines)
            file.flush()


def _in_process(given: argparse.Namespace, script: str, more: Sequence[str], index: int) -> str:
    """Lines of one scene, those of a killed process included."""
    command = [sys.executable, script, "--only", str(index), "--seed", str(given.seed), *more]
    began = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=given.timeout)
        ended = f"ended with {done.returncode}"
        said, note = done.stdout, "" if done.returncode == 0 else done.stderr[-300:] or ended
    except subprocess.TimeoutExpired as late:
        said = late.stdout.decode() if isinstance(late.stdout, bytes) else late.stdout or ""
        note = f"stopped after {given.timeout:g} s"
    whole = [line for line in said.splitlines() if line.endswith("}")]
    end = {"kind": "end", "index": index, "wall_s": time.monotonic() - began, "note": note}
    print(f"{index}: {end['wall_s']:.1f} s {note}", flush=True)
    return "\n".join([*whole, json.dumps(end)]) + "\n"


def drawn(seed: int, index: int, overrides: Sequence[str] = ()) -> Scene:
    """One drawn scene, read like a spec from a file."""
    from scene_draw import draw

    return loaded(draw(seed, index), overrides)


def loaded(spec: dict[str, Any], overrides: Sequence[str] = ()) -> Scene:
    """A drawn spec, read like one from a file."""
    from viscodesign import load

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.yaml"
        path.write_text(yaml.safe_dump(spec))
        return load(path, overrides)


def forget_choices() -> None:
    """Have effects weighed anew."""
    from viscodesign.effects import select, tip_displacements
    from viscodesign.storage.lru_cache import LruCache

    select._choices = LruCache(64)
    tip_displacements._distances = LruCache(64)
