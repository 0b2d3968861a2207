"""What a run was computed with."""

from __future__ import annotations

import platform
import sys
from typing import Any

from viscodesign._version import __version__

PACKAGES = ("casadi", "llvmlite", "numpy", "scipy")
"""Packages that numbers come from."""


def provenance() -> dict[str, Any]:
    """Versions of this program, of Python and of the packages in use, and the platform."""
    # Asking for the version of a package that is not in use would cost more than a run.
    used = {name: sys.modules[name] for name in PACKAGES if name in sys.modules}
    return {
        "version": __version__,
        "python": platform.python_version(),
        "packages": {name: str(module.__version__) for name, module in used.items()},
        "platform": f"{platform.system()} {platform.machine()}",
    }
