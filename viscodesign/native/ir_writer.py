"""CasADi's scalar functions as LLVM IR that treats W elements at once.

Every scalar becomes a vector of W lanes, laid out (entry, lane). Products and sums may be
contracted, and divisors inverted, nothing else: results agree with CasADi's own to round-off,
and what is not finite stays so.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import casadi as ca
import numpy as np

from viscodesign.native.instructions import TWO_OPERANDS, instructions
from viscodesign.native.ir_operations import (
    ARITHMETIC,
    COMPARISONS,
    INTRINSICS,
    LIBRARY,
    LOGIC,
    expansion,
)
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.native.vector_math import NONE, VectorMath

INSTRUCTIONS_PER_BLOCK = 300
"""Instructions in a block; LLVM takes ever longer over longer ones."""
_NAMES = {value: name[3:] for name, value in vars(ca).items() if name.startswith("OP_")}


def module_ir(
    functions: Sequence[ca.Function], names: Sequence[str], lanes: int, vectors: VectorMath = NONE
) -> str:
    """LLVM IR of functions (local (nl,), numbers (np,)) -> out, under these names.

    ``vectors``: what of the C library takes several numbers at once. Each kernel is
    ``void name(double *local, double *numbers, double *out)`` on arrays (entry, lane).
    Raises `NativeUnavailable` for an operation that has no native form.
    """
    module = _Module(lanes, vectors)
    bodies = [module.kernel(f, name) for f, name in zip(functions, names, strict=True)]
    return "\n".join([*module.declared.values(), *bodies])


class _Module:
    """Kernels of one width, with what they declare."""

    def __init__(self, lanes: int, vectors: VectorMath) -> None:
        self.lanes = lanes
        self.vectors = vectors
        self.double = _vector("double", lanes)
        self.truth = _vector("i1", lanes)
        self.zero, self.one = self.constant(0.0), self.constant(1.0)
        self.declared: dict[str, str] = {}

    def kernel(self, function: ca.Function, name: str) -> str:
        """The definition of one function."""
        _check_shape(function)
        writer = _Writer(self)
        results = writer.values(function, (writer.read("local"), writer.read("numbers")))
        for k, value in enumerate(results):
            at = writer.let(f"getelementptr double, ptr %out, i64 {k * self.lanes}")
            writer.line(f"store {self.double} {value}, ptr {at}, align 8")
        head = (
            f"define void @{name}(ptr noalias readonly %local, ptr noalias readonly %numbers, "
            "ptr noalias %out) nounwind {"
        )
        return "\n".join([head, *writer.lines, "ret void", "}"])

    def constant(self, value: float) -> str:
        """A constant in every lane."""
        return _splat(f"double 0x{np.float64(value).view(np.uint64):016X}", self.lanes)

    def intrinsic(self, name: str, arguments: int) -> str:
        """The name of an operation that LLVM has for vectors; declared once."""
        suffix = "f64" if self.lanes == 1 else f"v{self.lanes}f64"
        full = f"llvm.{name}.{suffix}"
        types = ", ".join([self.double] * arguments)
        self.declared[full] = f"declare {self.double} @{full}({types})"
        return full

    def library(self, name: str, arguments: int) -> str:
        """The name of a function that calls the C library for all lanes; defined once."""
        if self.lanes > 1 and self.lanes % self.vectors.width == 0:
            wide = self.vectors.name(name, arguments)
            if wide is not None:
                return self._part_by_part(wide, name, arguments)
        scalars = ", ".join(["double"] * arguments)
        self.declared[name] = f"declare double @{name}({scalars}) nounwind willreturn memory(none)"
        if self.lanes == 1:
            return name
        full = f"lanes.{name}"
        self.declared[full] = self._lane_by_lane(full, name, arguments)
        return full

    def _part_by_part(self, wide: str, name: str, arguments: int) -> str:
        """Call a function for vectors once, or for each part of the lanes."""
        width = self.vectors.width
        part = _vector("double", width)
        types = ", ".join([part] * arguments)
        self.declared[wide] = f"declare {part} @{wide}({types}) nounwind willreturn memory(none)"
        if width == self.lanes:
            return wide
        full = f"parts.{name}"
        given = ", ".join(f"{self.double} %a{k}" for k in range(arguments))
        lines = [f"define internal {self.double} @{full}({given}) nounwind noinline {{"]
        whole = "poison"
        for first in range(0, self.lanes, width):
            chosen = ", ".join(f"i32 {first + k}" for k in range(width))
            parts = []
            for k in range(arguments):
                lines.append(
                    f"%x{k}.{first} = shufflevector {self.double} %a{k}, {self.double} poison, "
                    f"<{width} x i32> <{chosen}>"
                )
                parts.append(f"{part} %x{k}.{first}")
            lines.append(f"%y{first} = call {part} @{wide}({', '.join(parts)})")
            for k in range(width):
                lane = first + k
                lines.append(f"%z{lane} = extractelement {part} %y{first}, i32 {k}")
                lines.append(
                    f"%w{lane} = insertelement {self.double} {whole}, double %z{lane}, i32 {lane}"
                )
                whole = f"%w{lane}"
        self.declared[full] = "\n".join([*lines, f"ret {self.double} {whole}", "}"])
        return full

    def _lane_by_lane(self, full: str, name: str, arguments: int) -> str:
        parameters = [f"%a{k}" for k in range(arguments)]
        lines = [
            f"define internal {self.double} @{full}"
            f"({', '.join(f'{self.double} {p}' for p in parameters)}) nounwind noinline {{"
        ]
        whole = "poison"
        for lane in range(self.lanes):
            parts = []
            for k, parameter in enumerate(parameters):
                part = f"%x{k}.{lane}"
                lines.append(f"{part} = extractelement {self.double} {parameter}, i32 {lane}")
                parts.append(f"double {part}")
            lines.append(f"%y{lane} = call double @{name}({', '.join(parts)})")
            lines.append(
                f"%w{lane} = insertelement {self.double} {whole}, double %y{lane}, i32 {lane}"
            )
            whole = f"%w{lane}"
        return "\n".join([*lines, f"ret {self.double} {whole}", "}"])


class _Reader:
    """Entries of an input array, each loaded where it is first needed."""

    def __init__(self, writer: _Writer, array: str) -> None:
        self.writer = writer
        self.array = array
        self.loaded: dict[int, str] = {}

    def __getitem__(self, k: int) -> str:
        if k not in self.loaded:
            w, module = self.writer, self.writer.module
            at = w.let(f"getelementptr double, ptr %{self.array}, i64 {k * module.lanes}")
            self.loaded[k] = w.let(f"load {module.double}, ptr {at}, align 8")
        return self.loaded[k]


class _Writer:
    """Lines of one function's body."""

    def __init__(self, module: _Module) -> None:
        self.module = module
        self.lines: list[str] = []
        self._count = 0
        self._blocks = 0
        self._truths: dict[str, str] = {}
        self._opposites: dict[str, str] = {}
        self._choices: dict[str, tuple[str, str]] = {}
        """Truth values of numbers, what a truth value is the opposite of, and `if_else_zero`s."""

    def read(self, array: str) -> _Reader:
        return _Reader(self, array)

    def line(self, text: str) -> None:
        self.lines.append(text)
        if len(self.lines) >= INSTRUCTIONS_PER_BLOCK * (self._blocks + 1):
            self._blocks += 1
            self.lines += [f"br label %block{self._blocks}", f"block{self._blocks}:"]

    def let(self, text: str) -> str:
        """Name the result of an instruction."""
        self._count += 1
        name = f"%v{self._count}"
        self.line(f"{name} = {text}")
        return name

    def values(
        self, function: ca.Function, arguments: Sequence[_Reader | Sequence[str]]
    ) -> list[str]:
        """Names of the entries of a function's only output."""
        work: dict[int, str] = {}
        results: dict[int, str] = {}
        for k, (operation, place, x, y) in enumerate(_instructions(function)):
            if operation == ca.OP_OUTPUT:
                results[y] = work[x]
            elif operation == ca.OP_CONST:
                work[place] = self.module.constant(function.instruction_constant(k))
            elif operation == ca.OP_INPUT:
                work[place] = arguments[x][y]
            else:
                operands = [work[x], work[y]] if operation in TWO_OPERANDS else [work[x]]
                work[place] = self.operation(_NAMES[operation], operands)
        return [results.get(k, self.module.zero) for k in range(function.nnz_out(0))]

    def operation(self, name: str, operands: list[str]) -> str:
        """The result of one of CasADi's operations."""
        module = self.module
        if name == "ADD" and (choice := self._choice(*operands)):
            return choice
        if name in ARITHMETIC:
            instruction, form = ARITHMETIC[name]
            given = {"x": operands[0], "y": operands[-1], "one": module.one}
            return self.let(f"{instruction} {module.double} {form.format(**given)}")
        if name in INTRINSICS or name in LIBRARY:
            known = module.intrinsic if name in INTRINSICS else module.library
            called = known((INTRINSICS | LIBRARY)[name], len(operands))
            given_types = ", ".join(f"{module.double} {value}" for value in operands)
            return self.let(f"call {module.double} @{called}({given_types})")
        if name in COMPARISONS:
            return self.number(self.compare(COMPARISONS[name], *operands))
        if name in ("ASSIGN", "LIFT"):
            return operands[0]
        if name in LOGIC:
            return self.logic(name, operands)
        expanded = expansion(name)
        if expanded is None:
            raise NativeUnavailable(f"CasADi's operation {name.lower()} has no native form")
        return self.values(expanded, [[value] for value in operands])[0]

    def logic(self, name: str, operands: list[str]) -> str:
        """The result of an operation on truth values, which are what is not zero."""
        double, truth = self.module.double, self.module.truth
        zero, one = self.module.zero, self.module.one
        if name == "SIGN":
            copied = self.module.intrinsic("copysign", 2)
            unit = self.let(f"call {double} @{copied}({double} {one}, {double} {operands[0]})")
            # Zero, of either sign, and what is not a number stay as they are.
            return self.choose(self.compare("one", operands[0], zero), unit, operands[0])
        x = self.true(operands[0])
        if name == "NOT":
            opposite = self.let(f"xor {truth} {x}, {_splat('i1 true', self.module.lanes)}")
            self._opposites[opposite] = x
            return self.number(opposite)
        if name == "IF_ELSE_ZERO":
            value = self.choose(x, operands[1], zero)
            self._choices[value] = (x, operands[1])
            return value
        return self.number(self.let(f"{name.lower()} {truth} {x}, {self.true(operands[1])}"))

    def _choice(self, x: str, y: str) -> str | None:
        """CasADi's if_else, which is a sum of two numbers one of which is zero, as a choice."""
        if x in self._choices and y in self._choices:
            (first, one), (second, other) = self._choices[x], self._choices[y]
            if self._opposites.get(second) == first:
                return self.choose(first, one, other)
        return None

    def compare(self, how: str, x: str, y: str) -> str:
        return self.let(f"fcmp {how} {self.module.double} {x}, {y}")

    def choose(self, truth: str, x: str, y: str) -> str:
        m = self.module
        return self.let(f"select {m.truth} {truth}, {m.double} {x}, {m.double} {y}")

    def number(self, truth: str) -> str:
        """A truth value as 0 or 1."""
        value = self.let(f"uitofp {self.module.truth} {truth} to {self.module.double}")
        self._truths[value] = truth
        return value

    def true(self, value: str) -> str:
        """A number as a truth value."""
        if value not in self._truths:
            self._truths[value] = self.compare("une", value, self.module.zero)
        return self._truths[value]


@lru_cache(16)
def _instructions(function: ca.Function) -> list[list[int]]:
    """Read the instructions of a function once; most kernels contain the same few expansions."""
    found: list[list[int]] = instructions(function).tolist()
    return found


def _vector(scalar: str, lanes: int) -> str:
    return scalar if lanes == 1 else f"<{lanes} x {scalar}>"


def _splat(constant: str, lanes: int) -> str:
    """A constant with its type, in every lane."""
    return constant.split()[1] if lanes == 1 else f"<{', '.join([constant] * lanes)}>"


def _check_shape(function: ca.Function) -> None:
    """Raise `ValueError` unless a function is (local, numbers) -> out in dense columns."""
    given = [function.sparsity_in(k) for k in range(function.n_in())]
    given += [function.sparsity_out(k) for k in range(function.n_out())]
    dense = all(s.is_dense() and (s.size2() == 1 or s.numel() == 0) for s in given)
    if (function.n_in(), function.n_out()) != (2, 1) or not dense:
        raise ValueError(f"{function} is not (local, numbers) -> out in dense columns")
