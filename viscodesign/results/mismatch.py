"""What a model that does not describe its recordings leaves of them."""

from __future__ import annotations

from typing import Any

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class Mismatch:
    """How far a fitted model is from the recordings, where most, and with which effects."""

    mean_square: float
    """Mean square of what is left of the worst channels, over that of their noise."""
    identified_up_to: float
    """Mean square up to which numbers may count as identified."""
    file: str
    header: str
    """Header of the channel in which most is left."""
    time_s: float
    residual: float
    """Measured minus expected, there and then [unit]."""
    noise: float
    """Standard deviation of that channel's noise [unit]."""
    unit: str
    effects: tuple[str, ...]
    """That were included."""
    effects_left_out: tuple[str, ...]
    """That the spec turns off, and the scene could have."""

    @property
    def leaves_numbers_unknown(self) -> bool:
        """Whether no number counts as identified."""
        return self.mean_square > self.identified_up_to

    def document(self) -> dict[str, Any]:
        """The mismatch for a program."""
        return {
            "mean_square": self.mean_square,
            "identified_up_to": self.identified_up_to,
            "worst": {
                "file": self.file,
                "column": self.header,
                "time_s": self.time_s,
                "residual": self.residual,
                "noise": self.noise,
                "unit": self.unit,
            },
            "effects": list(self.effects),
            "effects_left_out": list(self.effects_left_out),
        }
