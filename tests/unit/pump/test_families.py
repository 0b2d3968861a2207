"""What is known of AX servos stays in their family: nothing else imports it or speaks of registers."""

from __future__ import annotations

import ast
import re

from tests.architecture import eager_imports_of, imports_of, modules

AX = "viscodesign.pump.ax"
FAMILY = re.compile(r"viscodesign\.pump\.(ax|boards|simulated|poses)(\.|$)")
"""The servos, and what speaks their protocol: boards, simulated firmware and pose files."""
KIND = re.compile(r"viscodesign\.pump\.kinds\.servo")
"""The files of the kind: they know the family, but not its protocol."""
NEUTRAL = re.compile(r"viscodesign\.pump\.(drive|profile|bus|play|planning|plunger)(\.|$)")
"""What another drive, or another kind of pump, is built on."""
PUMP = re.compile(r"viscodesign\.(pump|scene\.pumps|cli\.pump)(\.|$)")
REGISTERS = re.compile(r"(?i)register|speed_unit|\b0\.111\b")
TEXTS = {name: path.read_text(encoding="utf-8") for name, path in modules().items()}


def inside(name: str, room: str) -> bool:
    return name == room or name.startswith(f"{room}.")


def test_only_the_family_and_its_kind_import_it() -> None:
    others = [name for name in TEXTS if AX in TEXTS[name] and not FAMILY.match(name)]
    assert "viscodesign.pump.kinds.servo" in others
    for name in others:
        forbidden = f"{AX}.protocol" if KIND.match(name) else AX
        assert not [other for other in imports_of(name) if inside(other, forbidden)], name


def test_only_the_family_speaks_of_registers() -> None:
    others = [name for name in TEXTS if PUMP.match(name) and not FAMILY.match(name)]
    found = {name: REGISTERS.findall(ast.unparse(ast.parse(TEXTS[name]))) for name in others}
    assert {name: words for name, words in found.items() if words} == {}


def test_what_another_drive_is_built_on_does_not_reach_the_family() -> None:
    reached, todo = set(), [name for name in TEXTS if NEUTRAL.match(name)]
    while todo:
        new = {other for other in eager_imports_of(todo.pop()) if PUMP.match(other)} - reached
        reached |= new
        todo += new
    assert not [other for other in reached if inside(other, AX)]
