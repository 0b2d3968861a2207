"""What was probably meant by a text that is not one number and one unit."""

from __future__ import annotations

import re
import unicodedata

_DIGITS = r"[0-9]+(?:[.][0-9]+)?"
_SLIPS: tuple[tuple[str, str], ...] = (
    (
        r"[-+0-9.eE]+ *[^0-9.\[\]]*[^\W\d]\.[^\W\d].*",
        "a product of units has the sign '*', not a point",
    ),
    (
        r"[-+0-9.eE]+ *[^\W\d].*[^\W\d]-[1-4]",
        "a power has the sign '^', as in 'kg*m^-3', or use '/'",
    ),
    (
        r"[+-]?[1-9][0-9]{0,2},[0-9]{3}(?![0-9.,]).*",
        "a comma is not read: '{joined}', or '{point}'",
    ),
    (
        r"[+-]?[0-9]{1,3}(?:[ '][0-9]{3})+(?![0-9]).*",
        "thousands are written without separators: '{joined}'",
    ),
    (
        r"[+-]?[0-9]{1,3}(?:,[0-9]{3}){2,}.*|[+-]?[0-9]{1,3}(?:,[0-9]{3})+\..*",
        "thousands are written without separators: '{joined}'",
    ),
    (r"[+-]?[0-9]*,[0-9]+(?:\D.*)?", "a decimal point is meant, not a comma: '{point}'"),
    (r"[+-]?[0-9.]*[0-9]_[0-9][0-9_.]*.*", "digits are written without underscores: '{joined}'"),
    (
        r"[+-]?[0-9.]+_+[^\W\d_].*",
        "between a number and its unit stands a space, not an underscore",
    ),
    (
        r".*(?:\+ ?/? ?-|±|\+-).*",
        "a tolerance is not part of a value; write the number alone",
    ),
    (
        r"[+-]?[0-9.]+ *\([0-9.]+\).*",
        "brackets after a number (an uncertainty?) are not part of a value; write the number alone",
    ),
    (r"[+-]?0[xXoObB][0-9a-fA-F]+.*", "only decimal digits are read"),
    (r"[0-9]+:[0-9:.]+.*", "a clock time is not supported; write seconds, such as '90 s'"),
    (
        r"[<>~≈≤≥].*|(?:ca|about|approx|circa)\b.*",
        "a value is exact; leave out the sign or word before the number",
    ),
    (
        rf"[+-]?{_DIGITS} +[0-9]+/[0-9]+.*|[+-]?{_DIGITS} */ *{_DIGITS}.*",
        "a fraction is not computed; write it as a decimal number",
    ),
    (
        rf"[+-]?{_DIGITS} *[eE] +[+-]?[0-9].*|[+-]?{_DIGITS} +[eE][+-]?[0-9].*",
        "a number has no space before its exponent",
    ),
    (
        rf"[+-]?{_DIGITS} *(?:\*|x|×|\^|\*\*) *10 *(?:\^|\*\*)? *[+-]?[0-9]+.*",
        "powers of ten are written like 3.4e-9",
    ),
    (
        rf"[+-]?{_DIGITS}.* *(?:\.\.|…|–|—| to | - |(?<![eE^])-) *[+-]?{_DIGITS}.*",
        "a range is not a value; write one number",
    ),
    (
        rf"[+-]?{_DIGITS}.* *[*×x] *{_DIGITS}.*",
        "products are not computed; write the result",
    ),
    (
        rf"[+-]?{_DIGITS}.*[+/] *{_DIGITS}.*",
        "sums and quotients are not computed; write the result",
    ),
    (
        r"[(\[{].*|.*[(\[{].*",
        "brackets around a number or a unit are not supported; remove them",
    ),
    (
        rf"[+-]?{_DIGITS}.*[^\w.^*]-?{_DIGITS}.*",
        "there are two numbers; write one number and one unit",
    ),
)


def slip(text: str) -> str:
    """What was probably meant by a text outside of the grammar; '' if nothing is known."""
    if odd := next((c for c in text if is_look_alike(c)), None):
        return f"contains {named(odd)}; use ordinary digits, signs and spaces"
    if not any(c.isnumeric() for c in text):
        return ""
    for pattern, words in _SLIPS:
        if re.fullmatch(pattern, text, re.DOTALL):
            joined = re.sub(r"(?<=[0-9])[ ',_]+(?=[0-9])", "", text)
            return words.format(joined=joined, point=text.replace(",", ".", 1))
    return ""


def is_look_alike(char: str) -> bool:
    """Characters beyond ASCII that look like a digit, a sign or a space, or stand for several."""
    if char.isascii() or char in "⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹":
        return False
    return (
        unicodedata.category(char) in ("Nd", "No", "Nl", "Zs", "Cf") or char in "−‐‑‒．，：＋－＿٫٬"
    )


def odd_letter(text: str) -> str:
    """The first character of a word that only looks like its letters, by name; '' if none does.

    Words of specs are ASCII, and of other letters units have only micro, ohm and ångström.
    """
    odd = next((c for c in text if not c.isascii() and c not in "µμΩΩÅÅ°·⋅²³"), None)
    return named(odd) if odd else ""


def named(char: str) -> str:
    """The Unicode name and number of a character."""
    return f"{unicodedata.name(char, 'an unnamed character').lower()} (U+{ord(char):04X})"
