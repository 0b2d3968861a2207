"""The film that a command makes beside its other files."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from pathlib import Path
from typing import Any

from viscodesign.errors import InterruptedRunError


def film_file(film: Path | None, **options: Any) -> AbstractContextManager[None]:
    """A film that can be made and written, before all that it shows is computed within.

    ``options``: those of `FilmOptions`. Raises `UsageError` for one that cannot.
    """
    from viscodesign.report.film.film_plan import FilmOptions
    from viscodesign.report.folder import new_file

    if film is None:
        return nullcontext()
    FilmOptions(**options).checked(film)
    return new_file(film)


@contextmanager
def told_what_is_kept(files: Sequence[Path], film: Path | None) -> Iterator[None]:
    """An interrupt as an error that says what there is: the files, and an earlier film or none."""
    try:
        yield
    except KeyboardInterrupt:
        kept = f"written before: {', '.join(map(str, files))}" if files else "nothing was written"
        earlier = "" if film is None or film in files else _of_film(film)
        raise InterruptedRunError(f"interrupted; {kept}{earlier}") from None


def _of_film(film: Path) -> str:
    return f"; {film} is still the earlier one" if film.exists() else f"; there is no {film}"
