"""The one error of native code that cannot be had."""

from __future__ import annotations

from viscodesign.errors import ViscodesignError


class NativeUnavailable(ViscodesignError):  # noqa: N818 (a state of this machine, not a mistake)
    """No native code here: llvmlite is missing or refuses, or VISCODESIGN_NATIVE is off."""
