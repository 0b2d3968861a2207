"""Matplotlib imported whatever the desk is set to."""

from __future__ import annotations

import contextlib
import logging
import os
import sys
from typing import Any

BACKEND_VARIABLE = "MPLBACKEND"


def import_matplotlib() -> None:
    """Import matplotlib, whatever backend the environment names and its settings file says.

    A notebook hands its own backend on to the commands that it starts, where that backend may
    not exist: matplotlib would refuse to be imported. Pictures here are written to files and need
    none; one that exists is kept for the user's own windows. What it says about a settings file
    is not about this program, and is not printed.
    """
    if "matplotlib" in sys.modules:
        return
    log = logging.getLogger("matplotlib")
    level, named = log.level, os.environ.pop(BACKEND_VARIABLE, None)
    log.setLevel(logging.CRITICAL)
    try:
        import matplotlib as mpl
    finally:
        log.setLevel(level)
        if named is not None:
            os.environ[BACKEND_VARIABLE] = named
    if named:
        with contextlib.suppress(ValueError):
            mpl.rcParams["backend"] = named


def plain_settings() -> dict[str, Any]:
    """Matplotlib's settings as it comes, without those of a user.

    The backend is left alone, and whether it shows figures by itself.
    """
    import matplotlib as mpl

    defaults: Any = mpl.rcParamsDefault
    return {key: dict.__getitem__(defaults, key) for key in defaults if not _is_of_backend(key)}


def _is_of_backend(key: str) -> bool:
    return "backend" in key or key == "interactive"
