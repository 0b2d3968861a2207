"""Many random scenes: python -m tests.fuzz.long --scenes 2000 --seed 1 -o FOLDER

Goes on after a finding. Prints how the scenes ended; every finding's spec is kept in the
folder, with what was wrong as its first line.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

import yaml
from hypothesis import HealthCheck, Phase, given, seed, settings

from tests.fuzz.judge import judged
from tests.fuzz.scenes import specs

MOST_KEPT = 2
"""Specs kept of every way to end early, for a look."""


def main() -> None:
    """Draw, judge, count."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--output", type=Path, default=Path("fuzz"))
    given_ = parser.parse_args()
    given_.output.mkdir(parents=True, exist_ok=True)
    endings: Counter[str] = Counter()
    slowest: list[tuple[float, int]] = []
    findings = 0

    @seed(given_.seed)
    @settings(
        max_examples=given_.scenes,
        deadline=None,
        database=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(spec=specs())
    def scenes(spec: dict[str, Any]) -> None:
        nonlocal findings
        began, count = time.perf_counter(), sum(endings.values())
        with tempfile.TemporaryDirectory() as folder:
            verdict = judged(spec, Path(folder))
        endings[verdict.ending] += 1
        slowest.append((time.perf_counter() - began, count))
        if verdict.ending not in ("complete", "refused") and endings[verdict.ending] <= MOST_KEPT:
            text = f"# {verdict.ending}\n{yaml.safe_dump(spec)}"
            (given_.output / f"ended_{count:05d}.yaml").write_text(text, encoding="utf-8")
        if verdict.complaints:
            findings += 1
            text = f"# {'; '.join(verdict.complaints)}\n{yaml.safe_dump(spec)}"
            (given_.output / f"finding_{count:05d}.yaml").write_text(text, encoding="utf-8")
            print(count, verdict.ending, "; ".join(verdict.complaints)[:200], flush=True)

    scenes()
    for ending, count in endings.most_common():
        print(f"{count:6d}  {ending}")
    print("slowest [s, scene]:", [(round(s, 1), k) for s, k in sorted(slowest)[-5:]])
    print(f"{sum(endings.values())} scenes of seed {given_.seed}, {findings} findings")


if __name__ == "__main__":
    main()
