"""Linear filters of first order, y' = rate y + drive, over drives that are straight within steps.

``steps`` steps and ``count`` filters of ``channels`` each. ``growth`` (count, steps): what is left
of a value after a step, exp(rate step); ``drive`` and ``found`` (count, channels, steps + 1);
``state`` (count, channels): their start; ``added`` (2, steps): room for what a step adds, by the
level of the drive and by its change. Complex numbers are two reals, but for ``growth`` and
``added``, whose real parts come before the imaginary ones: (count, 2, steps) and (4, steps).
"""

from __future__ import annotations

NEARLY_ZERO = 1e-2
"""Rate times step below which what a drive adds is taken by its series."""
THIRD, FIFTH, SIXTH, SEVENTH = 1 / 3, 1 / 5, 1 / 6, 1 / 7


def follow(steps, count, channels, step, rate, growth, drive, state, added, found):
    """Filters of real rates."""
    for m in range(count):
        grows = m * steps
        for k in range(steps):
            z = step[k] * rate[m]
            rest = 1 + FIFTH * z * (1 + SIXTH * z * (1 + SEVENTH * z))
            rest = 1 + THIRD * z * (1 + z / 4 * rest)
            closed = (growth[grows + k] - 1) / z
            closed_ramp = (closed - 1) / z
            is_small = abs(z) < NEARLY_ZERO
            level = 1 + z / 2 * rest if is_small else closed
            ramp = rest / 2 if is_small else closed_ramp
            added[k], added[steps + k] = level * step[k], ramp * step[k]
        for c in range(m * channels, (m + 1) * channels):
            here, value = c * (steps + 1), state[c]
            found[here] = value
            for k in range(steps):
                given = drive[here + k]
                gain = added[k] * given + added[steps + k] * (drive[here + k + 1] - given)
                value = gain + growth[grows + k] * value
                found[here + k + 1] = value


def follow_turning(steps, count, channels, step, rate, growth, drive, state, added, found):
    """Filters of complex rates and real drives."""
    for m in range(count):
        grows = 2 * m * steps
        turns = grows + steps
        for k in range(steps):
            zr, zi = step[k] * rate[2 * m], step[k] * rate[2 * m + 1]
            square = zr * zr + zi * zi
            # Of twice the ramp: 1 + z/3 (1 + z/4 (1 + z/5 (1 + z/6 (1 + z/7)))).
            er, ei = 1 + SEVENTH * zr, SEVENTH * zi
            dr, di = 1 + SIXTH * (zr * er - zi * ei), SIXTH * (zr * ei + zi * er)
            cr, ci = 1 + FIFTH * (zr * dr - zi * di), FIFTH * (zr * di + zi * dr)
            br, bi = 1 + (zr * cr - zi * ci) / 4, (zr * ci + zi * cr) / 4
            ar, ai = (1 + THIRD * (zr * br - zi * bi)) / 2, THIRD * (zr * bi + zi * br) / 2
            inverse = 1 / square
            vr, vi = zr * inverse, -zi * inverse
            gr, gi = growth[grows + k] - 1, growth[turns + k]
            lr, li = gr * vr - gi * vi, gr * vi + gi * vr
            rr, ri = (lr - 1) * vr - li * vi, (lr - 1) * vi + li * vr
            is_small = square < NEARLY_ZERO * NEARLY_ZERO
            lr = 1 + zr * ar - zi * ai if is_small else lr
            li = zr * ai + zi * ar if is_small else li
            rr = ar if is_small else rr
            ri = ai if is_small else ri
            added[k], added[steps + k] = lr * step[k], li * step[k]
            added[2 * steps + k], added[3 * steps + k] = rr * step[k], ri * step[k]
        for c in range(m * channels, (m + 1) * channels):
            here, yr, yi = c * (steps + 1), state[2 * c], state[2 * c + 1]
            found[2 * here], found[2 * here + 1] = yr, yi
            for k in range(steps):
                given = drive[here + k]
                change = drive[here + k + 1] - given
                gr, gi = growth[grows + k], growth[turns + k]
                more = added[k] * given + added[2 * steps + k] * change
                turned = added[steps + k] * given + added[3 * steps + k] * change
                # In this order one value waits least for the one before it.
                yr, yi = more + gr * yr - gi * yi, turned + gr * yi + gi * yr
                found[2 * (here + k + 1)], found[2 * (here + k + 1) + 1] = yr, yi
