"""`spec:` the version of the keys."""

from __future__ import annotations

from typing import Any, Final, Literal

from viscodesign.errors import described

SPEC_VERSION: Final[Literal[1]] = 1
"""Version of the keys that this package reads; it rises when a key changes its meaning."""


def version_problem(given: Any) -> str:
    """Why keys of this version cannot be read, and what to do; empty where they can."""
    if isinstance(given, int) and not isinstance(given, bool):
        if given == SPEC_VERSION:
            return ""
        if given > SPEC_VERSION:
            return (
                f"the keys of this spec are of version {given}; this viscodesign reads version "
                f"{SPEC_VERSION} only. Install a newer viscodesign, or rewrite the spec for "
                f"`spec: {SPEC_VERSION}` (docs/keys.md)"
            )
        return f"there is no version {given} of the keys; write `spec: {SPEC_VERSION}`"
    return f"expected {SPEC_VERSION}, the version of the keys; got {described(given)}"
