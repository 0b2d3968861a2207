"""What a shell offers for a word that is being typed; imported by the words of every command.

Everything is looked up when a shell asks, so that setting up a command takes no longer.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

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
    from viscodesign.effects.catalogue import option_kinds
    from viscodesign.scene.reading.field_lookup import fields_below
    from viscodesign.scene.scene import Scene

    fields = dict(fields_below(Scene, ""))
    for name, options in option_kinds().items():
        fields |= fields_below(options, f"effects.{name}.")
    found = {key: field.description or "" for key, field in fields.items()}
    found |= {f"effects.{name}": text for name, text in _effects()}
    yield from found.items()


def _effects() -> Iterator[Offer]:
    from viscodesign.effects.catalogue import catalogue

    for name, kind in catalogue().items():
        yield name, " ".join((kind.__doc__ or name).partition("\n\n")[0].split())


def _words_of(key: str) -> tuple[str, ...]:
    """The words that the value of a key may be; none where it is a number."""
    path = tuple(key.split("."))
    is_of_effects = path[0] == "effects"
    if is_of_effects and (len(path) < 3 or path[2] == "mode"):
        return MODES
    from viscodesign.scene.reading.allowed_values import words_at
    from viscodesign.scene.reading.document import Document

    document = Document("")
    if is_of_effects:
        from viscodesign.loading import known_effects

        document.effects = known_effects()
    return words_at(path, document)


def _beginning(incomplete: str, offers: Iterator[Offer]) -> list[Offer]:
    return [offer for offer in offers if offer[0].startswith(incomplete)]
