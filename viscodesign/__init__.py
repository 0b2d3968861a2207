"""Design soft actuators that move by the viscosity of their fluid."""

from viscodesign._version import __version__

__all__ = ["__version__"]
