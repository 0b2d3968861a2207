"""Dataclasses whose methods are written when first called are dataclasses like all others."""

from __future__ import annotations

import dataclasses
import inspect
import pickle
import re
import subprocess
import sys
from dataclasses import FrozenInstanceError, field, fields, replace

import pytest

from tests.architecture import PACKAGE
from viscodesign.lazy_dataclass import LazyMethod, dataclass

MOST_TEXTS = 320
"""Methods that may be compiled while the command's modules are imported, nearly all of them by
pydantic and typer; with the standard decorator they are a thousand."""
COUNT_TEXTS = """
import sys
texts = 0
def count(event, arguments):
    global texts
    if event == "exec" and sys._getframe(1).f_globals["__name__"] == "dataclasses":
        texts += 1
sys.addaudithook(count)
import viscodesign.cli.simulate, viscodesign.loading, viscodesign.simulation.simulate
print(texts)
"""


@dataclass(frozen=True)
class Point:
    x: float
    y: float = 2.0
    tags: list[str] = field(default_factory=list, compare=False)


@dataclass(frozen=True)
class SolidPoint(Point):
    mass: float = field(default=1.0, kw_only=True)

    def __post_init__(self) -> None:
        if self.mass < 0:
            raise ValueError("negative mass")


@dataclass
class Counter:
    count: int = 0
    _: dataclasses.KW_ONLY
    step: int = 1


@dataclass(frozen=True, eq=False)
class Identity:
    name: str


@dataclass(frozen=True)
class Named:
    name: str

    def __repr__(self) -> str:
        return f"<{self.name}>"

    def __hash__(self) -> int:
        return 7


def test_init_takes_what_the_standard_one_takes() -> None:
    assert (Point(1.0).x, Point(1.0).y, Point(1.0).tags) == (1.0, 2.0, [])
    assert Point(1.0).tags is not Point(1.0).tags
    assert (Counter(3, step=2).count, Counter(3, step=2).step) == (3, 2)
    with pytest.raises(TypeError, match=r"Point\.__init__\(\) missing 1 required positional"):
        Point()  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="positional"):
        Counter(1, 2)  # type: ignore[misc]


def test_post_init_of_a_subclass_is_called() -> None:
    assert SolidPoint(1.0, mass=3.0).mass == 3.0
    with pytest.raises(ValueError, match="negative mass"):
        SolidPoint(1.0, mass=-1.0)


def test_signature_is_that_of_the_fields() -> None:
    standard = dataclasses.make_dataclass("Standard", [("x", float), ("y", float, 2.0)])
    assert list(inspect.signature(SolidPoint).parameters) == ["x", "y", "tags", "mass"]
    assert list(inspect.signature(standard).parameters) == ["x", "y"]


def test_repr_equality_and_hash_are_the_standard_ones() -> None:
    assert repr(SolidPoint(1.0)) == "SolidPoint(x=1.0, y=2.0, tags=[], mass=1.0)"
    assert Point(1.0, tags=["a"]) == Point(1.0) != Point(2.0)
    assert Point(1.0) != SolidPoint(1.0)
    assert hash(Point(1.0)) == hash((1.0, 2.0))
    assert Counter(1) == Counter(1) != Counter(2)
    with pytest.raises(TypeError, match="unhashable"):
        hash(Counter())
    assert Identity("a") != Identity("a")
    assert len({Identity("a"), Identity("a")}) == 2


def test_methods_of_the_class_itself_stay() -> None:
    assert repr(Named("a")) == "<a>"
    assert hash(Named("a")) == 7
    assert Named("a") == Named("a")


@pytest.mark.parametrize("frozen", [Point(1.0), SolidPoint(1.0), Identity("a")])
def test_frozen_objects_cannot_change(frozen: object) -> None:
    name = fields(frozen)[0].name  # type: ignore[arg-type]
    with pytest.raises(FrozenInstanceError, match=f"cannot assign to field '{name}'"):
        setattr(frozen, name, 0.0)
    with pytest.raises(FrozenInstanceError, match="cannot assign to field 'other'"):
        frozen.other = 0.0  # type: ignore[attr-defined]
    with pytest.raises(FrozenInstanceError, match=f"cannot delete field '{name}'"):
        delattr(frozen, name)


def test_a_plain_subclass_of_a_frozen_class_has_attributes_of_its_own() -> None:
    class Marked(Point):
        mark: str

    marked = Marked(1.0)
    marked.mark = "a"
    assert marked.mark == "a"
    with pytest.raises(FrozenInstanceError):
        marked.x = 3.0  # type: ignore[misc]


def test_replace_and_pickle_give_equal_objects() -> None:
    assert replace(SolidPoint(1.0), y=5.0) == SolidPoint(1.0, 5.0)
    assert pickle.loads(pickle.dumps(SolidPoint(1.0, mass=4.0))) == SolidPoint(1.0, mass=4.0)


def test_the_standard_decorator_takes_subclasses_and_refuses_thawed_ones() -> None:
    @dataclasses.dataclass(frozen=True)
    class Standard(Point):
        z: float = 3.0

    assert (Standard(1.0).y, Standard(1.0).z) == (2.0, 3.0)
    with pytest.raises(TypeError, match="non-frozen dataclass from a frozen"):

        @dataclass
        class Thawed(Point):
            z: float = 3.0


def test_methods_are_written_once_and_only_when_looked_up() -> None:
    @dataclass(frozen=True)
    class Fresh:
        x: int

    assert all(isinstance(vars(Fresh)[n], LazyMethod) for n in ("__init__", "__eq__", "__hash__"))
    assert Fresh(1).x == 1
    written = vars(Fresh)["__init__"]
    assert inspect.isfunction(written)
    assert Fresh(2).x == 2
    assert vars(Fresh)["__init__"] is written
    assert isinstance(vars(Fresh)["__eq__"], LazyMethod)


def test_importing_a_command_compiles_few_methods() -> None:
    found = subprocess.run(
        [sys.executable, "-c", COUNT_TEXTS], capture_output=True, text=True, check=True
    )
    assert int(found.stdout) < MOST_TEXTS


def test_the_package_takes_no_other_decorator() -> None:
    other = re.compile(r"^from dataclasses import .*\bdataclass\b", re.MULTILINE)
    found = {path.name for path in PACKAGE.rglob("*.py") if other.search(path.read_text())}
    assert found <= {"lazy_dataclass.py"}
