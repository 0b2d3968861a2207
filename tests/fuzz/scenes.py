"""Random specs that are valid by every rule of the schema, whatever they lead to."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

Draw = st.DrawFn
EFFECTS = (
    "pressure_distribution", "inertia", "rotary_inertia", "feedback", "gas_compressibility",
    "fluid_inertance", "flow_regime", "collapse", "fluid_mass", "damping",
)  # fmt: skip


def about(value: float, low: float = -1.0, high: float = 1.0) -> st.SearchStrategy[float]:
    """Numbers around one, over powers of ten."""
    return st.floats(low, high).map(lambda power: float(f"{value * 10**power:.6g}"))


@st.composite
def specs(draw: Draw) -> dict[str, Any]:
    """A whole spec as a mapping; sizes around the paper's, over some orders of magnitude."""
    sections = draw(st.integers(1, 6))
    inlets = draw(st.sampled_from([1, 1, 1, 2]))
    network, names = draw(networks(sections, inlets))
    fluid = draw(fluids())
    duration = draw(about(1.0, -3, 1))
    stiff = isinstance(fluid, str)
    inputs = {name: draw(sources(duration, syringe=stiff)) for name in names}
    spec: dict[str, Any] = {
        "name": "fuzz",
        "actuator": {
            "length": draw(about(0.109, -0.5, 0.5)),
            "height": draw(about(0.03, -0.3, 0.3)),
            "width": draw(about(0.02, -0.3, 0.3)),
            "youngs_modulus": draw(about(1.8e6, -0.5, 1.0)),
            "density": draw(about(950.0, -2, 2)),
            "solid_fraction": 0.47,
            "extension_factor": draw(about(0.53, -1, 2)),
            "bending_factor": 0.55,
            "damping_time": draw(st.sampled_from([0.0, 1e-4, 1e-3, 1e-2])),
        },
        "bellows": {
            "count": 2 * sections,
            "height": 0.01,
            "width": 0.012,
            "length": 0.018,
            "area_per_pressure": draw(about(3.413e-9, -1, 1)),
            "angle_per_pressure": draw(about(10.266, -1, 0.5)),
            "extension_per_pressure": draw(about(0.047, -1, 0.5)),
            "area_per_force": draw(st.one_of(st.just(0.0), about(3e-7, -1, 0.8))),
            "area_per_moment": draw(st.one_of(st.just(0.0), about(1.2e-6, -1, 1.9))),
        },
        "network": network,
        "fluid": fluid,
        "gauge_pressure": draw(st.sampled_from([0.0, 0.0, 2e4, -1e4])),
        "loads": draw(loads()),
        "effects": draw(effects(len(names))),
        "accuracy": draw(st.sampled_from([0.002, 0.005, 0.02])),
        "run": {
            "duration": duration,
            "output_interval": duration / draw(st.integers(1, 25)),
            "start": draw(st.sampled_from(["equilibrium", "equilibrium", "rest"])),
            "max_steps": 4_000,
        },
    }
    if names == ["inlet"]:
        spec["input"] = inputs["inlet"]
    else:
        spec["inputs"] = inputs
    return spec


@st.composite
def networks(draw: Draw, sections: int, inlets: int) -> tuple[dict[str, Any], list[str]]:
    """A named chain, or a random graph with junctions, loops and perhaps sealed parts."""
    radius, length = draw(about(3.25e-4, -0.5, 0.5)), draw(about(0.0375, -1, 1))
    sizes = {"tube_radius": radius, "tube_length": length}
    layouts = ["straight"] + (["crossed"] if sections % 2 == 0 else [])
    if inlets == 1 and draw(st.booleans()):
        return {"layout": draw(st.sampled_from(layouts)), **sizes}, ["inlet"]
    names = ["inlet"] if inlets == 1 else [f"in{k}" for k in range(inlets)]
    bellows = [f"{side}{j}" for side in "RL" for j in range(1, sections + 1)]
    nodes = [*names]
    tubes: list[dict[str, Any]] = []
    fed = draw(st.permutations(bellows))
    for k, node in enumerate(fed):
        if k >= inlets and draw(st.integers(0, 9)) == 0:
            continue  # a sealed bellow
        origin = names[k] if k < inlets else draw(st.sampled_from(nodes))
        tubes.append(_tube(draw, origin, node))
        nodes.append(node)
    for k in range(draw(st.integers(0, 2))):
        ends = draw(st.lists(st.sampled_from(nodes), min_size=2, max_size=2, unique=True))
        tubes += [_tube(draw, end, f"j{k}") for end in ends]
    if len(nodes) > 2 and draw(st.booleans()):
        ends = draw(st.lists(st.sampled_from(nodes), min_size=2, max_size=2, unique=True))
        tubes.append(_tube(draw, *ends))
    return {"layout": "custom", **sizes, "tubes": tubes}, names


def _tube(draw: Draw, start: str, end: str) -> dict[str, Any]:
    return {"from": start, "to": end, "length": draw(about(0.0375, -2, 2))}


@st.composite
def fluids(draw: Draw) -> Any:
    """A known one, or one of any viscosity."""
    if draw(st.booleans()):
        return draw(st.sampled_from(["air", "water"]))
    own = {
        "name": "own",
        "viscosity": draw(about(1e-3, -6, 6)),
        "density": draw(about(30, -1.5, 1.5)),
    }
    if draw(st.booleans()):
        own["gas_constant"] = 287.0
    return own


@st.composite
def sources(draw: Draw, duration: float, *, syringe: bool) -> dict[str, Any]:
    """One input of any kind."""
    high, low = draw(st.floats(-8e4, 1e5)), draw(st.floats(-5e4, 5e4))
    time = duration * draw(st.floats(0.05, 2.0))
    kinds: list[dict[str, Any]] = [
        {"kind": "constant", "value": high},
        {"kind": "step", "value": high, "time": duration * draw(st.sampled_from([0.0, 0.3]))},
        {"kind": "sine", "amplitude": abs(high), "mean": low / 2, "frequency": 1 / time},
        {"kind": "square", "high": high, "low": low, "frequency": 1 / time},
        {
            "kind": "trapezoid",
            "high": high,
            "low": low,
            "rise": time / 4,
            "hold": time / 4,
            "fall": time / 2,
        },
        {
            "kind": "double_sigmoid",
            "start": 4e4,
            "drop": abs(high),
            "fall_time": time / 4,
            "rise_time": time,
            "transition": time / 4,
        },
        {"kind": "table", "rows": [[0.0, low], [time / 2, high], [time, low / 3]]},
    ]
    if syringe:
        rows = [[0.0, 0.0], [time, draw(st.floats(-0.005, 0.02))]]
        kinds.append({"kind": "syringe", "diameter": 0.02, "start": 0.05, "rows": rows})
    return draw(st.sampled_from(kinds))


@st.composite
def loads(draw: Draw) -> dict[str, Any]:
    """None, or some of them."""
    found: dict[str, Any] = {}
    if draw(st.booleans()):
        found["gravity"] = {"tilt": draw(st.floats(0, 6.28))}
    if draw(st.integers(0, 2)) == 0:
        found["tip_force"] = {"x": draw(st.floats(-3, 3)), "z": draw(st.floats(-12, 3))}
    if draw(st.integers(0, 3)) == 0:
        found["payload"] = draw(about(0.02, -1, 1))
    return found


@st.composite
def effects(draw: Draw, inlets: int) -> Any:
    """Left to the scene, or some of them forced."""
    if draw(st.booleans()):
        return "auto"
    names = draw(st.lists(st.sampled_from(EFFECTS), unique=True, max_size=5))
    forced: dict[str, str] = {name: draw(st.sampled_from(["on", "off", "auto"])) for name in names}
    if inlets > 1:
        forced.pop("pressure_distribution", None)
    return {
        **forced,
        "others": draw(st.sampled_from(["auto", "auto", "off"] if inlets == 1 else ["auto"])),
    }
