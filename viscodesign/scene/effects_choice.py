"""`effects:` which effects a scene includes, excludes or leaves to automatic selection.

An effect may have options of its own: `effects: {wall: {mode: on, distance: 20 mm}}`. What they are
says the catalogue of effects, which this module does not know: it comes with the context. Read
without one, as the report of a run is, a scene has the modes alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import Annotated, Any, Literal, NamedTuple, cast

from pydantic import (
    Field,
    PlainValidator,
    SerializationInfo,
    ValidationInfo,
    model_serializer,
    model_validator,
)
from pydantic.fields import FieldInfo

from viscodesign.errors import did_you_mean, not_among
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import (
    KeyFault,
    KeyPath,
    PartT,
    SpecPart,
    copied,
    invalid,
    raise_faults,
    switch,
)

Mode = Literal["auto", "on", "off"]
MODES = ("auto", "on", "off")
EFFECTS = "effects"
"""The key of this section."""
OTHERS = "others"
MODE = "mode"
"""The key of an effect's mode beside its options."""
OPTIONS = "options"
"""The field that holds them: no key of a spec, but a part of pydantic's places."""
EFFECTS_WORDS = "auto, or effect: auto | on | off, or {mode, options of its own}"
"""What a spec may say here."""
KNOWN_EFFECTS = "known_effects"
"""Key of the validation context under which a `KnownEffects` is."""


@dataclass(frozen=True)
class KnownEffects:
    """What `effects:` may contain."""

    names: tuple[str, ...]
    options: Mapping[str, type[SpecPart]] = field(default_factory=dict)
    """The options of those that have some, by name."""


class _Entry(NamedTuple):
    """What is said of one effect."""

    mode: Any
    """None where only its options are stated."""
    kind: type[SpecPart] | None
    """The class of its options; None where it has none."""
    options: Any
    """The same as given, or validated."""


def _read(entry: _Entry, info: ValidationInfo) -> SpecPart:
    """The options of an effect; pydantic places their faults below its name."""
    kind = entry.kind
    assert kind is not None
    return kind.model_validate(entry.options, context=info.context)


class EffectsChoice(SpecPart):
    """A mode for each named effect, one for all others, and the options of effects.

    The options of an effect that a spec does not name are the defaults. Options without a mode
    leave it to `others`.
    """

    modes: dict[str, Mode] = Field(default_factory=dict, description="Mode of each named effect")
    others: Mode = Field("auto", description="Mode of all other effects")
    options: dict[str, Annotated[Any, PlainValidator(_read)]] = Field(
        default_factory=dict, description="Options of each named effect that has some"
    )

    @model_validator(mode="before")
    @classmethod
    def _normalize(cls, given: Any, info: ValidationInfo) -> Any:
        if isinstance(given, EffectsChoice):
            return given
        if not isinstance(given, dict):
            if (mode := _mode(given)) is None:
                raise invalid(not_among(given, MODES, "a mapping of effect: mode"))
            return {"others": mode}
        known: KnownEffects | None = (info.context or {}).get(KNOWN_EFFECTS)
        raise_faults(_faults(given, known))
        entries = {str(name): _entry(str(name), own, known) for name, own in given.items()}
        others = entries.pop(OTHERS, None)
        return {
            "modes": {n: _mode(own.mode) for n, own in entries.items() if own.mode is not None},
            "others": "auto" if others is None else _mode(others.mode),
            OPTIONS: {n: own for n, own in entries.items() if own.kind is not None},
        }

    def mode(self, name: str) -> Mode:
        """The mode of an effect."""
        return self.modes.get(name, self.others)

    def options_of(self, name: str, kind: type[PartT]) -> PartT:
        """The options of an effect, of their class ``kind``: those stated, or the defaults."""
        return cast(PartT, self.options[name]) if name in self.options else kind()

    def with_modes(self, modes: Mapping[str, Any], others: Mode = "auto") -> EffectsChoice:
        """The same options with other modes, which are not validated."""
        return copied(self, {"modes": dict(modes), "others": others})

    def with_options(self, options: Mapping[str, SpecPart]) -> EffectsChoice:
        """The same modes with the options of some effects replaced or added."""
        return copied(self, {OPTIONS: {**self.options, **options}})

    def as_in_a_spec(self, plain: Callable[[SpecPart], dict[str, Any]]) -> dict[str, Any]:
        """Modes and options by effect; ``plain`` makes a mapping of options."""
        found: dict[str, Any] = dict(self.modes)
        for name, own in self.options.items():
            mode = {MODE: self.modes[name]} if name in self.modes else {}
            found[name] = mode | plain(own)
        return {**found, OTHERS: self.others}

    @model_serializer
    def _as_in_a_spec(self, info: SerializationInfo) -> dict[str, Any]:
        return self.as_in_a_spec(lambda own: own.model_dump(mode=info.mode))

    def keyed_fields(self) -> Iterator[tuple[str, Any, FieldInfo]]:
        for name, own in self.options.items():
            yield name, own, FieldInfo(annotation=type(own))

    def with_keys(self, values: Mapping[str, Any]) -> EffectsChoice:
        return self.with_options(values)

    def _keys_with(self, fields: Mapping[str, Any]) -> dict[str, Any]:
        modes, others, options = (
            fields.get(name, getattr(self, name)) for name in ("modes", OTHERS, OPTIONS)
        )
        kinds = {name: type(own) for name, own in self.options.items()}
        kinds |= {name: type(own) for name, own in options.items() if isinstance(own, SpecPart)}
        stated = {n: _Entry(modes.get(n), kinds.get(n), own) for n, own in options.items()}
        return {**modes, **stated, OTHERS: others}


def is_effect(path: Sequence[str]) -> bool:
    """Whether a key of a spec is that of an effect."""
    return len(path) == 2 and path[0] == EFFECTS


def mapping_of(path: KeyPath, word: Any) -> dict[str, Any]:
    """The mapping that a word at a key of a spec abbreviates.

    Under `effects` it has a key for what the word says: `gravity: on` is {mode: on}. Of other
    sections a word such as `gravity: on` says only that they are there.
    """
    if word is None:
        return {}
    return {OTHERS: word} if path == (EFFECTS,) else {MODE: word} if is_effect(path) else {}


def _mode(given: Any) -> str | None:
    """The mode that a YAML value means, or None."""
    words = {True: "on", False: "off", "auto": "auto"}
    given = switch(given)
    return words.get(given) if isinstance(given, (bool, str)) else None


def _entry(name: str, given: Any, known: KnownEffects | None) -> _Entry:
    """What is said of an effect, by a word or by a mapping."""
    if isinstance(given, _Entry):
        return given
    kind = known.options.get(name) if known is not None else None
    if not isinstance(given, dict):
        return _Entry(given, kind, {})
    return _Entry(given.get(MODE), kind, {k: own for k, own in given.items() if k != MODE})


def _faults(given: dict[Any, Any], known: KnownEffects | None) -> Iterator[KeyFault]:
    """Unknown names and modes; names are checked only where the known ones are given."""
    for name, value in given.items():
        path = (str(name),)
        if known is not None and name not in (*known.names, OTHERS):
            allowed = f"one of the effects {', '.join(known.names)}"
            yield KeyFault(path, f"no such effect{did_you_mean(name, known.names)}", allowed)
        else:
            yield from _value_faults(path, value, known)


def _value_faults(path: KeyPath, value: Any, known: KnownEffects | None) -> Iterator[KeyFault]:
    """An unknown mode, or options of an effect that has none."""
    allowed = f"one of {', '.join(MODES)}"
    if isinstance(value, _Entry) and value.kind is None:
        yield KeyFault(path, "this effect has no options")
    elif isinstance(value, _Entry):
        if value.mode is not None and _mode(value.mode) is None:
            yield KeyFault(path, not_among(value.mode, MODES), allowed)
    elif isinstance(value, dict) and (known is None or path[0] in known.options):
        if MODE in value and _mode(value[MODE]) is None:
            yield KeyFault((*path, MODE), not_among(value[MODE], MODES), allowed)
    elif isinstance(value, dict) and path[0] != OTHERS:
        yield KeyFault(path, f"this effect has no options; {not_among(value, MODES)}", allowed)
    elif _mode(value) is None:
        yield KeyFault(path, not_among(value, MODES), allowed)
