"""What the paper prints about Figure 1: its own timescales, and the quadrants of others."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Classification, Scales
from viscodesign.results.paper_figure import PaperCheck

LITERATURE = {
    "I": "paper's refs. 14, 27-31",
    "II": "paper's refs. 13, 15, 16, 31",
    "III": "the paper itself",
    "IV": "paper's refs. 12, 17-26",
}
"""Published robots by quadrant, as section 1 lists them; their ratios are not printed."""
T_S, T_F, T_I = 0.029, 0.157, 0.74
"""As printed in sections 2.1 and 3.2, of the 16-bellow leg in air [s]."""
PRINTED = Classification(
    "printed in the paper, air", Scales(T_S, T_F, T_I, math.nan), "III", "as printed", math.nan
)
AIR, WATER = "leg_16_straight_air", "leg_16_straight_water"


@dataclass(frozen=True)
class PrintedNumber:
    """A number that the paper prints of a scene."""

    section: str
    words: str
    spec: str
    value: float
    last_digit: float
    """Value of one unit of its last digit."""
    of: Callable[[Scales], float]
    unit: str = ""

    def check(self, found: Classification) -> PaperCheck:
        """Whether the scene's own number rounds to it."""
        own = self.of(found.scales)
        agrees = abs(own - self.value) <= self.last_digit / 2 * (1 + 1e-9)
        text = f"{own:.3g} {self.unit}".rstrip()
        return PaperCheck(1, "", self.section, self.words, agrees, text)


PRINTED_NUMBERS = (
    PrintedNumber("2.1", "t_s = 0.029 s", AIR, T_S, 1e-3, lambda s: s.t_s, "s"),
    PrintedNumber("2.1", "t_f = 0.157 s", AIR, T_F, 1e-3, lambda s: s.t_f, "s"),
    PrintedNumber("3.2", "t_i = 0.74 s", AIR, T_I, 1e-2, lambda s: s.t_i, "s"),
    PrintedNumber("3.2", "air: t_s/t_f is about 0.2", AIR, 0.2, 0.1, lambda s: s.t_s / s.t_f),
    PrintedNumber(
        "3.2", "water: t_s/t_f is about 0.004", WATER, 4e-3, 1e-3, lambda s: s.t_s / s.t_f
    ),
    PrintedNumber("3.2", "t_s/t_i = 0.04", AIR, 0.04, 1e-2, lambda s: s.t_s / s.t_i),
)


def timescale_checks(found: Mapping[str, Classification]) -> tuple[PaperCheck, ...]:
    """Statements about Figure 1, of classified specs by name."""
    air, water = (found[name].scales.ratios["ts_over_tf"] for name in (AIR, WATER))
    decades = math.log10(air / water)
    return (
        *(number.check(found[number.spec]) for number in PRINTED_NUMBERS),
        PaperCheck(
            1, "", "3.2", "air has a ratio t_s/t_f two orders of magnitude above that of water",
            round(decades) == 2, f"{air / water:.3g} times, {decades:.2g} orders of magnitude",
        ),
        PaperCheck(
            1, "", "1", "the leg operates in quadrant (III)",
            found[AIR].quadrant == "III", f"quadrant ({found[AIR].quadrant})",
        ),
    )  # fmt: skip
