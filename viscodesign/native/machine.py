"""Machine code from LLVM IR for the processor that it runs on.

llvmlite is imported when it is first needed: most commands never do.
"""

from __future__ import annotations

import os
import platform
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from typing import Any

from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.native.vector_math import NONE, VectorMath, vector_math
from viscodesign.storage.lru_cache import ONE_AT_A_TIME

SWITCH = "VISCODESIGN_NATIVE"
"""Environment variable: ``off`` does without native code."""


@dataclass(frozen=True)
class Machine:
    """What machine code depends on, besides its source."""

    llvm: str
    triple: str
    cpu: str
    features: str
    vector_math: VectorMath = NONE

    def __str__(self) -> str:
        return f"{self.llvm} {self.triple} {self.cpu} {self.features} {self.vector_math}"


class Loaded:
    """Machine code in memory; it stays there as long as this object lives."""

    def __init__(self, addresses: dict[str, int], keeper: Any) -> None:
        self._addresses = addresses
        self._keeper = keeper

    def __getitem__(self, name: str) -> int:
        """Address of a function."""
        return self._addresses[name]


def this_machine() -> Machine:
    """The machine that this process runs on. Raises `NativeUnavailable`."""
    if os.environ.get(SWITCH, "").strip().lower() == "off":
        raise NativeUnavailable(f"native code is switched off ({SWITCH}=off)")
    return _this_machine()


@cache
def _this_machine() -> Machine:
    with _refusals_as_unavailable():
        import llvmlite

        llvm = _binding()
        version = ".".join(map(str, llvm.llvm_version_info))
        triple = llvm.get_process_triple()
        # Gathers are no faster than loads one by one, and far slower where Intel had to mend them.
        tuning = ",+prefer-no-gather,+prefer-no-scatter" if triple.startswith("x86_64") else ""
        features = llvm.get_host_cpu_features().flatten() + tuning
        return Machine(
            llvm=f"llvm {version} {llvmlite.__version__} {platform.python_implementation()}",
            triple=triple,
            cpu=llvm.get_host_cpu_name(),
            features=features,
            vector_math=vector_math(features),
        )


def object_code(ir: str, *, optimise: int, generate: int) -> bytes:
    """Object code of LLVM IR for this machine.

    ``optimise``: level of the passes over the IR, 0 for none; ``generate``: level of the code
    generator. Raises `NativeUnavailable`.
    """
    this_machine()
    with _refusals_as_unavailable(), ONE_AT_A_TIME:  # targets are shared
        llvm = _binding()
        target = _code_generator(generate)
        module = llvm.parse_assembly(ir)
        module.triple = llvm.get_process_triple()
        module.data_layout = str(target.target_data)
        module.verify()
        if optimise:
            options = llvm.create_pipeline_tuning_options(speed_level=optimise)
            options.slp_vectorization = True
            # Most loops here are short; unrolled they are no faster, and take longer to compile.
            options.loop_unrolling = False
            passes = llvm.create_pass_builder(target, options)
            passes.getModulePassManager().run(module, passes)
        return bytes(target.emit_object(module))


def load(codes: Sequence[bytes], names: Sequence[str]) -> Loaded:
    """Load pieces of object code that define functions of these names, different ones each.

    One piece more costs a tenth of loading it alone. Raises `NativeUnavailable`.
    """
    this_machine()
    with _refusals_as_unavailable(), ONE_AT_A_TIME:  # targets are shared
        llvm = _binding()
        jit = llvm.create_lljit_compiler(_target_machine(2))
        builder = llvm.JITLibraryBuilder()
        for code in codes:
            builder.add_object_img(code)
        builder.add_current_process()
        for name in names:
            builder.export_symbol(name)
        library = builder.link(jit, "viscodesign")
        return Loaded({name: library[name] for name in names}, (library, jit))


def _binding() -> Any:
    """llvmlite's binding, with the targets of this machine."""
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm


@cache
def _code_generator(level: int) -> Any:
    """One for all modules: making one takes as long as compiling a small kernel."""
    return _target_machine(level)


def _target_machine(level: int) -> Any:
    llvm = _binding()
    machine = _this_machine()
    return llvm.Target.from_triple(machine.triple).create_target_machine(
        cpu=machine.cpu,
        features=machine.features,
        opt=level,
        reloc="pic",
        codemodel="jitdefault",
    )


@contextmanager
def _refusals_as_unavailable() -> Iterator[None]:
    """Turn whatever llvmlite refuses into `NativeUnavailable`."""
    try:
        yield
    except NativeUnavailable:
        raise
    except (ImportError, OSError, RuntimeError, AttributeError, ValueError) as error:
        raise NativeUnavailable(f"no native code: {type(error).__name__}: {error}") from error
