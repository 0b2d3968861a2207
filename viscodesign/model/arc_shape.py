"""The unloaded rod in closed form: one circular arc per section."""

from __future__ import annotations

import numpy as np


def arc_nodes(
    curvature: np.ndarray, stretch: np.ndarray, section_length: float, points_per_section: int
) -> tuple[np.ndarray, np.ndarray]:
    """Axis and tangent angle of sections of constant curvature and stretch.

    ``curvature`` (T, S) [1/m per reference length], ``stretch`` (T, S) total
    stretch lambda [1]. Returns positions (T, K, 2) [m] and angles (T, K) [rad],
    K = S * points_per_section, without the clamp. Exact to round-off.
    """
    times, sections = curvature.shape
    part = section_length * np.arange(1, points_per_section + 1) / points_per_section
    ends = np.cumsum(curvature * section_length, axis=1)
    starts = ends - curvature * section_length
    half_turn = curvature[:, :, None] * part / 2
    chord = stretch[:, :, None] * part * np.sinc(half_turn / np.pi)
    direction = starts[:, :, None] + half_turn
    local = chord[..., None] * np.stack((np.sin(direction), np.cos(direction)), axis=-1)
    bases = np.zeros((times, sections, 2))
    bases[:, 1:] = np.cumsum(local[:, :-1, -1], axis=1)
    positions = bases[:, :, None, :] + local
    angles = starts[:, :, None] + 2 * half_turn
    count = sections * points_per_section
    return positions.reshape(times, count, 2), angles.reshape(times, count)
