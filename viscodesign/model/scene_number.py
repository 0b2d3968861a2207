"""Marks of dataclass fields whose values are no part of a structure; see `structure`."""

from __future__ import annotations

SCENE_NUMBER = {"scene number": "may decide what is formulated by being None, zero or infinite"}
"""Metadata of a dataclass field whose value enters formulas as a parameter, never as a constant."""
PARAMETER_VALUE = {"scene number": "decides nothing"}
"""The same of a field that nothing but a solver ever reads."""
