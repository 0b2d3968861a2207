"""`viscodesign effects`: the catalogue of effects, documented by their classes."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any

import typer

from viscodesign.cli.completion import effect_names
from viscodesign.cli.options import Answer, Output

if TYPE_CHECKING:
    from viscodesign.effects.base import Effect

EXAMPLE = """\b
Examples:
  viscodesign effects
  viscodesign effects gravity
  viscodesign effects --json"""


def command(
    name: Annotated[
        str | None,
        typer.Argument(metavar="NAME", help="The effect to describe.", autocompletion=effect_names),
    ] = None,
    output: Output = None,
    *,
    answer: Answer,
) -> None:
    """List the effects, or describe one.

    Shows what each effect is, the weight that says when it matters, its range of validity,
    its source and its keys in a spec. With -o also writes DIR/effects.json.
    """
    from viscodesign.cli.output import json_text, write_text
    from viscodesign.effects.catalogue import catalogue

    known = catalogue()
    chosen = known if name is None else {name: _found(name, known)}
    document = {"effects": [_document(kind) for kind in chosen.values()]}
    if output is not None:
        write_text(output / "effects.json", json_text(document) + "\n", overwrite=True)
    answer.give(document, _table(chosen) if name is None else _page(chosen[name]))


def _found(name: str, known: Mapping[str, type[Effect]]) -> type[Effect]:
    from viscodesign.errors import UsageError, did_you_mean

    if name not in known:
        hint = did_you_mean(name, known) or "."
        raise UsageError(f"{name}: no such effect{hint} `viscodesign effects` lists them")
    return known[name]


def _document(kind: type[Effect]) -> dict[str, Any]:
    """Everything that a class documents."""
    return {
        "name": kind.name,
        "summary": _paragraphs(kind)[0],
        "documentation": "\n\n".join(_paragraphs(kind)),
        "formula": kind.formula,
        "validity": kind.validity,
        "source": kind.source,
        "references": [work.text for work in kind.references],
        "keys": _keys(kind),
        "options": _options(kind),
        "needs": list(kind.needs),
        "follows_others": not kind.own_rule,
        "decision": _decision(kind),
    }


def _paragraphs(kind: type[Effect]) -> list[str]:
    """The paragraphs of the class docstring; the first is one sentence."""
    text = inspect.cleandoc(kind.__doc__ or kind.name)
    return [" ".join(part.split()) for part in text.split("\n\n")]


def _keys(kind: type[Effect]) -> list[str]:
    return [f"effects.{kind.name}", *(option["key"] for option in _options(kind)), *kind.keys]


def _options(kind: type[Effect]) -> list[dict[str, Any]]:
    """Every key below that of the effect: what it means, its unit, default and range."""
    from viscodesign.scene.reading.allowed_values import allowed_of
    from viscodesign.scene.reading.field_lookup import fields_below, quantity_of

    found = []
    for key, field in fields_below(kind.options, f"effects.{kind.name}.") if kind.options else ():
        quantity, default = quantity_of(field), field.get_default(call_default_factory=True)
        found.append(
            {
                "key": key,
                "meaning": field.description or "",
                "unit": quantity.unit if quantity is not None else None,
                "default": default if isinstance(default, bool | int | float | str) else None,
                "allowed": allowed_of(field),
            }
        )
    return found


def _decision(kind: type[Effect]) -> str:
    """How it is decided whether a run includes the effect."""
    from viscodesign.effects import select
    from viscodesign.effects.base import Effect

    if kind.own_rule:
        return kind.own_rule
    parts = [f"`effects.{kind.name}: on` includes it, `off` forbids it, `auto` weighs it."]
    parts += inspect.cleandoc(select.__doc__ or "").split("\n\n")[1:]
    if kind.estimate_term is Effect.estimate_term:
        parts.append(
            "The estimate has no term for it: its weight, in actuator lengths, is taken as the "
            "displacement of the tip."
        )
    if kind.indispensable is not Effect.indispensable:
        parts.append("It is included where the scene requires it.")
    if kind.needs:
        parts.append(f"Without {' and '.join(kind.needs)} it is not applicable.")
    if kind.companion is not None:
        parts.append(f"{kind.companion} is included with it.")
    if kind.free_with is not None:
        parts.append(f"It is included beside {kind.free_with}, where it costs nothing.")
    if kind.replaced_by is not None:
        parts.append(f"It is not applicable where {kind.replaced_by} takes its place.")
    return " ".join(" ".join(parts).split())


def _table(known: Mapping[str, type[Effect]]) -> list[str]:
    from viscodesign.cli.texts.layout import table

    rows: list[tuple[str, str]] = []
    for name, kind in known.items():
        rows += [(name, _paragraphs(kind)[0]), ("", f"weight = {kind.formula}")]
    return [*table(rows, indent=""), "", "`viscodesign effects NAME` describes one."]


def _page(kind: type[Effect]) -> list[str]:
    from viscodesign.cli.texts.layout import table, wrap

    facts = {
        "weight": kind.formula,
        "validity": kind.validity,
        "source": kind.source,
        "works": "; ".join(work.text for work in kind.references),
        "spec keys": ", ".join(_keys(kind)),
        "decision": _decision(kind),
    }
    first, *others = _paragraphs(kind)
    lines = wrap(f"{kind.name}: {first}", hanging="  ")
    for paragraph in others:
        lines += wrap(paragraph, "  ")
    rows = [(word, fact) for word, fact in facts.items() if fact]
    return [*lines, "", *table(rows + [(o["key"], _option_words(o)) for o in _options(kind)])]


def _option_words(option: Mapping[str, Any]) -> str:
    """What an option means, what it may be, and its default."""
    unit, default = option["unit"], option["default"]
    number = f"{default:g}" if isinstance(default, float) else default
    in_unit = f" {unit}" if unit not in (None, "1") else ""
    words = [option["meaning"], option["allowed"]]
    return "; ".join([*words, *([] if default is None else [f"default {number}{in_unit}"])])
