"""A spec of one's own actuator from a few sizes: what is not measured yet is estimated."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from string import Template
from typing import TYPE_CHECKING, get_args

from viscodesign.errors import UsageError

if TYPE_CHECKING:
    from viscodesign.physics.bellow_estimates import LegSizes
    from viscodesign.scene.scene import Scene

TEXT = """\
# A leg of your own; its coefficients are first estimates, good for orders of magnitude.
#
# Estimated from Young's modulus, the sizes and a wall of $wall with folds $fold deep.
# Lines marked ESTIMATE wait for your measurements: docs/measuring.md says how to make them, and
# how far such estimates were off a measured leg. docs/keys.md explains every key.
spec: 1
name: $name

actuator:
  length: 109 mm
  height: 30 mm                       # along x, the direction of bending
  width: 20 mm
  youngs_modulus: 1.8 MPa
  density: 950 kg/m^3
  solid_fraction: 0.5                 # ESTIMATE: all but the bellows is solid; weigh it
  extension_factor: 0.5               # ESTIMATE: walls alone; hang a weight on it
  bending_factor: 0.5                 # ESTIMATE: walls alone; let it sag as a cantilever
  damping_time: 1 ms                  # ASSUMED; from the decay of a free swing

bellows:                              # inner sizes
  count: 16                           # two to a section
  height: 10 mm                       # along x
  width: 12 mm                        # along the actuator
  length: 18 mm
  area_per_pressure: 3e-9 m^2/Pa      # ESTIMATE: faces bulge, walls stretch; use a syringe
  angle_per_pressure: 3 rad           # ESTIMATE: pressure on the ends; use a camera
  extension_per_pressure: 30 mm       # ESTIMATE: likewise
  area_per_force: 1e-6 m^2/N          # ESTIMATE: from extension_per_pressure, by reciprocity
  area_per_moment: 1e-4 m^2/(N*m)     # ESTIMATE: from angle_per_pressure, by reciprocity

network:
  layout: straight                    # inlet, down the right side, up the left
  tube_radius: 0.325 mm
  tube_length: 37.5 mm

fluid: air

input:                                # CHOSEN: a pulse that these bellows can bear and follow
  kind: double_sigmoid
  start: 20 kPa
  drop: 40 kPa
  fall_time: 0.5 s
  rise_time: 4 s
  transition: 0.875 s

loads:
  gravity: on                         # hanging; {tilt: 90 deg}: held out level

effects: auto
accuracy: 0.5 %
run:
  duration: 8 s
  output_interval: 20 ms
"""

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
MOST_SWELLING, MOST_STRETCH, MOST_TURN, MOST_VACUUM = 0.4, 0.2, 2.0, 0.5
"""What the chosen pulse may do: to a bellow's volume, to a section's length, to the whole leg
[rad], and to the ambient pressure."""
PULSE = {"input.fall_time": 0.5, "input.rise_time": 4.0, "input.transition": 0.8}
"""Times of the chosen pulse, in settling times of the network."""
PULSES_END = 8.0
REMARKS_AT = 40
"""Column of the remarks."""
OUTPUTS = 400

Values = dict[str, str]
"""Texts by key."""


def first_spec(name: str, sets: Sequence[str], wall: str, fold: str | None) -> str:
    """The text of a spec for these sizes. Raises `ViscodesignError`.

    ``sets``: 'key.path=value'; of the coefficients, they are taken as measured.
    """
    from viscodesign import load

    fold = wall if fold is None else fold
    text = Template(TEXT).substitute(name=name, wall=wall, fold=fold)
    given = dict(_parted(change) for change in sets)
    scene = load(text, sets)
    sizes = _sizes(scene, _length("--wall", wall), _length("--fold", fold))
    values = _not_given(_estimates(sizes, scene, given), given)
    scene = load(text, [*_as_sets(values), *sets])
    values |= _not_given(_pulse(scene), given)
    text = _edited(text, values)
    text = _aligned(_edited(text, given, note="# given"))
    load(text)
    return text


def _aligned(text: str) -> str:
    """The text with its remarks below one another."""
    line = re.compile(r"(?m)^( *[\w.-]+:[^#\n]*?) +# ")
    return line.sub(lambda found: f"{found[1]:<{REMARKS_AT}}# ", text)


def _edited(text: str, values: Mapping[str, str], note: str = "") -> str:
    """The text with these values; ``note`` replaces what the lines say of them."""
    from viscodesign.scene.reading.edit import with_value

    for key, value in values.items():
        path = key.split(".")
        text = with_value(text, path, value)
        if note:
            remark = rf"(?m)^( *{re.escape(path[-1])}:[^#\n]*)# (?:ESTIMATE|ASSUMED|CHOSEN)[^\n]*"
            text = re.sub(remark, rf"\1{note}", text)
    return text


def _parted(change: str) -> tuple[str, str]:
    key, _, value = change.partition("=")
    return key.strip(), value.strip()


def _as_sets(values: Values) -> list[str]:
    return [f"{key}={value}" for key, value in values.items()]


def _not_given(values: Values, given: Mapping[str, str]) -> Values:
    return {key: value for key, value in values.items() if not _is_given(key, given)}


def _is_given(key: str, given: Mapping[str, str]) -> bool:
    """Whether a key, or a section above it, was given."""
    return any(key == own or key.startswith(f"{own}.") for own in given)


def _length(option: str, text: str) -> float:
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


def _sizes(scene: Scene, wall: float, fold: float) -> LegSizes:
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


def _estimates(sizes: LegSizes, scene: Scene, given: Mapping[str, str]) -> Values:
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


def _pulse(scene: Scene) -> Values:
    """A pulse that the bellows bear, and as slow as their network."""
    from viscodesign.estimate.scene_quantities import SceneQuantities

    b, modulus, sections = scene.bellows, scene.actuator.youngs_modulus, scene.bellows.count / 2
    pitch = scene.actuator.length / sections
    limits = (
        MOST_SWELLING * b.height * b.width / b.area_per_pressure,
        MOST_STRETCH * pitch * modulus / (2 * b.extension_per_pressure),
        MOST_TURN * modulus / (2 * sections * b.angle_per_pressure),
        MOST_VACUUM * (scene.ambient_pressure + scene.gauge_pressure),
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
