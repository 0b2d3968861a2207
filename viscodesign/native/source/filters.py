"""Linear filters of first order, y' = rate y + drive, over drives that are straight within steps.

``steps`` steps and ``count`` filters of ``channels`` each. ``growth`` (steps, count): what is left
of a value after a step, exp(rate step); ``drive`` and ``found`` (steps + 1, count, channels);
``state`` (count, channels): their start, and then their end. Complex numbers are two reals.
"""

from __future__ import annotations

NEARLY_ZERO = 1e-2
"""Rate times step below which what a drive adds is taken by its series."""


def follow(steps, count, channels, step, rate, growth, drive, state, found):
    """Filters of real rates."""
    row = count * channels
    for i in range(row):
        found[i] = state[i]
    for k in range(steps):
        before, after = k * row, (k + 1) * row
        for m in range(count):
            z, grown = step[k] * rate[m], growth[k * count + m]
            if abs(z) < NEARLY_ZERO:
                level = 1 + z / 2 * (1 + z / 3 * (1 + z / 4 * (1 + z / 5 * (1 + z / 6))))
                ramp = (1 + z / 3 * (1 + z / 4 * (1 + z / 5 * (1 + z / 6 * (1 + z / 7))))) / 2
            else:
                level = (grown - 1) / z
                ramp = (level - 1) / z
            level, ramp = level * step[k], ramp * step[k]
            for i in range(m * channels, (m + 1) * channels):
                given = drive[before + i]
                gain = level * given + ramp * (drive[after + i] - given)
                state[i] = grown * state[i] + gain
                found[after + i] = state[i]


def follow_turning(steps, count, channels, step, rate, growth, drive, state, found):
    """Filters of complex rates and real drives."""
    row = count * channels
    for i in range(2 * row):
        found[i] = state[i]
    for k in range(steps):
        before, after = k * row, (k + 1) * row
        for m in range(count):
            zr, zi = step[k] * rate[2 * m], step[k] * rate[2 * m + 1]
            gr, gi = growth[2 * (k * count + m)], growth[2 * (k * count + m) + 1]
            square = zr * zr + zi * zi
            if square < NEARLY_ZERO * NEARLY_ZERO:
                lr, li, rr, ri = 1.0, 0.0, 1.0, 0.0
                for n in range(6, 1, -1):
                    lr, li = 1 + (zr * lr - zi * li) / n, (zr * li + zi * lr) / n
                    rr, ri = 1 + (zr * rr - zi * ri) / (n + 1), (zr * ri + zi * rr) / (n + 1)
                rr, ri = rr / 2, ri / 2
            else:
                vr, vi = zr / square, -zi / square
                lr, li = (gr - 1) * vr - gi * vi, (gr - 1) * vi + gi * vr
                rr, ri = (lr - 1) * vr - li * vi, (lr - 1) * vi + li * vr
            lr, li, rr, ri = lr * step[k], li * step[k], rr * step[k], ri * step[k]
            for i in range(m * channels, (m + 1) * channels):
                given = drive[before + i]
                change = drive[after + i] - given
                yr, yi = state[2 * i], state[2 * i + 1]
                state[2 * i] = gr * yr - gi * yi + lr * given + rr * change
                state[2 * i + 1] = gr * yi + gi * yr + li * given + ri * change
                found[2 * (after + i)], found[2 * (after + i) + 1] = state[2 * i], state[2 * i + 1]
