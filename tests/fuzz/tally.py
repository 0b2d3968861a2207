"""Summary table of many trials."""

from __future__ import annotations

import statistics
from collections import Counter, defaultdict
from dataclasses import dataclass, field

Numbers = dict[str, float]


@dataclass
class Tally:
    """Counts of endings, findings, seconds and numbers of trials."""

    title: str
    endings: Counter[str] = field(default_factory=Counter)
    findings: list[tuple[int, str]] = field(default_factory=list)
    seconds: list[tuple[float, int]] = field(default_factory=list)
    numbers: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))

    def add(self, number: int, ending: str, problems: str, seconds: float, told: Numbers) -> None:
        """Add a trial."""
        self.endings[ending] += 1
        self.seconds.append((seconds, number))
        if problems:
            self.findings.append((number, problems))
        for name, value in told.items():
            self.numbers[name].append(value)

    @property
    def count(self) -> int:
        """Number of trials."""
        return sum(self.endings.values())

    def table(self) -> str:
        """The table in Markdown."""
        lines = [f"## {self.title}", "", "| ending | trials |", "|---|---:|"]
        lines += [f"| {ending} | {n} |" for ending, n in self.endings.most_common()]
        lines += [f"| **all** | **{self.count}** |", "", f"{len(self.findings)} findings."]
        lines += [f"- {number}: {told[:300]}" for number, told in sorted(self.findings)]
        if self.seconds:
            times = sorted(self.seconds)
            worst = ", ".join(f"{s:.1f} s (number {k})" for s, k in times[:-4:-1])
            middle = statistics.median(s for s, _ in times)
            lines += [
                "",
                f"CPU time of a trial: median {middle:.3g} s; largest {worst}.",
            ]
        lines += [f"{self._numbers(name)}" for name in sorted(self.numbers)]
        return "\n".join(lines) + "\n"

    def _numbers(self, name: str) -> str:
        values = sorted(self.numbers[name])
        if name.endswith("compared"):
            return f"- {name}: {len(values)}"
        high = values[int(0.99 * (len(values) - 1))]
        return (
            f"- {name}: {len(values)} values, median {statistics.median(values):.2g}, "
            f"99 % below {high:.2g}, largest {values[-1]:.2g}"
        )
