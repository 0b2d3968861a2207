"""The likely slip behind text that is not YAML, in plain words."""

from __future__ import annotations

import re

from viscodesign.values.slips import is_look_alike, named

_NO_SPACE = re.compile(r"\s*(?:- +)?([A-Za-z_][\w-]*:)[^\s:/].*")
_SIGN_FIRST = re.compile(r"\s*(?:- +)?[\w-]+: +([%@`]).*")
_TWO_COLONS = re.compile(r"\s*(?:- +)?[\w-]+: +[^\s'\"{\[|>&*!#][^#]*?:(?: .*|)")
_OPEN_QUOTE = re.compile(r"\s*(?:- +)?[\w-]+: +(?:'[^']*|\"[^\"]*)")


def syntax_slip(text: str, line: int) -> tuple[int, str] | None:
    """The line (from 1) of the likely slip, and its words; None if nothing is known.

    ``line`` is where the parser gave up: at the slip, or behind it. A quote that stays open may
    have been opened anywhere before.
    """
    lines = text.splitlines()
    near = [number for number in (line, line - 1) if 1 <= number <= len(lines)]
    for words in (_tab, _odd_character, _no_space, _sign_first, _two_colons):
        for number in near:
            if found := words(lines[number - 1]):
                return number, found
    opened = next(
        (k for k in range(min(line, len(lines))) if _OPEN_QUOTE.fullmatch(lines[k])), None
    )
    return None if opened is None else (opened + 1, "a quote opens here that is not closed")


def _tab(line: str) -> str:
    indent = line[: len(line) - len(line.lstrip())]
    return "indented with a tab, which YAML does not allow; use spaces" if "\t" in indent else ""


def _odd_character(line: str) -> str:
    odd = next((c for c in line.split(" #")[0] if is_look_alike(c)), None)
    return f"contains {named(odd)}; use ordinary signs and spaces" if odd else ""


def _no_space(line: str) -> str:
    found = _NO_SPACE.fullmatch(line)
    return f"no space behind the colon of '{found[1]}'" if found else ""


def _sign_first(line: str) -> str:
    found = _SIGN_FIRST.fullmatch(line)
    return f"a value that begins with '{found[1]}' needs quotes" if found else ""


def _two_colons(line: str) -> str:
    return "a value with a colon needs quotes" if _TWO_COLONS.fullmatch(line) else ""
