"""All instructions of a CasADi function at once.

CasADi tells them one by one, in three calls each. Its serialised form has them in a row, but
how is not documented: what is read there is compared with what CasADi tells of some of them,
and unless that is the same, CasADi is asked for each.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

FIELDS = 4
"""Fields of an instruction: its operation, the place of its result, and two operands.

One operand only stands twice. Of a CONST, the operands are the bits of the number; of an INPUT
argument and entry; an OUTPUT has the number of the result, the place of what it gives, and the
entry.
"""
FEW = 200
"""Instructions up to which asking for each is as fast."""
COMPARED = 100
"""Instructions that are compared, evenly spread."""
TWO_OPERANDS = frozenset((
    *(ca.OP_ADD, ca.OP_SUB, ca.OP_MUL, ca.OP_DIV, ca.OP_POW, ca.OP_CONSTPOW, ca.OP_ATAN2),
    *(ca.OP_LT, ca.OP_LE, ca.OP_EQ, ca.OP_NE, ca.OP_AND, ca.OP_OR, ca.OP_IF_ELSE_ZERO),
    *(ca.OP_FMIN, ca.OP_FMAX, ca.OP_COPYSIGN, ca.OP_HYPOT, ca.OP_FMOD, ca.OP_REMAINDER),
))  # fmt: skip
"""Operations on two numbers; all others are on one."""
_LAST = np.zeros(max(v for k, v in vars(ca).items() if k.startswith("OP_")) + 1, dtype=bool)
_LAST[[*TWO_OPERANDS, ca.OP_CONST, ca.OP_INPUT, ca.OP_OUTPUT]] = True
"""Whether CasADi uses the last field of an operation."""


def instructions(function: ca.Function) -> np.ndarray:
    """Instructions (n, FIELDS) int32 of a function of plain operations (an SX function)."""
    count = function.n_instructions()
    found = _from_serialised(function) if count > FEW else None
    return _told(function, range(count)) if found is None else found


def _told(function: ca.Function, which: range) -> np.ndarray:
    """Some instructions, each as CasADi tells it."""
    found = np.empty((len(which), FIELDS), dtype=np.int32)
    for row, k in enumerate(which):
        operation = function.instruction_id(k)
        read, written = function.instruction_input(k), function.instruction_output(k)
        if operation == ca.OP_CONST:
            bits = np.array([function.instruction_constant(k)]).view(np.int32)
            found[row] = operation, written[0], *bits
        elif operation == ca.OP_OUTPUT:
            found[row] = operation, written[0], read[0], written[1]
        else:
            found[row] = operation, written[0], read[0], read[-1]
    return found


def _from_serialised(function: ca.Function) -> np.ndarray | None:
    """All of them from the serialised form; None where they are not found there."""
    count = function.n_instructions()
    some = range(0, count, max(count // COMPARED, 1))
    told = _told(function, some)
    content = _bytes_of(function.serialize())
    first = told[:1].tobytes()  # an input or a constant, since nothing else comes before these
    begin = content.find(first) if count else -1
    while 0 <= begin <= len(content) - len(first) * count:
        fields = np.frombuffer(content, np.int32, FIELDS * count, begin).reshape(count, FIELDS)
        if np.all((fields[:, 0] >= 0) & (fields[:, 0] < len(_LAST))):
            found = fields.copy()
            found[:, -1] = np.where(_LAST[fields[:, 0]], fields[:, -1], fields[:, -2])
            if np.array_equal(found[some], told):
                return found
        begin = content.find(first, begin + 1)
    return None


def _bytes_of(text: str) -> bytes:
    """What CasADi writes as letters a to p, the lower four bits of a byte first."""
    letters = np.frombuffer(text.encode("latin-1"), np.uint8) - np.uint8(ord("a"))
    halves = letters[: len(letters) // 2 * 2].reshape(-1, 2)
    return bytes(halves[:, 0] | (halves[:, 1] << 4))
