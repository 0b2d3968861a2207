"""Fill the computed parts of these pages: python docs/make_pages.py [PAGE ...]

Without a page it fills all, which solves many scenes; `effects`, `keys`, `commands`, `api` and
`quantities` take a moment.
A page is written by hand except for blocks between `<!-- made: NAME -->` and `<!-- made: end -->`;
these are replaced. Pictures go to docs/published_and_called_for/.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from commands_table import commands, public_names
from keys_table import HEAD, coefficient_units, sections
from tip_pair import draw_tips

from viscodesign import AccuracyStudy, Trajectory, accuracy, load, simulate
from viscodesign.citations import every_work
from viscodesign.cli.texts.accuracy_text import seconds
from viscodesign.physics.bellow_estimates import LegSizes, first_coefficients
from viscodesign.report.charts.accuracy import draw_accuracy
from viscodesign.results.channels import channel_table
from viscodesign.results.metrics import metric_table

DOCS = Path(__file__).parent
CONFIGS = DOCS.parent / "configs"
PICTURES = DOCS / "published_and_called_for"
BLOCK = re.compile(r"(<!-- made: ((?!end)\S+) -->\n)(.*?)<!-- made: end -->", re.DOTALL)
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)]+)\)")


def main(names: list[str]) -> None:
    """Fill the pages with these names, or all."""
    makers: dict[str, Callable[[], dict[str, str]]] = {
        "effects": lambda: {"effects": effects_table(), "works": works_list()},
        "measuring": lambda: {"estimates": estimates_table()},
        "keys": lambda: {"keys": keys_tables()},
        "commands": lambda: {"commands": "\n\n".join(commands())},
        "api": lambda: {"names": "\n\n".join(public_names())},
        "quantities": lambda: {"quantities": quantities_table(), "metrics": metrics_table()},
        "accuracy": lambda: {"accuracy": accuracy_block()},
        "published_and_called_for": comparison_blocks,
    }
    for name in names or makers:
        fill(DOCS / f"{name}.md", makers[name]())


def fill(page: Path, blocks: dict[str, str]) -> None:
    """Replace the blocks of a page; raises `ValueError` for one that ``blocks`` lacks."""
    text = page.read_text(encoding="utf-8")
    found = {name for _, name, _ in blocks_of(text)}
    if missing := found - set(blocks):
        raise ValueError(f"{page.name} has blocks that no code makes: {', '.join(sorted(missing))}")
    text = BLOCK.sub(lambda m: f"{m[1]}\n{blocks[m[2]]}\n\n<!-- made: end -->", text)
    page.write_text(text, encoding="utf-8")


def blocks_of(text: str) -> list[tuple[str, str, str]]:
    """Opening comment, name and content of every block of a page."""
    return [(mark, name, content.strip()) for mark, name, content in BLOCK.findall(text)]


def quantities_table() -> str:
    """Every quantity of a run."""
    return table(("column", "what it is", "unit", "where"), list(channel_table()))


def metrics_table() -> str:
    """Every metric of a run."""
    return table(("metric", "what it is"), list(metric_table()))


def keys_tables() -> str:
    """Every key of a spec, section by section."""
    parts = []
    for heading, summary, rows in sections():
        parts += [f"## {heading}", *([summary] if summary else []), table(HEAD, rows)]
    return "\n\n".join(parts)


def estimates_table() -> str:
    """Estimated coefficients of the paper's leg beside its measured ones."""
    scene = load(CONFIGS / "leg_16_straight_air.yaml")
    a, b = scene.actuator, scene.bellows
    sizes = [
        LegSizes(
            a.length, a.height, a.width, b.count, b.height, b.width, b.length, LEG_WALL, fold
        )
        for fold in (0.0, LEG_WALL, 2 * LEG_WALL)
    ]  # fmt: skip
    found = [asdict(first_coefficients(size, a.youngs_modulus)) for size in sizes]
    units = {
        name: "" if quantity.unit == "1" else f" {quantity.unit}"
        for name, quantity in coefficient_units().items()
    }
    rows = []
    for name in found[0]:
        measured = getattr(a, name, None) or getattr(b, name)
        cells = (f"{each[name]:.3g} ({each[name] / measured:.2g} times)" for each in found)
        rows.append((f"`{name}`", f"{measured:.4g}{units[name]}", *cells))
    head = ("key", "measured", "plain walls", "folds of 1 mm", "folds of 2 mm")
    return table(head, rows)


LEG_WALL = 1e-3
"""Half of what the bellows' length leaves of the body's width [m]."""


# -- the table of effects ----------------------------------------------------------------


def effects_table() -> str:
    """Every effect of this version, from `viscodesign effects --json`."""
    command = [sys.executable, "-m", "viscodesign", "effects", "--json"]
    printed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    rows = [_effect_row(effect) for effect in json.loads(printed)["effects"]]
    return table(("effect", "what it is", "weight", "where it holds", "keys"), rows)


def _effect_row(effect: dict[str, Any]) -> tuple[str, ...]:
    needed = " and ".join(f"`{name}`" for name in effect["needs"])
    needs = f" Needs {needed}." if needed else ""
    keys = [key for key in effect["keys"] if key != f"effects.{effect['name']}"]
    return (
        f"`{effect['name']}`",
        effect["summary"] + needs,
        f"`{effect['formula']}`",
        effect["validity"],
        ", ".join(f"`{key}`" for key in keys) or "none but its own",
    )


def works_list() -> str:
    """The works behind effects, fluids and solvers."""
    return "\n".join(f"- {work.text}" for work in every_work())


def table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    """A Markdown table."""
    lines = [head, ("---",) * len(head), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', '/') for cell in line)} |" for line in lines)


# -- what accuracy costs -----------------------------------------------------------------


def accuracy_block() -> str:
    """Draw the picture of the paper's leg; the cost of every error. Run on an idle machine."""
    study = accuracy(load(CONFIGS / "leg_16_straight_air.yaml"))
    draw_accuracy(study, DOCS / "accuracy.png")
    return table(("error", "time to solve", "cheapest setting"), accuracy_rows(study))


def accuracy_rows(study: AccuracyStudy) -> list[tuple[str, ...]]:
    """One for each error that a study gives the cost of."""
    rows = []
    for error in study.errors:
        point = study.cheapest(error)
        time, words = ("", "not reached") if point is None else (
            seconds(point.solve_s), study.words(point)
        )  # fmt: skip
        rows.append((f"{100 * error:g} %", time, words))
    return rows


# -- published and called for ------------------------------------------------------------


@dataclass(frozen=True)
class Pair:
    """A scene with the published model, and with the effects that it needs."""

    name: str
    published: Trajectory
    called_for: Trajectory

    @property
    def apart(self) -> np.ndarray:
        """Distance between the two tips at every output time (T,) [m]."""
        return np.asarray(np.hypot(*(self.published.tip - self.called_for.tip)[:, :2].T))


def comparison_blocks() -> dict[str, str]:
    """Blocks of the page of comparisons, by name."""
    detailed = set(
        re.findall(r"<!-- made: (leg_\S+) -->", (DOCS / PAGE).read_text(encoding="utf-8"))
    )
    blocks, rows = {}, []
    for twin in sorted(CONFIGS.glob("*_auto.yaml")):
        name = twin.stem.removesuffix("_auto")
        print(name, flush=True)
        pair = _solved(name, prove=name in detailed)
        rows.append(_summary_row(pair))
        if name in detailed:
            blocks[name] = _section(pair)
    head = ("scene", "needs in addition", "does not need", "tips apart", "of the accuracy")
    return blocks | {"all": table(head, rows)}


PAGE = "published_and_called_for.md"


def _solved(name: str, prove: bool) -> Pair:
    published = simulate(load(CONFIGS / f"{name}.yaml"))
    called_for = simulate(load(CONFIGS / f"{name}_auto.yaml"), prove=prove)
    for run in (published, called_for):
        if run.status != "complete":
            raise RuntimeError(f"{run.name}: {run.failure}")
    return Pair(name, published, called_for)


def _included(run: Trajectory) -> set[str]:
    return {verdict.name for verdict in run.effects if verdict.taken}


def _summary_row(pair: Pair) -> tuple[str, ...]:
    before, after = _included(pair.published), _included(pair.called_for)
    order = [verdict.name for verdict in pair.published.effects]
    added, left = (
        ", ".join(n for n in order if n in names) or "none"
        for names in (after - before, before - after)
    )
    apart = float(np.max(pair.apart))
    share = apart / pair.called_for.accuracy.requested_m
    return f"`{pair.name}`", added, left, millimetres(apart), multiple(share)


def _section(pair: Pair) -> str:
    picture = PICTURES / f"{pair.name}.png"
    picture.parent.mkdir(exist_ok=True)
    draw_tips(pair.published, pair.called_for, picture)
    worst = int(np.argmax(pair.apart))
    words = (
        f"The tips are {millimetres(float(pair.apart[worst]))} apart at most, at "
        f"t = {pair.called_for.time[worst]:.3g} s. {_extent('Published', pair.published)}; "
        f"{_extent('called for', pair.called_for)}."
    )
    image = f"![Tip of {pair.name}, published and called for]({PICTURES.name}/{picture.name})"
    head = ("effect", "published model", "called for", "estimated", "measured")
    return f"{image}\n\n{words}\n\n{table(head, _verdict_rows(pair))}"


def _extent(words: str, run: Trajectory) -> str:
    x, z = 1e3 * run.tip[:, 0], 1e3 * run.tip[:, 1]
    return f"{words}: x {x.min():.1f} to {x.max():.1f} mm, z {z.min():.1f} to {z.max():.1f} mm"


def _verdict_rows(pair: Pair) -> list[tuple[str, ...]]:
    """Effects that apply to the scene, those that move the tip most first."""
    published = _included(pair.published)
    ablations = sorted(pair.called_for.proof, key=lambda ablation: -ablation.estimated_m)
    return [
        (
            f"`{ablation.name}`",
            "in" if ablation.name in published else "out",
            "in" if ablation.taken else "out",
            millimetres(ablation.estimated_m),
            "none" if ablation.measured_m is None else millimetres(ablation.measured_m)
            + (f" ({ablation.note})" if ablation.note else ""),
        )
        for ablation in ablations
    ]  # fmt: skip


def millimetres(length: float) -> str:
    """Three digits without exponent; zero below a nanometre."""
    value = 1e3 * length
    if value < 1e-6:
        return "0 mm"
    digits = max(0, 2 - int(np.floor(np.log10(value))))
    return f"{value:.{digits}f} mm"


def multiple(share: float) -> str:
    """As a multiple of the requested accuracy."""
    return f"{share:.3g} times" if share >= 0.01 else "nothing"


if __name__ == "__main__":
    main(sys.argv[1:])
