"""Formulas kept on disk: never another answer, whatever happened to the folder."""

from __future__ import annotations

import hashlib
import os
import pickle
import subprocess
import sys
import zlib
from collections.abc import Callable
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from tests.scenes import leg
from viscodesign.effects.catalogue import catalogue
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model import formulation, jacobian, structure_digest
from viscodesign.model.fluid import Incompressible
from viscodesign.model.formula_store import FormulaStore
from viscodesign.model.structure import structure_of
from viscodesign.native import code_cache
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.simulation.solve_once import Run, solve
from viscodesign.solve.problem import Problem

SCENE = (
    "bellows.count=4",
    "run={duration: 0.2 s, output_interval: 0.05 s}",
    "effects={pressure_distribution: on, inertia: on, damping: on, feedback: on, others: off}",
)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache folder of this test."""
    monkeypatch.setenv(code_cache.FOLDER_VARIABLE, str(tmp_path / "cache"))
    return tmp_path / "cache" / "native"


@pytest.fixture(scope="module")
def plain() -> Run:
    """What is found without any cache."""
    before = os.environ.get(code_cache.FOLDER_VARIABLE, "")
    os.environ[code_cache.FOLDER_VARIABLE] = "off"
    try:
        return solved()
    finally:
        os.environ[code_cache.FOLDER_VARIABLE] = before


def solved(*overrides: str) -> Run:
    """A run as in a process that has formulated nothing so far."""
    formulation._kept.clear()
    quantities = SceneQuantities(leg(*SCENE, *overrides))
    return solve(quantities, select_effects(quantities).effects, Settings(2, 1e-4))


def formulated(run: Run | Problem) -> bool:
    problem = run.problem if isinstance(run, Run) else run
    return len(problem.equations.shared._formulas) > 0


def assert_equal(run: Run, other: Run) -> None:
    assert np.array_equal(run.motion.tip, other.motion.tip)
    assert np.array_equal(run.motion.pressure, other.motion.pressure)


def test_the_second_time_nothing_is_formulated(folder: Path, plain: Run) -> None:
    first, second = solved(), solved()
    assert (formulated(plain), formulated(first), formulated(second)) == (True, True, False)
    assert_equal(first, plain)
    assert_equal(second, plain)


def test_other_numbers_use_the_same_files(folder: Path) -> None:
    solved()
    assert not formulated(solved("network.tube_length=50 mm"))
    assert formulated(solved("effects.damping=off"))


@pytest.mark.parametrize("effect", [None, *catalogue()])
def test_functions_from_files_are_those_that_were_made(folder: Path, effect: str | None) -> None:
    """All that solvers are given, with each effect in turn."""
    from tests.contract.test_effects import LOADED

    def built() -> Problem:
        formulation._kept.clear()
        quantities = SceneQuantities(leg(*LOADED))
        names = ("pressure_distribution", "gravity", "inertia", effect)
        chosen = [kind.of(quantities) for name, kind in catalogue().items() if name in names]
        present = [one for one in chosen if one.present(quantities)]
        return build(quantities, present, Settings(1, 1e-4))

    made, read = built(), None
    code = _serialized(made)
    read = built()
    assert _serialized(read) == code
    assert formulated(made)
    assert not formulated(read)


def _serialized(problem: Problem) -> list[object]:
    e, local = problem.equations, problem.equations.local
    assert local is not None
    functions = (e.function, e.static_function, e.algebraic_function, e.output_function)
    code = [f.serialize() for f in (*functions, local.start, local.form.numbers)]
    form = local.form
    layout = (e.states.blocks.keys(), e.rates, e.fed, form.balances.mass.tobytes(), form.drives)
    tapes = [f._taped for f in (e.statics_by_tape, e.constraints_by_tape, e.outputs_by_tape)]
    code += [b.tobytes() for t in tapes if t for b in (t.tape.code, t.tape.constants)]
    patterns = [(t.patterns, t.tape.given, t.tape.names, t.tape.sizes) for t in tapes if t]
    assert len(patterns) == 3
    return [*code, *map(repr, layout), repr(form.kinds), repr(form.sources), patterns]


def _cut(data: bytes) -> bytes:
    return data[: len(data) // 2]


def _altered(data: bytes) -> bytes:
    return data[:-1] + bytes([data[-1] ^ 1])


def _sealed(content: bytes) -> bytes:
    return code_cache.MAGIC + hashlib.sha256(content).digest() + content


def _foreign(data: bytes) -> bytes:
    return _sealed(b"whole, but no formulas")


def _other_pickle(data: bytes) -> bytes:
    return _sealed(zlib.compress(pickle.dumps({"a": 1})))


class _Harmful:
    def __reduce__(self) -> tuple[Callable[..., object], tuple[str]]:
        return os.putenv, ("VISCODESIGN_HARM",)


def _harmful(data: bytes) -> bytes:
    return _sealed(zlib.compress(pickle.dumps(_Harmful())))


@pytest.mark.parametrize("spoil", [_cut, _altered, _foreign, _other_pickle, _harmful])
def test_spoilt_files_are_made_anew(
    folder: Path, plain: Run, spoil: Callable[[bytes], bytes]
) -> None:
    solved()
    before = {file.name: file.read_bytes() for file in folder.iterdir() if _holds_formulas(file)}
    assert len(before) >= 5
    for name, data in before.items():
        (folder / name).write_bytes(spoil(data))
    again = solved()
    assert formulated(again)
    assert_equal(again, plain)
    assert {name: (folder / name).read_bytes() for name in before} == before
    assert not formulated(solved())


def _holds_formulas(file: Path) -> bool:
    try:
        zlib.decompress(file.read_bytes()[len(code_cache.MAGIC) + 32 :])
    except zlib.error:
        return False
    return True


def test_a_folder_that_cannot_be_is_done_without(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, plain: Run
) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv(code_cache.FOLDER_VARIABLE, str(tmp_path / "file"))
    for run in (solved(), solved()):
        assert formulated(run)
        assert_equal(run, plain)


def test_a_read_only_folder_is_read(
    folder: Path, monkeypatch: pytest.MonkeyPatch, plain: Run
) -> None:
    def refuse(path: Path, data: bytes) -> None:
        raise OSError(30, "Read-only file system", str(path))

    monkeypatch.setattr(code_cache, "write_bytes", refuse)
    assert formulated(solved())
    monkeypatch.undo()
    monkeypatch.setenv(code_cache.FOLDER_VARIABLE, str(folder.parent))
    solved()
    monkeypatch.setattr(code_cache, "write_bytes", refuse)
    again = solved()
    assert not formulated(again)
    assert_equal(again, plain)


def test_code_of_two_versions_is_kept_apart(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    solved()
    monkeypatch.setattr(structure_digest, "__version__", "0.0.0")
    assert formulated(solved())
    assert not formulated(solved())
    monkeypatch.setattr(structure_digest, "source_digest", lambda: "another source")
    assert formulated(solved())
    monkeypatch.setattr(structure_digest, "source_digest", lambda: None)
    assert formulated(solved())
    assert formulated(solved())


def test_what_was_replaced_in_a_process_is_not_kept(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    solved()
    own = jacobian.jacobian
    monkeypatch.setattr(jacobian, "jacobian", lambda *args: own(*args))
    assert formulated(solved())
    assert formulated(solved())


def test_code_of_other_packages_is_not_kept(folder: Path) -> None:
    class Elsewhere(Incompressible):
        pass

    assert structure_digest.structure_digest(structure_of(Incompressible())) is not None
    assert structure_digest.structure_digest(structure_of(Elsewhere())) is None
    assert structure_digest.structure_digest(structure_of(lambda: 1)) is None
    assert structure_digest.structure_digest(float("nan")) is None


PARTS = [(1, 2), (12,), ("1", "2"), (1, (2,)), ((1,), 2), (1.0, 2), (True, 2), (None, 2), b"12"]


def test_digests_tell_keys_apart() -> None:
    keys = [*PARTS, frozenset(PARTS), frozenset(PARTS[:2]), -0.0, 0.0, int, float]
    digests = [structure_digest.structure_digest(key) for key in keys]
    assert len({digest for digest in digests if digest}) == len(keys)


def test_a_function_that_holds_a_solver_is_not_kept(folder: Path) -> None:
    x = ca.SX.sym("x")
    finder = ca.rootfinder("f", "newton", {"x": x, "g": x**2 - 2})
    made: list[int] = []

    def make() -> ca.Function:
        made.append(1)
        return finder

    store = FormulaStore("a structure")
    for _ in range(2):
        assert store.function(make, (), make) is finder
    assert len(made) == 2


PROCESS = """
import hashlib
from tests.unit.model.test_formula_store import formulated, solved
run = solved()
print(formulated(run), hashlib.sha256(run.motion.tip.tobytes()).hexdigest())
"""


def test_processes_share_what_any_of_them_formulated(folder: Path, plain: Run) -> None:
    def start(seed: int) -> subprocess.Popen[str]:
        own = {**os.environ, "PYTHONHASHSEED": str(seed)}
        return subprocess.Popen(
            [sys.executable, "-c", PROCESS], stdout=subprocess.PIPE, text=True, env=own
        )

    both = [start(1), start(2)]
    found = [process.communicate(timeout=120)[0].split() for process in both]
    last = start(3).communicate(timeout=120)[0].split()
    digest = hashlib.sha256(plain.motion.tip.tobytes()).hexdigest()
    assert [tip for _, tip in (*found, last)] == [digest] * 3
    assert last[0] == "False"
    assert not list(folder.glob(".*"))
