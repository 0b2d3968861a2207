"""Cached machine code: never a wrong answer, whatever happened to the folder."""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from viscodesign.native import code_cache, kernels, machine
from viscodesign.native.kernels import (
    CompiledKernels,
    Wanted,
    compile_if_missing,
    compile_kernels,
)
from viscodesign.native.unavailable import NativeUnavailable


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache folder of this test."""
    monkeypatch.setenv(code_cache.FOLDER_VARIABLE, str(tmp_path / "cache"))
    return tmp_path / "cache" / "native"


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """One entry for every time that something is compiled."""
    calls: list[int] = []

    def counted(ir: str, *, optimise: int, generate: int) -> bytes:
        calls.append(1)
        return machine.object_code(ir, optimise=optimise, generate=generate)

    monkeypatch.setattr(kernels, "object_code", counted)
    return calls


def tripled(factor: float = 3.0) -> ca.Function:
    x = ca.SX.sym("x")
    return ca.Function("f", [x, ca.SX.sym("n", 0)], [factor * x])


def use(factor: float = 3.0, key: str = "") -> CompiledKernels:
    """Compile or load a kernel, and check what it gives."""
    found = compile_kernels([tripled(factor)], key, 1)
    assert value(found, 5.0) == factor * 5
    return found


def value(found: CompiledKernels, at: float) -> float:
    """What the first of some kernels gives."""
    x, out = np.array([at]), np.zeros(1)
    call = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 3)(found.address(0))
    call(x.ctypes.data, x.ctypes.data, out.ctypes.data)
    return float(out[0])


def only_file(folder: Path) -> Path:
    (file,) = folder.iterdir()
    return file


def test_the_second_time_it_is_loaded(folder: Path, made: list[int]) -> None:
    use()
    use()
    assert len(made) == 1
    assert only_file(folder).stat().st_size < 5000


def test_in_one_process_it_is_loaded_once(folder: Path) -> None:
    first = use()
    assert use() is first


def test_of_many_only_new_ones_are_compiled_and_all_are_loaded_at_once(
    folder: Path, made: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    pieces: list[int] = []

    def counted(codes: list[bytes], names: list[str]) -> machine.Loaded:
        pieces.append(len(codes))
        return machine.load(codes, names)

    def wanted(factor: float) -> Wanted:
        return Wanted((str(factor),), 1, 1, lambda: [tripled(factor)], str(factor).encode)

    monkeypatch.setattr(kernels, "load", counted)
    compile_if_missing([wanted(factor) for factor in (1.0, 2.0)])
    assert (len(made), pieces) == (2, [2])
    found = compile_if_missing([wanted(factor) for factor in (1.0, 2.0, 3.0, 1.0)])
    assert (len(made), pieces) == (3, [2, 3])
    assert [own.told for own in found] == [b"1.0", b"2.0", b"3.0", b"1.0"]
    assert [value(own, 5.0) for own in found] == [5.0, 10.0, 15.0, 5.0]
    assert len(list(folder.iterdir())) == 3


def test_another_formula_key_version_or_machine_is_another_file(
    folder: Path, made: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    use()
    use(factor=4.0)
    use(key="other")
    monkeypatch.setattr(kernels, "__version__", "0.0.0")
    use()
    this = machine.this_machine()
    for other in (replace(this, cpu="i386"), replace(this, features=""), replace(this, llvm="1")):
        monkeypatch.setattr(kernels, "this_machine", lambda other=other: other)
        use()
    assert len(made) == 7
    assert len(list(folder.iterdir())) == 7


@pytest.mark.parametrize("keep", [0, 10, 40, -1])
def test_a_file_cut_short_is_made_anew(folder: Path, made: list[int], keep: int) -> None:
    use()
    file = only_file(folder)
    whole = file.read_bytes()
    file.write_bytes(whole[:keep])
    use()
    assert len(made) == 2
    assert file.read_bytes() == whole


def test_an_altered_file_is_made_anew(folder: Path, made: list[int]) -> None:
    use()
    file = only_file(folder)
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)
    use()
    assert len(made) == 2


def test_a_complete_file_that_is_not_machine_code_is_refused(folder: Path) -> None:
    """It cannot come about by accident; the process survives it all the same."""
    use()
    parts_of_it = b"no object code"
    head = code_cache.MAGIC + code_cache.hashlib.sha256(parts_of_it).digest()
    only_file(folder).write_bytes(head + parts_of_it)
    with pytest.raises(NativeUnavailable):
        use()


def test_a_read_only_folder_is_done_without(
    folder: Path, made: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Refused as the system does it, since root may write anywhere."""

    def refused(**_: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(tempfile, "mkstemp", refused)
    use()
    use()
    assert len(made) == 2
    assert list(folder.iterdir()) == []


def test_a_folder_that_cannot_be_is_done_without(
    tmp_path: Path, made: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv(code_cache.FOLDER_VARIABLE, str(tmp_path / "file"))
    use()
    use()
    assert len(made) == 2


def test_a_full_disk_is_done_without(
    folder: Path, made: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    use()
    assert len(made) == 1
    assert list(folder.iterdir()) == []


@pytest.mark.parametrize("word", ["", "off", "OFF"])
def test_it_can_be_switched_off(
    folder: Path, made: list[int], word: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(code_cache.FOLDER_VARIABLE, word)
    use()
    use()
    assert len(made) == 2
    assert not folder.exists()


def test_the_usual_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv(code_cache.FOLDER_VARIABLE)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert code_cache.cache_folder() == tmp_path / "viscodesign" / "native"
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")
    monkeypatch.setenv("HOME", str(tmp_path))
    folder = code_cache.cache_folder()
    assert folder is not None
    assert tmp_path in folder.parents


def test_what_was_not_used_for_longest_goes(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(1.0)
    first = only_file(folder)
    use(2.0)
    (second,) = set(folder.iterdir()) - {first}
    for age, file in enumerate((first, second)):
        os.utime(file, (1000 + age, 1000 + age))
    use(1.0)
    size = first.stat().st_size
    monkeypatch.setattr(code_cache, "MAX_BYTES", 3 * size)
    use(5.0)
    assert first.exists()
    assert not second.exists()


def test_a_folder_is_looked_through_once(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    looks: list[Path] = []
    make_room = code_cache._make_room

    def counted(path: Path) -> int:
        looks.append(path)
        return make_room(path)

    monkeypatch.setattr(code_cache, "_make_room", counted)
    for k in range(5):
        code_cache.keep((str(k),), bytes(1000))
    assert looks == [folder]
    monkeypatch.setattr(code_cache, "MAX_BYTES", 5500)
    for k in range(5, 20):
        code_cache.keep((str(k),), bytes(1000))
        assert sum(file.stat().st_size for file in folder.iterdir()) <= 5500
    assert len(looks) > 5


def test_a_file_of_somebody_else_is_not_run(
    folder: Path, made: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    use()
    monkeypatch.setattr(os, "getuid", lambda: os.geteuid() + 7)
    if only_file(folder).stat().st_uid != 0:
        use()
        assert len(made) == 2


def test_two_processes_fill_one_cache(folder: Path) -> None:
    code = (
        "import casadi as ca\n"
        "from viscodesign.native.kernels import compile_kernels\n"
        "x, n = ca.SX.sym('x'), ca.SX.sym('n', 0)\n"
        "for k in range(20):\n"
        "    compile_kernels([ca.Function('f', [x, n], [k * x])], '', 1)\n"
    )
    both = [subprocess.Popen([sys.executable, "-c", code]) for _ in range(2)]
    assert [process.wait() for process in both] == [0, 0]
    files = list(folder.iterdir())
    assert len(files) == 20
    assert all(code_cache._read(file) is not None for file in files)


def test_native_code_can_be_switched_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(machine.SWITCH, "off")
    with pytest.raises(NativeUnavailable, match="VISCODESIGN_NATIVE=off"):
        use()


def test_without_llvmlite_it_is_unavailable(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "llvmlite.binding", None)
    machine._this_machine.cache_clear()
    with pytest.raises(NativeUnavailable, match="no native code: "):
        use()
    machine._this_machine.cache_clear()


def test_importing_does_not_import_llvmlite() -> None:
    code = (
        "import sys\n"
        "from viscodesign.native import kernels, loops, march, sparse_lu, tables\n"
        "assert not any(name.startswith(('llvmlite', 'numba', 'scipy')) for name in sys.modules)\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_a_missing_symbol_is_unavailable() -> None:
    ir = (
        "declare double @no_such_function(double)\n"
        "define double @f(double %x) {\n"
        "  %y = call double @no_such_function(double %x)\n  ret double %y\n}\n"
    )
    with pytest.raises(NativeUnavailable):
        machine.load([machine.object_code(ir, optimise=0, generate=1)], ["f"])
    with pytest.raises(NativeUnavailable, match="parsing"):
        machine.object_code("nonsense", optimise=0, generate=1)
