"""A run as an xarray dataset: every array with named dimensions, coordinates and units."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from viscodesign.errors import UsageError
from viscodesign.results.channels import CHANNELS, Channel, Per
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    import xarray

DIMENSIONS = {
    Per.INLET: "inlet",
    Per.BELLOW: "bellow",
    Per.TUBE: "tube",
    Per.JUNCTION: "junction",
    Per.SECTION: "section",
    Per.CONTACT: "contact",
}


def dataset(trajectory: Trajectory) -> xarray.Dataset:
    """All quantities of a run, by their names in `results.channels`.

    Along time they have the dimension ``time``; x and z of the axis have ``shape_time`` and
    ``arc``. Raises `UsageError` where xarray is not installed.
    """
    try:
        import xarray
    except ImportError as error:
        raise UsageError(
            "to_xarray needs the package xarray: pip install 'viscodesign[xarray]'"
        ) from error
    variables = dict(_variables(trajectory))
    names = {word: list(trajectory.members(per)) for per, word in DIMENSIONS.items()}
    given = {dimension for dimensions, _, _ in variables.values() for dimension in dimensions}
    coordinates: dict[str, Any] = {word: value for word, value in names.items() if word in given}
    shape_time = trajectory.time[trajectory.shape_rows]
    coordinates |= {
        "time": ("time", trajectory.time, {"units": "s"}),
        "shape_time": ("shape_time", shape_time, {"units": "s"}),
        "arc": ("arc", trajectory.arc, {"units": "m", "long_name": "arc length"}),
    }
    return xarray.Dataset(variables, coordinates, _attributes(trajectory))


def _variables(
    trajectory: Trajectory,
) -> list[tuple[str, tuple[tuple[str, ...], np.ndarray, dict[str, str]]]]:
    """Name, dimensions, values and attributes of every quantity that the run has."""
    found = []
    for row in CHANNELS:
        if row.quantity in ("time", "arc") or not _is_there(row, trajectory):
            continue
        dimensions = _dimensions(row)
        found.append((row.quantity, (dimensions, row.values(trajectory), _described(row))))
    return found


def _is_there(row: Channel, trajectory: Trajectory) -> bool:
    return row.read is not None or row.quantity in trajectory.arrays


def _dimensions(row: Channel) -> tuple[str, ...]:
    if row.per is Per.ARC:
        return "shape_time", "arc"
    return ("time",) if row.per is Per.RUN else ("time", DIMENSIONS[row.per])


def _described(row: Channel) -> dict[str, str]:
    reference = {"reference": row.reference} if row.reference else {}
    return {"units": row.unit, "long_name": row.title, "description": row.meaning, **reference}


def _attributes(trajectory: Trajectory) -> dict[str, Any]:
    """What a file of it should say: plain texts and numbers."""
    error = trajectory.accuracy.estimated_tip_error_m
    return {
        "name": trajectory.name,
        "status": trajectory.status,
        "validity": trajectory.validity,
        "tip_error_m": np.nan if error is None else error,
        "version": trajectory.version,
        "spec_sha256": trajectory.spec_sha256,
        "spec": trajectory.spec_text,
    }
