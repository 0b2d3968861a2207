"""The quantities of a run, one row each; columns, frames, labels and the page follow.

Adding a quantity touches two files: a row here, and the file that computes its array
(``postprocess/motion.py``), or one file where it follows from arrays that are there: then
the row brings its own ``read``.
"""

from __future__ import annotations

import enum
import re
from collections.abc import Callable, Iterable, Iterator
from typing import Literal, Protocol

import numpy as np

from viscodesign.lazy_dataclass import dataclass

WHOLE = slice(None)
Rows = slice | np.ndarray
TRAJECTORY, SHAPE = "trajectory.csv", "shape.csv"
TIP_QUANTITIES = ("tip_x", "tip_z", "tip_angle")
"""Quantities of the last point of the axis."""
CONTACT_QUANTITIES = ("contact_normal", "contact_tangential", "contact_gap")
"""Quantities of the points that may touch something."""
PICTURE_UNITS = {"m": ("mm", 1e3), "Pa": ("kPa", 1e-3), "m^3": ("mL", 1e6), "m^3/s": ("mL/s", 1e6)}
"""SI unit -> what pictures show instead, and how many of these it is."""
RESOLVED_MM = 1e-6
"""Distances below this are rounding [mm]."""


def millimetres(length: float | None) -> str:
    """A distance [m] in words, to three digits; what there is to say where none is known."""
    if length is None:
        return "not known"
    value = 1e3 * length
    return f"< {RESOLVED_MM:g} mm" if 0.0 < abs(value) < RESOLVED_MM else f"{value:.3g} mm"


class Per(enum.StrEnum):
    """What a quantity has one value of, at an instant."""

    RUN = "run"
    INLET = "inlet"
    BELLOW = "bellow"
    TUBE = "tube"
    JUNCTION = "junction"
    SECTION = "section"
    CONTACT = "contact"
    ARC = "point of the axis"


UNNAMED_IF_SINGLE = frozenset({Per.INLET, Per.CONTACT})
"""Where there is one inlet or contact alone, its columns do not tell its name."""


class WithMembers(Protocol):
    """What knows the names of the parts of a run."""

    def members(self, per: Per) -> tuple[str, ...]: ...


class NamedArrays(WithMembers, Protocol):
    """The arrays of a motion, with the names of what they belong to."""

    @property
    def arc(self) -> np.ndarray: ...

    @property
    def shape(self) -> np.ndarray: ...

    @property
    def shape_rows(self) -> np.ndarray: ...

    def __getitem__(self, quantity: str) -> np.ndarray: ...


Read = Callable[[NamedArrays, Rows], np.ndarray]
"""Values at some rows of a run: (n,) of the run itself, else (n, members)."""


def stored(array: str, component: int | None = None) -> Read:
    """Read an array of the run, or one component along its last axis."""

    def read(trajectory: NamedArrays, rows: Rows) -> np.ndarray:
        values = trajectory[array][rows]
        return values if component is None else values[..., component]

    return read


def _arc(trajectory: NamedArrays, rows: Rows) -> np.ndarray:
    return np.broadcast_to(trajectory.arc, trajectory.shape[rows].shape[:2])


@dataclass(frozen=True)
class Channel:
    """One quantity over time, in SI."""

    quantity: str
    unit: str
    title: str
    """As a picture names it."""
    meaning: str
    """As the page of quantities describes it."""
    per: Per = Per.RUN
    reference: Literal["gauge", "absolute"] | None = None
    """What a pressure is relative to: the ambient, or a vacuum."""
    tables: tuple[str, ...] = ()
    """Files of a run that have it."""
    read: Read | None = None
    """How to read it, where that is not the array of its name."""
    plotted: bool = False
    """Whether the page of a run plots it over time, in a panel of its own. It is then in
    `trajectory.csv`, of which the page is made again."""

    @property
    def unit_words(self) -> str:
        """The unit as the last word of a column: ``m3_s`` for m^3/s; a ratio has none."""
        words = re.split("[ */]", self.unit.removeprefix("1").lower().replace("^", ""))
        return "_".join(word for word in words if word)

    @property
    def label(self) -> str:
        """What an axis of a picture says, with the unit it is drawn in."""
        reference = f"{self.reference} " if self.reference else ""
        return f"{reference}{self.title} [{self.picture_unit[0]}]"

    @property
    def picture_unit(self) -> tuple[str, float]:
        """The unit that pictures show, and how many of these the SI unit is."""
        return PICTURE_UNITS.get(self.unit, (self.unit, 1.0))

    @property
    def names(self) -> str:
        """All its columns in one name: ``pressure_<bellow>_pa``."""
        return self.column("" if self.per in (Per.RUN, Per.ARC) else f"<{self.per}>")

    def column(self, member: str = "") -> str:
        """The column of a member: an inlet, a bellow, a tube."""
        return "_".join(part for part in (self.quantity, member, self.unit_words) if part)

    def columns(self, run: WithMembers) -> list[str]:
        """Its columns in a table of the run, in order."""
        if self.per in (Per.RUN, Per.ARC):
            return [self.column()]
        members = run.members(self.per)
        if self.per in UNNAMED_IF_SINGLE and len(members) == 1:
            return [self.column()]
        return [self.column(name) for name in members]

    def values(self, trajectory: NamedArrays, rows: Rows = WHOLE) -> np.ndarray:
        """Its values (n,) or (n, members) at some rows."""
        return (self.read or stored(self.quantity))(trajectory, rows)


CHANNELS: tuple[Channel, ...] = (
    Channel("time", "s", "time", "output time", tables=(TRAJECTORY, SHAPE)),
    Channel(
        "tip_x", "m", "x of the tip", "distance of the tip from the clamp's axis, towards R",
        tables=(TRAJECTORY,), read=stored("tip", 0),
    ),
    Channel(
        "tip_z", "m", "z of the tip", "distance of the tip from the clamp, along its axis",
        tables=(TRAJECTORY,), read=stored("tip", 1),
    ),
    Channel(
        "tip_angle", "rad", "angle of the tip", "angle of the tip from +z towards +x, unwrapped",
        tables=(TRAJECTORY,), read=stored("tip", 2),
    ),
    Channel(
        "inlet_pressure", "Pa", "inlet pressure",
        "pressure at an inlet; with a single inlet the name is left out",
        Per.INLET, "gauge", (TRAJECTORY,),
    ),
    Channel(
        "pressure", "Pa", "pressure", "pressure in a bellow",
        Per.BELLOW, "gauge", (TRAJECTORY,),
    ),
    Channel(
        "flow", "m^3/s", "flow", "flow in a tube, positive from its first end to its second",
        Per.TUBE, tables=(TRAJECTORY,),
    ),
    Channel(
        "contact_normal", "N", "normal force of contact",
        "force with which the ground pushes a point of the actuator away; zero where they do not "
        "touch. Without a ground there is no such column, and with a single point its name is "
        "left out",
        Per.CONTACT, tables=(TRAJECTORY,), plotted=True,
    ),
    Channel(
        "contact_tangential", "N", "force of friction",
        "force of friction on a point of the actuator: towards +x on a ground that pushes towards "
        "+z, and turned with it",
        Per.CONTACT, tables=(TRAJECTORY,), plotted=True,
    ),
    Channel(
        "contact_gap", "m", "gap", "distance of a point of the actuator from the ground",
        Per.CONTACT, tables=(TRAJECTORY,), plotted=True,
    ),
    Channel(
        "arc", "m", "arc length", "distance from the clamp along the unstrained axis",
        Per.ARC, tables=(SHAPE,), read=_arc,
    ),
    Channel(
        "x", "m", "x", "distance from the clamp's axis, towards R",
        Per.ARC, tables=(SHAPE,), read=stored("shape", 0),
    ),
    Channel(
        "z", "m", "z", "distance from the clamp, along its axis",
        Per.ARC, tables=(SHAPE,), read=stored("shape", 1),
    ),
    Channel("volume", "m^3", "volume", "volume of a bellow", Per.BELLOW),
    Channel(
        "inflow", "m^3", "volume delivered",
        "volume of fluid, at ambient density, that an inlet has delivered since the unloaded "
        "state at the baseline pressure",
        Per.INLET,
    ),
    Channel(
        "junction_pressure", "Pa", "junction pressure", 
        "pressure where tubes meet without a bellow", Per.JUNCTION, "gauge",
    ),
    Channel("section_stretch", "1", "stretch", "smallest stretch within a section", Per.SECTION),
    Channel("section_turn", "rad", "turn", "angle between the ends of a section", Per.SECTION),
)  # fmt: skip
"""In the order of the columns."""


def channel(quantity: str) -> Channel:
    """The row of a quantity; raises `KeyError` where there is none."""
    return {row.quantity: row for row in CHANNELS}[quantity]


TIP_COLUMNS = tuple(channel(quantity).column() for quantity in TIP_QUANTITIES)
"""Columns of a tip's x, z and angle."""


def channels_of(table: str) -> list[Channel]:
    """The quantities of a file, in order."""
    return [row for row in CHANNELS if table in row.tables]


def plotted_channels(trajectory: NamedArrays) -> list[Channel]:
    """The quantities that have a panel of their own on the page of this run."""
    return [row for row in CHANNELS if row.plotted and row.columns(trajectory)]


def columns_of(
    channels: Iterable[Channel], trajectory: NamedArrays, rows: slice = WHOLE
) -> tuple[list[str], np.ndarray]:
    """Names and values (n, columns) of quantities over time."""
    listed = [row for row in channels if row.columns(trajectory)]
    names = [name for row in listed for name in row.columns(trajectory)]
    if not listed:
        return [], np.zeros((len(trajectory["time"][rows]), 0))
    return names, np.column_stack([row.values(trajectory, rows) for row in listed])


def trajectory_columns(
    trajectory: NamedArrays, rows: slice = WHOLE
) -> tuple[list[str], np.ndarray]:
    """Names and values (T, columns) of `trajectory.csv`, or of some rows."""
    return columns_of(channels_of(TRAJECTORY), trajectory, rows)


def shape_columns(trajectory: NamedArrays, rows: slice = WHOLE) -> tuple[list[str], np.ndarray]:
    """Names and values (N K, columns) of `shape.csv`, or of some shapes."""
    points = len(trajectory.arc)
    columns = []
    for row in channels_of(SHAPE):
        if row.per is Per.ARC:
            columns.append(row.values(trajectory, rows).ravel())
        else:
            columns.append(np.repeat(row.values(trajectory, trajectory.shape_rows[rows]), points))
    return [row.column() for row in channels_of(SHAPE)], np.column_stack(columns)


def channel_table() -> Iterator[tuple[str, str, str, str]]:
    """Column, meaning, unit and file of every quantity, for the page of quantities."""
    for row in CHANNELS:
        unit = f"{row.unit}, {row.reference}" if row.reference else row.unit
        files = ", ".join(row.tables) or f'`frame("{row.quantity}")`'
        yield f"`{row.names}`", row.meaning, unit, files
