"""What a shell offers for a word that is being typed; imported by the words of every command.

Everything is looked up when a shell asks, so that setting up a command takes no longer.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pydantic import BaseModel

Offer = tuple[str, str]
"""A word and what it is."""
MODES = ("auto", "on", "off")
SUFFIXES = (".yaml", ".yml")


def spec_files(incomplete: str) -> list[str]:
    """Specs whose path begins so; where there are none, a shell offers all files."""
    typed = Path(incomplete)
    folder = typed if incomplete.endswith("/") else typed.parent
    beginning = "" if incomplete.endswith("/") else typed.name
    head = incomplete[: len(incomplete) - len(beginning)]
    try:
        names = sorted(p.name for p in folder.iterdir() if p.suffix.lower() in SUFFIXES)
    except OSError:
        return []
    return [head + name for name in names if name.startswith(beginning)]


def template_names(incomplete: str) -> list[Offer]:
    """Bundled specs."""
    from viscodesign.cli.templates import templates

    return _beginning(incomplete, ((t.name, t.summary()) for t in templates().values()))


def effect_names(incomplete: str) -> list[Offer]:
    """Effects of the catalogue."""
    return _beginning(incomplete, _effects())


def override_keys(incomplete: str) -> list[Offer]:
    """Keys of a spec with `=`; behind that, the words that a key may have."""
    key, equals, _ = incomplete.partition("=")
    if not equals:
        return _beginning(incomplete, ((f"{name}=", text) for name, text in spec_keys()))
    return _beginning(incomplete, ((f"{key}={word}", "") for word in _words_of(key)))


def spec_keys() -> Iterator[Offer]:
    """Every key of a spec that `--set` can name, with its meaning."""
    from viscodesign.scene.scene import Scene

    found = dict(_keys_below(Scene, ""))
    found |= {f"effects.{name}": text for name, text in _effects()}
    yield from found.items()


def _effects() -> Iterator[Offer]:
    from viscodesign.effects.catalogue import catalogue

    for name, kind in catalogue().items():
        yield name, " ".join((kind.__doc__ or name).partition("\n\n")[0].split())


def _keys_below(model: type[BaseModel], above: str) -> Iterator[Offer]:
    from viscodesign.scene.effects_choice import EffectsChoice

    for name, found in model.model_fields.items():
        key = f"{above}{found.alias or name}"
        yield key, found.description or ""
        for part in _models(found.annotation):
            if part is not EffectsChoice:
                yield from _keys_below(part, f"{key}.")


def _models(annotation: Any) -> list[type[BaseModel]]:
    """The parts of a spec that a field may hold."""
    from pydantic import BaseModel

    from viscodesign.scene.reading.field_lookup import alternatives

    kinds = [kind for kind in alternatives(annotation) if isinstance(kind, type)]
    return [kind for kind in kinds if issubclass(kind, BaseModel)]


def _words_of(key: str) -> tuple[str, ...]:
    """The words that the value of a key may be; none where it is a number."""
    if key == "effects" or key.startswith("effects."):
        return MODES
    from viscodesign.scene.reading.allowed_values import words_at

    return words_at(tuple(key.split(".")))


def _beginning(incomplete: str, offers: Iterator[Offer]) -> list[Offer]:
    return [offer for offer in offers if offer[0].startswith(incomplete)]
