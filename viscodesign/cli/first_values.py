"""What `init --measure` fills in: estimates of coefficients, and a pulse that suits them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, get_args

from viscodesign.errors import UsageError

if TYPE_CHECKING:
    from viscodesign.physics.bellow_estimates import LegSizes
    from viscodesign.scene.scene import Scene

FORMATS = {
    "actuator.solid_fraction": "{:.3g}",
    "actuator.extension_factor": "{:.3g}",
    "actuator.bending_factor": "{:.3g}",
    "bellows.area_per_pressure": "{:.3g} m^2/Pa",
    "bellows.angle_per_pressure": "{:.3g} rad",
    "bellows.extension_per_pressure": "{:.3g} m",
    "bellows.area_per_force": "{:.3g} m^2/N",
    "bellows.area_per_moment": "{:.3g} m^2/(N*m)",
}
"""Keys that are estimated, and how they are written."""
MAX_SWELLING, MAX_STRETCH, MAX_TURN, MAX_VACUUM = 0.4, 0.2, 2.0, 0.5
"""What the chosen pulse may do: to a bellow's volume, to a section's length, to the whole leg
[rad], and to the ambient pressure."""
PULSE = {"input.fall_time": 0.5, "input.rise_time": 4.0, "input.transition": 0.8}
"""Times of the chosen pulse, in settling times of the network."""
PULSES_END = 8.0
OUTPUTS = 400

Values = dict[str, str]
"""Texts by key."""


def not_given(values: Values, given: Mapping[str, str]) -> Values:
    """Those for whose key, or a section above it, nothing was given."""
    return {key: value for key, value in values.items() if not _is_given(key, given)}


def _is_given(key: str, given: Mapping[str, str]) -> bool:
    """Whether a key, or a section above it, was given."""
    return any(key == own or key.startswith(f"{own}.") for own in given)


def option_length(option: str, text: str) -> float:
    """A length that an option gives [m]."""
    from pydantic_core import PydanticCustomError

    from viscodesign.units import Length

    try:
        length = float(get_args(Length)[1].parse(text))
    except PydanticCustomError as error:
        raise UsageError(f"{option} {text}: {error}") from None
    if length < 0.0:
        raise UsageError(f"{option} {text}: must not be negative")
    if length == 0.0 and option == "--wall":
        raise UsageError(f"{option} {text}: must be above 0 m")
    return length


def leg_sizes(scene: Scene, wall: float, fold: float) -> LegSizes:
    """The sizes of a scene, its bellows with their walls inside of its body."""
    from viscodesign.physics.bellow_estimates import LegSizes

    a, b = scene.actuator, scene.bellows
    if problem := next(_does_not_fit(scene, wall), ""):
        raise UsageError(problem)
    return LegSizes(
        a.length, a.height, a.width, b.count, b.height, b.width, b.length, wall, fold
    )  # fmt: skip


def _does_not_fit(scene: Scene, wall: float) -> Iterator[str]:
    a, b = scene.actuator, scene.bellows
    for bellows, each, key in ((2, b.height, "height"), (1, b.length, "length")):
        needed, body = bellows * (each + 2 * wall), "height" if key == "height" else "width"
        room = getattr(a, body)
        if needed > room * (1 + 1e-9):
            count = "two bellows" if bellows == 2 else "a bellow"
            yield (
                f"{count} with bellows.{key} {1e3 * each:.4g} mm and walls of {1e3 * wall:.4g} mm "
                f"take {1e3 * needed:.4g} mm; actuator.{body} is {1e3 * room:.4g} mm. "
                "Change one of them with --set or --wall"
            )
    pitch = 2 * a.length / b.count
    if b.width > pitch * (1 + 1e-9):
        yield (
            f"{b.count // 2} sections with bellows.width {1e3 * b.width:.4g} mm are longer than "
            f"actuator.length {1e3 * a.length:.4g} mm. Change one of them with --set"
        )


def estimates(sizes: LegSizes, scene: Scene, given: Mapping[str, str]) -> Values:
    """Estimates that agree with what was measured."""
    from viscodesign.physics.bellow_estimates import first_coefficients

    measured = [
        getattr(scene.bellows, name) if _is_given(f"bellows.{name}", given) else None
        for name in ("extension_per_pressure", "angle_per_pressure")
    ]
    if any(value is not None and value <= 0.0 for value in measured):
        raise UsageError(
            "bellows.extension_per_pressure and bellows.angle_per_pressure must be above 0 with "
            "--measure: the stiffness is estimated from them"
        )
    found = first_coefficients(sizes, scene.actuator.youngs_modulus, *measured)
    return {key: form.format(getattr(found, key.split(".")[1])) for key, form in FORMATS.items()}


def pulse(scene: Scene) -> Values:
    """A pulse that the bellows bear, and as slow as their network."""
    from viscodesign.estimate.scene_quantities import SceneQuantities

    b, modulus, sections = scene.bellows, scene.actuator.youngs_modulus, scene.bellows.count / 2
    pitch = scene.actuator.length / sections
    limits = (
        MAX_SWELLING * b.height * b.width / b.area_per_pressure,
        MAX_STRETCH * pitch * modulus / (2 * b.extension_per_pressure),
        MAX_TURN * modulus / (2 * sections * b.angle_per_pressure),
        MAX_VACUUM * (scene.ambient_pressure + scene.gauge_pressure),
    )
    pressure = _one_digit(min(limits))
    settling = SceneQuantities(scene).scales.t_net
    times = {key: _seconds(share * settling) for key, share in PULSE.items()}
    return {
        "input.start": f"{pressure / 1e3:g} kPa",
        "input.drop": f"{2 * pressure / 1e3:g} kPa",
        **times,
        "run.duration": _seconds(PULSES_END * settling),
        "run.output_interval": _seconds(PULSES_END * settling / OUTPUTS),
    }


def _seconds(time: float) -> str:
    """A time to two digits."""
    return f"{float(f'{time:.2g}'):g} s"


def _one_digit(value: float) -> float:
    """Rounded down to one digit."""
    scale = 10.0 ** math.floor(math.log10(value))
    return math.floor(value / scale) * scale
