"""Linear recurrences of first order, many at once."""

from __future__ import annotations

import numpy as np


def marched(decay: np.ndarray, gain: np.ndarray, start: np.ndarray) -> np.ndarray:
    """y_0 (n,), and y_k+1 = decay_k y_k + gain_k: (n, c + 1) from (n, c).

    In blocks side by side, so that the loops are short.
    """
    modes, count = gain.shape
    width = int(np.ceil(np.sqrt(count)))
    blocks = -(-count // width)
    passed = np.ones((width, modes, blocks), dtype=gain.dtype)
    gained = np.zeros((width, modes, blocks), dtype=gain.dtype)
    padded = np.ones((modes, blocks * width), dtype=gain.dtype)
    padded[:, :count] = decay
    by_step = padded.reshape(modes, blocks, width).transpose(2, 0, 1)
    padded = np.zeros_like(padded)
    padded[:, :count] = gain
    gain_by_step = padded.reshape(modes, blocks, width).transpose(2, 0, 1)
    before_p, before_g = np.ones((modes, blocks)), np.zeros((modes, blocks))
    for k in range(width):
        before_p = passed[k] = by_step[k] * before_p
        before_g = gained[k] = by_step[k] * before_g + gain_by_step[k]
    carried = np.empty((modes, blocks), dtype=gain.dtype)
    here = start
    for block in range(blocks):
        carried[:, block] = here
        here = passed[-1, :, block] * here + gained[-1, :, block]
    every = (passed * carried + gained).transpose(1, 2, 0).reshape(modes, -1)
    return np.concatenate([start[:, None], every[:, :count]], axis=1)
