"""Compile the loops of native code to LLVM IR: python docs/make_loops.py

Writes `viscodesign/native/loops.ll` from `viscodesign/native/source`, by numba, which
users do not need. The IR names no processor: it is finished on the machine that runs it.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path
from types import FunctionType
from typing import Any

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT))
# Before numba is imported. Its own passes would fit the loops to this machine.
os.environ |= {
    "NUMBA_CPU_NAME": "generic",
    "NUMBA_CPU_FEATURES": "",
    "NUMBA_OPT": "0",
    "NUMBA_LOOP_VECTORIZE": "0",
    "NUMBA_SLP_VECTORIZE": "0",
}

import llvmlite.binding as llvm  # noqa: E402
from llvmlite import ir  # noqa: E402
from numba import njit, types  # noqa: E402
from numba.extending import intrinsic  # noqa: E402

from viscodesign.native import loops  # noqa: E402

KINDS = {
    "count": types.int64,
    "real": types.float64,
    "counts": types.CPointer(types.int64),
    "places": types.CPointer(types.int32),
    "reals": types.CPointer(types.float64),
}
INLINED = (
    "sine_and_cosine",
    "exponential",
    "copy",
    "copy_block",
    "add_scaled",
    "gather",
    "scatter",
    "numba",
    "enlist",
    "delist",
)
"""Loops that are copied into what calls them; the others keep that arrays never overlap."""


@intrinsic
def part(context: Any, pointer: Any, start: Any) -> Any:
    """A pointer moved on by some entries."""
    del context

    def code(_: Any, builder: Any, __: Any, arguments: Any) -> Any:
        return builder.gep(*arguments[:1], [arguments[1]])

    return pointer(pointer, types.int64), code


@intrinsic
def call_kernel(context: Any, kernels: Any, k: Any, local: Any, numbers: Any, out: Any) -> Any:
    """Call what is at an address."""
    del context

    def code(_: Any, builder: Any, __: Any, arguments: Any) -> Any:
        address = builder.load(builder.gep(arguments[0], [arguments[1]]))
        given = [value.type for value in arguments[2:]]
        kernel = builder.inttoptr(address, ir.FunctionType(ir.VoidType(), given).as_pointer())
        builder.call(kernel, arguments[2:])
        return ir.Constant(ir.IntType(64), 0)

    return types.int64(kernels, types.int64, local, numbers, out), code


@intrinsic
def power_of_two(context: Any, whole: Any) -> Any:
    """2 to the power of a whole number, which are the exponent's bits."""
    del context

    def code(_: Any, builder: Any, __: Any, arguments: Any) -> Any:
        real, bits = arguments[0].type, ir.IntType(64)
        # 1.5 times 2^52 more: then the lowest bits of the mantissa are the number.
        count = builder.bitcast(builder.fadd(arguments[0], real(6755399441055744.0)), bits)
        return builder.bitcast(builder.add(builder.shl(count, bits(52)), bits(1023 << 52)), real)

    return types.float64(types.float64), code


def main() -> None:
    """Write the IR."""
    target = loops.IR_FILE
    target.write_text(f"; made from {loops.source_digest()}\n{loops_ir()}", encoding="utf-8")
    print(target, target.stat().st_size, "bytes")


def loops_ir() -> str:
    """All loops as one module, without names of this machine."""
    given: dict[str, Any] = {}
    for source in loops.SOURCES:
        given |= vars(source)
    given |= {"part": part, "call_kernel": call_kernel, "power_of_two": power_of_two}
    options = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True, "_nrt": False}
    for name in [name for source in loops.SOURCES for name in loops.functions_of(source)]:
        own = FunctionType(given[name].__code__, given, name)
        given[name] = njit(error_model="numpy", fastmath={"contract"}, **options)(own)
    module = llvm.parse_assembly("")
    for name, kinds in loops.SIGNATURES.items():
        module.link_in(llvm.parse_assembly(compiled(given[name], name, kinds)))
    finish(module)
    return plain(str(module))


def compiled(function: Any, name: str, kinds: tuple[str, ...]) -> str:
    """IR of one loop and of those that it calls, with a function of its own name in front."""
    arguments = tuple(KINDS[kind] for kind in kinds)
    function.compile(arguments)
    result = function.overloads[arguments]
    returned = {types.int64: "i64", types.none: "ptr"}[result.signature.return_type]
    words = {"count": "i64", "real": "double"}
    given = ", ".join(f"{words.get(kind, 'ptr')} %a{k}" for k, kind in enumerate(kinds))
    finishing = "  ret i64 0" if returned == "ptr" else "  %v = load i64, ptr %r\n  ret i64 %v"
    return "\n".join([
        _open_names(result.library.get_llvm_str()),
        f"define i64 @{name}({given}) {{",
        f"  %r = alloca {returned}\n  %e = alloca ptr",
        f"  call i32 @{result.fndesc.mangled_name}(ptr %r, ptr %e, {given})",
        f"{finishing}\n}}",
    ])  # fmt: skip


def _open_names(text: str) -> str:
    """IR whose definitions stand once and are not inlined here; arrays never overlap."""
    lines = []
    for line in text.splitlines():
        if line.startswith("define "):
            line = re.sub(
                r"^define (linkonce_odr |hidden |dso_local )*", "define linkonce_odr ", line
            )
            line = re.sub(r"\bptr %arg\.", "ptr noalias %arg.", line)
            line = re.sub(r"( noinline| #\d+)*( \{)$", r" noinline\2", line)
        lines.append(line)
    return "\n".join(lines)


def finish(module: Any) -> None:
    """Simplify, without anything that depends on the processor."""
    module.triple = llvm.get_process_triple()
    target = llvm.Target.from_triple(module.triple).create_target_machine(cpu="generic", opt=2)
    options = llvm.create_pipeline_tuning_options(speed_level=1)
    options.loop_vectorization = options.slp_vectorization = options.loop_unrolling = False
    passes = llvm.create_pass_builder(target, options)
    passes.getModulePassManager().run(module, passes)


def plain(text: str) -> str:
    """IR without attributes and names of targets that other releases may not know.

    Nor with what the passes noted about loops: they are still to be unrolled and vectorised.
    Names are short, and what is not called from outside is internal.
    """
    drop = r"^(; .*|source_filename.*|target .*|attributes .*|![\w.]+ = .*|@.*NumbaEnv.*)\n"
    text = re.sub(drop, "", text, flags=re.M)
    text = re.sub(r", ![\w.]+ !\d+|  +; preds.*| #\d+", "", text)
    words = r"readonly|writeonly|readnone|noundef|local_unnamed_addr|dso_local|tail"
    text = re.sub(rf" captures\([^)]*\)| ({words})\b", "", text)
    files = "|".join(source.__name__.rpartition(".")[2] for source in loops.SOURCES)
    for k, name in enumerate(dict.fromkeys(re.findall(r"@_ZN\w+", text))):
        own = re.match(rf"@_ZN(?:\d+[a-z_]\D*)*?\d+(?:{files})\d+([a-z_]+)B", name)
        text = text.replace(name, f"@{own[1] if own else 'numba'}.{k}")
    text = text.replace("define linkonce_odr", "define internal")
    kept = rf"^(define internal \S+ @(?!{'|'.join(INLINED)}).*\)) {{$"
    text = re.sub(kept, r"\1 noinline {", text, flags=re.M)
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"


if __name__ == "__main__":
    main()
