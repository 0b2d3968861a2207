"""Axes as rows of arcs, and the strains that loads cause in them, for many samples at once.

Numbers are (rows, pieces, samples), vectors (rows, 2, pieces, samples), x before z; ``room`` holds
three numbers of every sample, which run along the axis.
"""

from __future__ import annotations

from viscodesign.native.source.angles import sine_and_cosine


def lay_axes(rows, pieces, samples, length, curvature, stretch, room, nodes, middle, direction):
    """From the clamp to the tip, of pieces of one reference length and these strains."""
    size = pieces * samples
    for s in range(rows):
        for t in range(3 * samples):
            room[t] = 0.0
        for k in range(pieces):
            for t in range(samples):
                here = k * samples + t
                x, z = 2 * s * size + here, (2 * s + 1) * size + here
                half = curvature[s * size + here] * (length / 2)
                across, along = sine_and_cosine(room[t] + half)
                sine, _ = sine_and_cosine(half)
                chord = length * stretch[s * size + here] * (sine / half if half != 0.0 else 1.0)
                begun_x, begun_z = room[samples + t], room[2 * samples + t]
                room[t] += 2 * half
                room[samples + t] = begun_x + chord * across
                room[2 * samples + t] = begun_z + chord * along
                nodes[x], nodes[z] = begun_x + chord * across, begun_z + chord * along
                middle[x], middle[z] = begun_x + chord / 2 * across, begun_z + chord / 2 * along
                direction[x], direction[z] = across, along


def strain_axes(
    rows, pieces, samples, most, turns, draws, nodes, middle, direction, force, room, turned, drawn
):
    """By forces at the ends of the pieces, from the tip to the clamp.

    ``turns`` and ``draws`` (pieces,): angle per moment, and stretch per force; ``turned``: angles
    of up to ``most``.
    """
    size = pieces * samples
    for s in range(rows):
        for t in range(3 * samples):
            room[t] = 0.0
        for back in range(pieces):
            k = pieces - 1 - back
            for t in range(samples):
                here = k * samples + t
                x, z = 2 * s * size + here, (2 * s + 1) * size + here
                force_x, force_z = room[t] + force[x], room[samples + t] + force[z]
                torque = room[2 * samples + t] + (nodes[x] * force[z] - nodes[z] * force[x])
                room[t], room[samples + t], room[2 * samples + t] = force_x, force_z, torque
                turn = turns[k] * (middle[x] * force_z - middle[z] * force_x - torque)
                turn = most if turn > most else turn
                turned[s * size + here] = -most if turn < -most else turn
                along = direction[x] * force_x + direction[z] * force_z
                drawn[s * size + here] = draws[k] * along
