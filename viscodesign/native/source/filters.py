"""Linear filters, y' = rate y + drive, over drives that are straight within steps.

``steps`` steps and ``count`` filters of ``channels`` each. ``drive`` and ``found`` (count,
channels, steps + 1); ``state`` (count, channels): their start, and then their end; ``room`` for
what is left of a value after a step, exp(rate step), and for what the level of the drive and its
change add: three or six times ``steps``. Complex rates and states are two reals each.
"""

from __future__ import annotations

from viscodesign.native.source.angles import exponential, sine_and_cosine

NEARLY_ZERO = 1e-2
"""Rate times step below which what a drive adds is taken by its series."""
THIRD, FIFTH, SIXTH, SEVENTH = 1 / 3, 1 / 5, 1 / 6, 1 / 7


def follow(steps, count, channels, step, rate, drive, state, room, found):
    """Filters of real rates."""
    levels, ramps = steps, 2 * steps
    for m in range(count):
        for k in range(steps):
            z = step[k] * rate[m]
            grown = exponential(z)
            rest = 1 + FIFTH * z * (1 + SIXTH * z * (1 + SEVENTH * z))
            rest = 1 + THIRD * z * (1 + z / 4 * rest)
            closed = (grown - 1) / z
            closed_ramp = (closed - 1) / z
            is_small = abs(z) < NEARLY_ZERO
            level = 1 + z / 2 * rest if is_small else closed
            ramp = rest / 2 if is_small else closed_ramp
            room[k], room[levels + k], room[ramps + k] = grown, level * step[k], ramp * step[k]
        for c in range(m * channels, (m + 1) * channels):
            here, value = c * (steps + 1), state[c]
            found[here] = value
            for k in range(steps):
                given = drive[here + k]
                gain = room[levels + k] * given + room[ramps + k] * (drive[here + k + 1] - given)
                value = gain + room[k] * value
                found[here + k + 1] = value
            state[c] = value


def follow_turning(steps, count, channels, step, rate, scale, drive, state, room, found):
    """Filters of complex rates and real drives: ``scale`` (count,) times the imaginary part."""
    turns, levels, ramps = steps, 2 * steps, 4 * steps
    for m in range(count):
        for k in range(steps):
            zr, zi = step[k] * rate[2 * m], step[k] * rate[2 * m + 1]
            size = exponential(zr)
            sine, cosine = sine_and_cosine(zi)
            grown, turned = size * cosine, size * sine
            square = zr * zr + zi * zi
            # Of twice the ramp: 1 + z/3 (1 + z/4 (1 + z/5 (1 + z/6 (1 + z/7)))).
            er, ei = 1 + SEVENTH * zr, SEVENTH * zi
            dr, di = 1 + SIXTH * (zr * er - zi * ei), SIXTH * (zr * ei + zi * er)
            cr, ci = 1 + FIFTH * (zr * dr - zi * di), FIFTH * (zr * di + zi * dr)
            br, bi = 1 + (zr * cr - zi * ci) / 4, (zr * ci + zi * cr) / 4
            ar, ai = (1 + THIRD * (zr * br - zi * bi)) / 2, THIRD * (zr * bi + zi * br) / 2
            inverse = 1 / square
            vr, vi = zr * inverse, -zi * inverse
            lr = (grown - 1) * vr - turned * vi
            li = (grown - 1) * vi + turned * vr
            rr, ri = (lr - 1) * vr - li * vi, (lr - 1) * vi + li * vr
            is_small = square < NEARLY_ZERO * NEARLY_ZERO
            lr = 1 + zr * ar - zi * ai if is_small else lr
            li = zr * ai + zi * ar if is_small else li
            rr = ar if is_small else rr
            ri = ai if is_small else ri
            room[k], room[turns + k] = grown, turned
            room[levels + k], room[levels + steps + k] = lr * step[k], li * step[k]
            room[ramps + k], room[ramps + steps + k] = rr * step[k], ri * step[k]
        for c in range(m * channels, (m + 1) * channels):
            here, yr, yi = c * (steps + 1), state[2 * c], state[2 * c + 1]
            found[here] = scale[m] * yi
            for k in range(steps):
                given = drive[here + k]
                change = drive[here + k + 1] - given
                gr, gi = room[k], room[turns + k]
                more = room[levels + k] * given + room[ramps + k] * change
                across = room[levels + steps + k] * given + room[ramps + steps + k] * change
                # In this order one value waits least for the one before it.
                yr, yi = more + gr * yr - gi * yi, across + gr * yi + gi * yr
                found[here + k + 1] = scale[m] * yi
            state[2 * c], state[2 * c + 1] = yr, yi
