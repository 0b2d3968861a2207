"""Values of free numbers and names as users give them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Protocol, runtime_checkable

import numpy as np

from viscodesign.errors import SpecError, did_you_mean


@runtime_checkable
class Labelled(Protocol):
    """Values by label: a mapping, a pandas series, a row or a data frame."""

    def keys(self) -> Iterable[str]: ...

    def __getitem__(self, label: str) -> Any: ...


Values = Sequence[float] | np.ndarray | Labelled


def values_in_order(values: Values | None, names: Sequence[str], own: np.ndarray) -> np.ndarray:
    """Values in the order of ``names`` (f,); ``own`` (f,): those where none are given."""
    if values is None:
        return own.copy()
    if not isinstance(values, np.ndarray) and isinstance(values, Labelled):
        all_of_them = dict(zip(names, own.tolist(), strict=True))
        given = [values[name] for name in _only_known(values, names)]
        all_of_them |= dict(zip(values.keys(), given, strict=True))
        values = [all_of_them[name] for name in names]
    found = numbers_in(values, "values", "numbers in SI units")
    if found.ndim != 1:
        raise SpecError.plain(
            f"values: must be one number for each of {len(names)}, ({len(names)},); got an array "
            f"of shape {found.shape}"
        )
    return found


def numbers_in(given: Any, what: str, allowed: str) -> np.ndarray:
    """An array of real numbers; raises `SpecError` for anything else."""
    try:
        found = np.array(given)
        # The imaginary part of a step for a derivative would be lost without a word.
        if np.iscomplexobj(found):
            raise SpecError.plain(f"{what}: must be real {allowed}; got {given!r}")
        return found.astype(float)
    except (TypeError, ValueError) as error:
        raise SpecError.plain(f"{what}: must be {allowed}; got {given!r}") from error


def whole_number(given: Any, what: str, least: int, most: int | None = None) -> int:
    """A whole number in a range; raises `SpecError` for anything else."""
    is_whole = isinstance(given, (int, np.integer)) and not isinstance(given, bool)
    if not is_whole or given < least or (most is not None and given > most):
        allowed = f"of at least {least}" if most is None else f"from {least} to {most}"
        raise SpecError.plain(f"{what}: must be a whole number {allowed}; got {given!r}")
    return int(given)


def listed_rows(rows: Iterable[Values] | np.ndarray, names: Sequence[str]) -> list[Values]:
    """Rows one by one; a data frame is read by its columns."""
    if isinstance(rows, Labelled):
        return list(np.transpose([np.asarray(rows[name]) for name in _only_known(rows, names)]))
    return list(rows)


def names_of(what: str, given: Sequence[str]) -> tuple[str, ...]:
    """Names as they were given; one alone is a sequence of one."""
    found = (
        [given] if isinstance(given, str) else list(given) if isinstance(given, Iterable) else []
    )
    if not found or not all(isinstance(name, str) for name in found):
        raise SpecError.plain(f"{what}: name at least one, as text; got {given!r}")
    return tuple(found)


def _only_known(labelled: Labelled, names: Sequence[str]) -> list[str]:
    """Labels, all of them free numbers."""
    labels = list(labelled.keys())
    unknown = [label for label in labels if label not in names]
    if unknown:
        hint = did_you_mean(unknown[0], names)
        raise SpecError.plain(f"{unknown[0]}: no free number of this function{hint}")
    return labels
