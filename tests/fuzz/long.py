"""Many random scenes and broken specs; see the README beside this file.

python -m tests.fuzz.long --scenes 2500 --broken 5000 --seed 1 --jobs 2 -o FOLDER
python -m tests.fuzz.long --only 137 --seed 1          one scene again, its spec printed
python -m tests.fuzz.long --only-broken 137 --seed 1   one broken spec again
"""

from __future__ import annotations

import argparse
import contextlib
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import yaml

from tests.fuzz import worker_pool
from tests.fuzz.broken_outcome import outcome_of
from tests.fuzz.broken_specs import Broken, broken_spec
from tests.fuzz.invariants import Verdict
from tests.fuzz.random_numbers import rng_of
from tests.fuzz.tally import Tally
from tests.fuzz.trial import check_trial, drawn

EVERY = 100
"""Trials between two progress messages."""
MOST_KEPT = 3
"""Specs kept for each kind of early end."""


def scene_trial(seed: str, number: int) -> Verdict:
    """Task of a worker: one random scene."""
    return check_trial(drawn(seed, number), number)


def broken_trial(seed: str, number: int) -> Verdict:
    """Task of a worker: one broken spec."""
    return outcome_of(broken_of(seed, number))


def broken_of(seed: str, number: int) -> Broken:
    """Broken spec ``number`` of a seed."""
    return broken_spec(rng_of(f"broken:{seed}", number))


def spec_text(seed: str, number: int) -> str:
    """A scene's spec, with its tables as comments."""
    scene = drawn(seed, number)
    tables = [f"# {name}: {text!r}\n" for name, text in scene.files.items()]
    return "".join(tables) + yaml.safe_dump(scene.spec, sort_keys=False)


def broken_text(seed: str, number: int) -> str:
    """A broken spec as readable text."""
    broken = broken_of(seed, number)
    tables = [f"# {name}: {content[:2000]!r}\n" for name, content in broken.files.items()]
    return f"# {broken.how}\n# --set {broken.overrides}\n{''.join(tables)}{broken.text[:20000]!r}\n"


def main() -> int:
    """Draw, check and count; returns 1 if there is a finding."""
    given = _arguments()
    if given.only is not None:
        return _one(spec_text, scene_trial, given.seed, given.only)
    if given.only_broken is not None:
        return _one(broken_text, broken_trial, given.seed, given.only_broken)
    given.output.mkdir(parents=True, exist_ok=True)
    began = time.strftime("%Y-%m-%d %H:%M")
    tallies = list(_tallies(given))
    text = f"# Seed {given.seed}, {began}\n\n" + "\n".join(t.table() for t in tallies)
    (given.output / "table.md").write_text(text, encoding="utf-8")
    print(text)
    return int(any(t.findings for t in tallies))


def _arguments() -> argparse.Namespace:
    form = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=form)
    parser.add_argument("--scenes", type=int, default=0, help="how many random scenes")
    parser.add_argument("--broken", type=int, default=0, help="how many broken specs")
    parser.add_argument("--first", type=int, default=0, help="number of the first of them")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--only", type=int, help="this one scene, here and now")
    parser.add_argument("--only-broken", type=int, help="this one broken spec")
    parser.add_argument("-o", "--output", type=Path, default=Path("fuzz"))
    return parser.parse_args()


def _tallies(given: argparse.Namespace) -> Iterator[Tally]:
    if given.scenes:
        yield _counted("Scenes", given, given.scenes, scene_trial, spec_text)
    if given.broken:
        yield _counted("Broken specs", given, given.broken, broken_trial, broken_text)


def _counted(
    title: str,
    given: argparse.Namespace,
    count: int,
    task: worker_pool.Task,
    text_of: Callable[[str, int], str],
) -> Tally:
    tally = Tally(title)
    numbers = range(given.first, given.first + count)
    found = worker_pool.run_tasks(task, given.seed, numbers, given.jobs)
    for number, answer, seconds in _until_interrupted(found):
        verdict = (
            Verdict("dies", (answer.how,))
            if isinstance(answer, worker_pool.WorkerDeath)
            else answer
        )
        told = "; ".join(verdict.problems)
        tally.add(number, verdict.ending, told, seconds, verdict.numbers)
        early = verdict.ending not in ("complete", "refused", "loaded")
        if told or (early and tally.endings[verdict.ending] <= MOST_KEPT):
            name = f"{'finding' if told else 'ended'}_{title.split()[0].lower()}_{number:05d}.txt"
            head = f"# {verdict.ending}: {told}\n"
            (given.output / name).write_text(head + text_of(given.seed, number), encoding="utf-8")
        if told:
            print(number, verdict.ending, told[:300], flush=True)
        if tally.count % EVERY == 0:
            print(f"{title}: {tally.count} of {count}", flush=True)
    return tally


def _until_interrupted(found: Iterator[worker_pool.Answer]) -> Iterator[worker_pool.Answer]:
    """Results until Ctrl-C, after which the table is still printed."""
    with contextlib.suppress(KeyboardInterrupt):
        yield from found


def _one(text_of: Callable[[str, int], str], task: worker_pool.Task, seed: str, number: int) -> int:
    print(text_of(seed, number))
    verdict = task(seed, number)
    print(verdict.ending, *verdict.problems, verdict.numbers, sep="\n")
    return int(bool(verdict.problems))


if __name__ == "__main__":
    sys.exit(main())
