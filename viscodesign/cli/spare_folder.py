"""Results that took long to compute and do not fit where they were wanted."""

from __future__ import annotations

import contextlib
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from viscodesign.errors import OutputError, UsageError

Written = TypeVar("Written")


def written(write: Callable[[Path], Written], folder: Path) -> Written:
    """What ``write`` returns for a folder.

    Where that is refused after all (a full disk, a share that is gone), everything is written to
    a new folder among the system's temporary files instead. Raises `OutputError`, which says
    where it is, or that it is nowhere.
    """
    try:
        return write(folder)
    except (OutputError, UsageError) as error:
        with contextlib.suppress(OSError):  # not empty
            folder.rmdir()
        raise OutputError(f"{error}\n{_kept_elsewhere(write, folder)}") from error


def _kept_elsewhere(write: Callable[[Path], object], folder: Path) -> str:
    try:
        spare = Path(tempfile.mkdtemp(prefix=f"viscodesign-{folder.name}-"))
    except OSError as error:
        return f"nothing could be kept elsewhere: {error.strerror or error}"
    try:
        write(spare)
    except (OutputError, UsageError) as error:
        shutil.rmtree(spare, ignore_errors=True)
        return f"nothing could be kept elsewhere: {error}"
    return f"the results are in {spare} instead: move them to where there is room"
