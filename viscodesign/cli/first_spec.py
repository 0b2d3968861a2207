"""A spec of one's own actuator from a few sizes: what is not measured yet is estimated."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from string import Template

from viscodesign.cli.first_values import (
    Values,
    estimates,
    leg_sizes,
    not_given,
    option_length,
    pulse,
)

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

REMARKS_AT = 40
"""Column of the remarks."""


def first_spec(name: str, sets: Sequence[str], wall: str, fold: str | None) -> str:
    """The text of a spec for these sizes. Raises `ViscodesignError`.

    ``sets``: 'key.path=value'; of the coefficients, they are taken as measured.
    """
    from viscodesign import load

    fold = wall if fold is None else fold
    lengths = option_length("--wall", wall), option_length("--fold", fold)
    text = Template(TEXT).substitute(name=name, wall=wall, fold=fold)
    given = dict(_parted(change) for change in sets)
    scene = load(text, sets)
    sizes = leg_sizes(scene, *lengths)
    values = not_given(estimates(sizes, scene, given), given)
    scene = load(text, [*_as_sets(values), *sets])
    values |= not_given(pulse(scene), given)
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
