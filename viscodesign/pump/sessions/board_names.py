"""Kinds of pump and boards by name."""

from __future__ import annotations

from viscodesign.errors import UsageError, did_you_mean
from viscodesign.plugins import members
from viscodesign.pump.boards.controller import Controller
from viscodesign.pump.kinds.base import PumpKind
from viscodesign.pump.planning.demand_kinds import pump_of
from viscodesign.scene.pump import DEFAULT_KIND
from viscodesign.scene.scene import Scene

SIMULATED_BOARD = "simulated"
"""Stands for the simulated board of any kind."""


def pump_kinds() -> dict[str, PumpKind]:
    """Kinds of pump by the word after `pump.kind`."""
    found = members("viscodesign.pump.kinds", PumpKind)  # type: ignore[type-abstract]
    return {name: kind() for name, kind in found.items()}


def kind_of(scene: Scene) -> PumpKind:
    """The kind of a scene's pump; raises where it has none, or one that is only planned."""
    pump, kinds = pump_of(scene), pump_kinds()
    if pump.name not in kinds:
        raise UsageError(
            f"a pump of kind {pump.name} can only be planned: its package brings no `PumpKind` "
            "that moves it; use `pump plan`"
        )
    return kinds[pump.name]


def boards_of(kind: PumpKind) -> dict[str, type[Controller]]:
    """Boards of one kind of pump by the word after `--board`."""
    return {**kind.boards(), SIMULATED_BOARD: kind.simulated_board(poses=False)}


def real_boards() -> list[str]:
    """Names of all boards of which something real moves, in the order of their kinds."""
    return [name for kind in pump_kinds().values() for name in kind.boards()]


def boards() -> dict[str, type[Controller]]:
    """All boards by the word after `--board`; the simulated one is that of the default kind."""
    default_last = sorted(pump_kinds().values(), key=lambda kind: kind.name == DEFAULT_KIND)
    return {name: board for kind in default_last for name, board in boards_of(kind).items()}


def board_kind(name: str) -> type[Controller]:
    """The board with a name."""
    every = boards()
    if name not in every:
        hint = did_you_mean(name, every) or "."
        raise UsageError(f"board {name}: no such board{hint} There are: {', '.join(every)}")
    return every[name]


def kind_behind(name: str, scene: Scene | None) -> PumpKind:
    """The kind of pump behind a board: the scene's, or without one whichever the board drives.

    Raises `UsageError` where the board does not drive the scene's.
    """
    board_kind(name)
    if scene is None:
        return next(kind for kind in pump_kinds().values() if name in boards_of(kind))
    kind = kind_of(scene)
    if name not in boards_of(kind):
        able = " or ".join(boards_of(kind))
        raise UsageError(
            f"the board {name} does not drive a pump of kind {kind.name}, as the spec has it "
            f"(pump.kind); use the board {able}"
        )
    return kind
