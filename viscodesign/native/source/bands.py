"""Matrices with a narrow band, eliminated without pivoting."""

from __future__ import annotations


def have_signs(matrices, entries, count, width, lower, upper, signs, data, band, found):
    """Whether all pivots of every matrix have the opposite sign of ``signs`` (count,).

    ``data`` (matrices, entries); ``lower``, ``upper`` (entries,): places in bands of columns below
    and of rows right of the diagonal, -1 beyond; ``band`` (2, count + width, width + 1): to work
    with. ``found`` (matrices,) becomes 1 where they have, else 0: also of what is not finite.
    """
    size, step = (count + width) * (width + 1), width + 1
    for k in range(matrices):
        for i in range(2 * size):
            band[i] = 0.0
        for e in range(entries):
            if lower[e] >= 0:
                band[lower[e]] = data[k * entries + e]
            if upper[e] >= 0:
                band[size + upper[e]] = data[k * entries + e]
        found[k] = 1
        for j in range(count):
            below, right = j * step, size + j * step
            pivot = band[below]
            if not signs[j] * pivot < 0.0:
                found[k] = 0
                break
            for near in range(1, step):
                after = j + near
                if band[right + near] != 0.0 or band[below + near] != 0.0:
                    across, down = band[right + near] / pivot, band[below + near] / pivot
                    for far in range(near, step):
                        at = after * step + far - near
                        band[at] -= band[below + far] * across
                        band[size + at] -= down * band[right + far]
