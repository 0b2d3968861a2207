"""Colours of gauge pressures."""

from __future__ import annotations

import numpy as np
from matplotlib.colors import Colormap, ListedColormap, Normalize

from viscodesign.report.layout.look import look
from viscodesign.storage.disk_arrays import extremes


def pressure_colours(pressure: np.ndarray) -> tuple[Colormap, Normalize, tuple[float, float]]:
    """Colours of pressures (T, B) [Pa]: their map, their norm [kPa], and the range that occurs.

    Red above, blue below the ambient, white at it. Pressures that all lie far from the ambient
    get the range between themselves instead, or the differences that bend the actuator could
    not be seen.
    """
    lows, highs = extremes(pressure)
    low, high = float(lows.min()) / 1e3, float(highs.max()) / 1e3
    largest = max(abs(low), abs(high))
    if largest == 0.0:
        return look().diverging, Normalize(-1.0, 1.0), (-1.0, 1.0)
    if low * high > 0 and 1e-6 * largest < high - low < 0.4 * largest:
        part = np.linspace(0.55, 1.0, 256) if low > 0 else np.linspace(0.0, 0.45, 256)
        return ListedColormap(look().diverging(part)), Normalize(low, high), (low, high)
    return look().diverging, Normalize(-largest, largest), (min(low, 0.0), max(high, 0.0))
