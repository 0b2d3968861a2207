"""What many trials came to, as a table."""

from __future__ import annotations

import statistics
from collections import Counter, defaultdict
from dataclasses import dataclass, field

Numbers = dict[str, float]


@dataclass
class Tally:
    """Endings, findings, seconds and numbers of trials, added up."""

    title: str
    endings: Counter[str] = field(default_factory=Counter)
    findings: list[tuple[int, str]] = field(default_factory=list)
    seconds: list[tuple[float, int]] = field(default_factory=list)
    numbers: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))

    def add(self, number: int, ending: str, complaints: str, seconds: float, told: Numbers) -> None:
        """One trial more."""
        self.endings[ending] += 1
        self.seconds.append((seconds, number))
        if complaints:
            self.findings.append((number, complaints))
        for name, value in told.items():
            self.numbers[name].append(value)

    @property
    def count(self) -> int:
        """How many trials."""
        return sum(self.endings.values())

    def table(self) -> str:
        """In Markdown."""
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
                f"Processor time of a trial: {middle:.3g} s in the median; worst {worst}.",
            ]
        lines += [f"{self._numbers(name)}" for name in sorted(self.numbers)]
        return "\n".join(lines) + "\n"

    def _numbers(self, name: str) -> str:
        values = sorted(self.numbers[name])
        if name.endswith("compared"):
            return f"- {name}: {len(values)}"
        high = values[int(0.99 * (len(values) - 1))]
        return (
            f"- {name}: {len(values)} told, median {statistics.median(values):.2g}, "
            f"99 % below {high:.2g}, largest {values[-1]:.2g}"
        )
