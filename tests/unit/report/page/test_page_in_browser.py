"""The page as a reader sees and drives it, in headless Chromium."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.scenes import CONFIGS
from tests.trajectories import VERDICTS, ablated_run, made_run, of_scene, with_two_inlets
from viscodesign import load, simulate
from viscodesign.cli.texts.run_text import both_errors
from viscodesign.report.layout.snapshots import normals
from viscodesign.report.run_folder import write_run
from viscodesign.results.coefficient_band import CoefficientBand, UncertainNumber
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Accuracy

from .conftest import Open

DRAWN = """chart => {
  const svg = chart.querySelector("svg[data-domain]");
  const [t0, t1, v0, v1] = svg.dataset.domain.split(" ").map(Number);
  const [x0, x1, y0, y1] = svg.dataset.range.split(" ").map(Number);
  const curves = [...svg.querySelectorAll("path.curve, path.path:not(.sketched)")].map((path) => [
    path.dataset.name || "tip",
    path.getAttribute("d").split(/[ML]/).slice(1).map((pair) => pair.split(" ").map(Number))
      .map(([x, y]) => [t0 + (x - x0) / (x1 - x0) * (t1 - t0), v0 + (y - y0) / (y1 - y0) * (v1 - v0)]),
  ]);
  return [curves, [(t1 - t0) / (x1 - x0), (v0 - v1) / (y1 - y0)].map(Math.abs)];
}"""
"""Curves of a chart, back from pixels to their units, and a pixel in each of these."""
PLAYED = """row => new Promise((done) => {
  const look = () => (player.row > row ? done() : requestAnimationFrame(look));
  look();
})"""
"""Waits until playing has passed a row; the page lets playwright's own waiting run no text."""
ROUNDING = 0.0051
"""Coordinates are written to a hundredth of a pixel [pixel]."""
Drawn = tuple[dict[str, np.ndarray], tuple[float, float]]


def drawn(page: Any, selector: str) -> list[Drawn]:
    found = [chart.evaluate(DRAWN) for chart in page.query_selector_all(selector)]
    return [({name: np.array(points) for name, points in curves}, px) for curves, px in found]


def columns(file: Path) -> dict[str, np.ndarray]:
    with file.open() as lines:
        rows = list(csv.reader(lines))
    return dict(zip(rows[0], np.array(rows[1:], dtype=float).T, strict=True))


def test_quantities_without_a_place_of_their_own_have_a_panel_each(open_page: Open) -> None:
    touched = replace(made_run(), contacts=("tip",))
    swing = np.sin(touched.time)[:, None]
    arrays = {
        f"contact_{name}": k * swing for k, name in enumerate(("normal", "tangential", "gap"), 1)
    }
    page = open_page(touched.with_arrays(**arrays))
    assert len(drawn(page, ".chart")) == 4 + 3
    for (found, pixel), factor in zip(drawn(page, ".chart")[4:], (1.0, 2.0, 3e3), strict=True):
        expected = touched.time, factor * swing[:, 0]
        for curve, values, size in zip(found["tip"].T, expected, pixel, strict=True):
            np.testing.assert_allclose(curve, values, rtol=1e-6, atol=ROUNDING * size)
    lines = page.eval_on_selector_all("#instant th", "all => all.map(one => one.textContent)")
    assert lines[-3:] == [
        "normal force of contact, tip [N]",
        "force of friction, tip [N]",
        "gap, tip [mm]",
    ]


def test_what_is_drawn_is_the_table(open_page: Open, tmp_path: Path) -> None:
    run = made_run()
    write_run(run, tmp_path, plots=False, report=False)
    page, written = open_page(run), columns(tmp_path / "trajectory.csv")
    tip, right, left, flow = drawn(page, ".chart")
    for (found, pixel), name, column, factor in (
        (tip, "x", "tip_x_m", 1e3),
        (tip, "z", "tip_z_m", 1e3),
        (right, "inlet", "inlet_pressure_pa", 1e-3),
        (right, "R3", "pressure_R3_pa", 1e-3),
        (left, "L8", "pressure_L8_pa", 1e-3),
        (flow, "R1-R2", "flow_R1-R2_m3_s", 1e6),
    ):
        expected = written["time_s"], factor * written[column]
        for curve, values, size in zip(found[name].T, expected, pixel, strict=True):
            np.testing.assert_allclose(curve, values, rtol=0, atol=ROUNDING * size)
    ((path, pixel),) = drawn(page, "#tip-path")
    expected = 1e3 * written["tip_x_m"], 1e3 * written["tip_z_m"]
    for curve, values in zip(path["tip"].T, expected, strict=True):
        np.testing.assert_allclose(curve, values, rtol=0, atol=ROUNDING * pixel[0])


def test_the_values_at_an_instant_are_those_of_the_table(open_page: Open, tmp_path: Path) -> None:
    run = made_run()
    write_run(run, tmp_path, plots=False, report=False)
    page, written = open_page(run), columns(tmp_path / "trajectory.csv")
    page.click("#instant summary")
    for row in (0, 123, 400):
        page.evaluate("row => seek(player, row)", row)
        cells = page.eval_on_selector_all(
            "#instant tr", "rows => rows.map(row => [...row.cells].map(cell => cell.textContent))"
        )
        shown = {name: float(text.replace("\N{MINUS SIGN}", "-")) for name, text in cells}
        for name, column, factor, rounding in (
            ("time [s]", "time_s", 1.0, 0.005),
            ("tip x [mm]", "tip_x_m", 1e3, 0.0005),
            ("pressure, inlet [kPa]", "inlet_pressure_pa", 1e-3, 0.0005),
            ("pressure, L5 [kPa]", "pressure_L5_pa", 1e-3, 0.00051),
            ("flow, inlet-R1 [mL/s]", "flow_inlet-R1_m3_s", 1e6, 0.000051),
        ):
            assert shown[name] == pytest.approx(factor * written[column][row], abs=rounding), name


def test_a_bellow_is_where_its_section_is(open_page: Open) -> None:
    run = made_run()
    page = open_page(run)
    page.evaluate("seek(player, 100)")
    tip = page.eval_on_selector(
        "#actuator .tip", "tip => [tip.cx.baseVal.value, tip.cy.baseVal.value]"
    )
    np.testing.assert_allclose(tip, 1e3 * run.tip[100, :2], atol=0.003)
    boxes = page.eval_on_selector_all(
        "#actuator .bellow",
        "all => all.map(e => e.getBBox()).map(b => [b.x + b.width / 2, b.y + b.height / 2])",
    )
    middle = 1e3 * run.shape[100, 4 + 8 * np.arange(8)]
    between = (np.array(boxes[:8]) + np.array(boxes[8:])) / 2
    assert np.all(np.hypot(*(between - middle).T) < 2)
    assert len({cell.get_attribute("fill") for cell in page.query_selector_all(".bellow")}) > 8


def test_keys_slider_speed_and_play_move_the_time(open_page: Open) -> None:
    page = open_page(made_run())

    def clock() -> str:
        return str(page.text_content("#clock"))

    assert clock() == "t = 0.00 s"
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Shift+ArrowRight")
    assert clock() == "t = 0.22 s"
    page.keyboard.press("End")
    assert clock() == "t = 8.00 s"
    page.keyboard.press("Home")
    page.focus("#time")
    page.keyboard.press("ArrowRight")
    assert (clock(), page.get_attribute("#time", "aria-valuetext")) == ("t = 0.02 s",) * 2
    page.fill("#time", "200")
    assert clock() == "t = 4.00 s"
    page.keyboard.press("+")
    assert page.input_value("#speed") == "2"
    page.select_option("#speed", "0.25")  # slow enough for a busy machine
    page.evaluate("document.activeElement.blur()")
    page.keyboard.press("Space")
    assert page.text_content("#play") == "Pause"
    page.evaluate(PLAYED, 203)
    page.click("#play")
    assert page.text_content("#play") == "Play"
    chart = page.query_selector(".chart svg[data-domain]").bounding_box()
    page.mouse.click(chart["x"] + 52 + (chart["width"] - 62) / 2, chart["y"] + 60)
    assert clock() == "t = 4.00 s"


def test_a_warning_leads_to_its_time(open_page: Open) -> None:
    page = open_page(
        made_run(
            warnings=(
                Notice("late", "after the end", "", 99.0),
                Notice("cavitation", "near", "inlet", 1.0),
            )
        )
    )
    page.click("#warnings button")
    assert page.text_content("#clock") == "t = 1.00 s"
    assert "not shown" in str(page.text_content("#warnings li"))


WIDE = """new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(
  Math.max(document.documentElement.scrollWidth, ...[...document.querySelectorAll("fieldset, .stacked *")]
    .map((own) => own.getBoundingClientRect().right))))))"""
"""How far the page and what must be read without scrolling reach [pixel]."""


@pytest.mark.parametrize("kind", ["ablated", "one_time", "interrupted"])
def test_no_screen_is_too_narrow(open_page: Open, kind: str) -> None:
    changes: dict[str, Any] = {
        "ablated": {},
        "one_time": {"time": np.ones(1), "inlet": lambda t: 0 * t + 2e4},
        "interrupted": {"time": np.linspace(0, 1.23, 62), "status": "interrupted"},
    }[kind]
    page = open_page(of_scene(ablated_run(**changes), load(CONFIGS / "leg.yaml")))
    assert page.is_visible("fieldset") == (kind != "one_time")
    for width in (1200, 375, 320):
        page.set_viewport_size({"width": width, "height": 700})
        assert page.evaluate(WIDE) <= width


CONTRASTS = """() => {
  const light = (text) => luminance(text.match(/[\\d.]+/g).slice(0, 3).map((v) => v / 255));
  const ground = light(getComputedStyle(document.body).backgroundColor);
  return [...document.querySelectorAll("path.curve, .dot, path.path, .key path")].map((own) => {
    const style = getComputedStyle(own), on = light(own.matches(".dot") ? style.fill : style.stroke);
    return (Math.max(on, ground) + 0.05) / (Math.min(on, ground) + 0.05);
  });
}"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_every_curve_is_seen_on_its_ground(open_page: Open, scheme: str) -> None:
    page = open_page(made_run())
    page.emulate_media(color_scheme=scheme)
    contrasts = page.evaluate(CONTRASTS)
    assert len(contrasts) > 60
    assert min(contrasts) > 3


def test_what_was_measured_stands_beside_the_estimate(open_page: Open) -> None:
    page = open_page(
        ablated_run(accuracy=Accuracy(5e-4, 1.33e-4, "by halves", None, None, 1.33e-4))
    )
    rows = {
        row.query_selector("th").text_content(): row
        for row in page.query_selector_all("#effects tbody tr")
    }
    told = {name: row.query_selector_all("td")[3].text_content() for name, row in rows.items()}
    assert told["pressure distribution"] == "98.7 mm"
    assert told["flow regime"] == "97.4 mm"
    assert told["gas compressibility"] == "no solution"
    assert told["fluid inertance"] == "< 1e−6 mm"
    bar = rows["pressure distribution"].query_selector("svg").get_attribute("aria-label")
    assert bar == "22800 % of the accuracy; measured: 19700 % of the accuracy"
    assert "add up to 2.43 mm" in page.text_content("#effects")
    parts = page.query_selector_all("#accuracy .stacked tbody tr")
    assert [part.text_content() for part in parts] == [
        "all parts together26.6 % of the accuracy0.133 mm"
    ]


def test_an_error_that_exceeds_the_motion_is_told_first(open_page: Open) -> None:
    doubt = Notice("unresolved_motion", "the stated error exceeds the whole motion", "tip")
    page = open_page(
        made_run(warnings=(doubt,), inlet=lambda t: 4e4 + 10 * np.sin(t), bending=1e-3)
    )
    assert "the stated error exceeds the whole motion" in page.text_content("#banners")
    colours = {cell.get_attribute("fill") for cell in page.query_selector_all(".bellow")}
    apart = np.ptp([[int(v) for v in own[4:-1].split(",")] for own in colours], axis=0)
    assert apart.max() < 30  # of 163: 20 Pa are no motion
    cut = "all => all.filter((own) => own.getBBox().x < 0 && !own.transform.baseVal.length).length"
    assert page.eval_on_selector_all(".tip-path text, .chart text", cut) == 0


COVERED = """([places, pressures, low, high]) => {
  const scale = pressureScale(low, high), step = (scale.high - scale.low) / COLOURS;
  const cells = [...document.querySelectorAll("#actuator .bellow")], at = cells[0].ownerSVGElement.createSVGPoint();
  const wrong = places.filter(([x, y], k) => {
    Object.assign(at, { x, y });
    const colour = Math.max(0, Math.min(COLOURS - 1, Math.floor((pressures[k] - scale.low) / step)));
    return !cells[colour].isPointInFill(at);
  });
  return [wrong.length, cells.reduce((sum, own) => sum + own.getAttribute("d").length, 0)];
}"""


def test_neighbours_in_one_outline_cover_every_bellow(open_page: Open) -> None:
    run, row = made_run(bellows=1024, lag=1e-5), 75
    page = open_page(run)
    page.evaluate(f"seek(player, Array.from(player.time).indexOf({run.time[row]}))")
    sides = 0.25 * run.width * normals(run.shape[row])[4::8]
    middle = run.shape[row, 4::8]
    places = 1e3 * np.concatenate([middle + sides, middle - sides])
    pressures = np.hstack([run.pressure, run["inlet_pressure"]])
    limits = float(pressures.min()), float(pressures.max())
    given = [places.tolist(), run.pressure[row].astype("f4").tolist(), *limits]
    wrong, characters = page.evaluate(COVERED, given)
    assert wrong == 0
    assert characters < 20_000  # 55,000 with an outline for each


def test_texts_of_a_spec_do_nothing(open_page: Open) -> None:
    attack = (
        "</script><script>window.hit=1</script><img src=http://localhost/x onerror='window.hit=1'>"
    )
    run = made_run()
    hostile = replace(
        with_two_inlets(run, -0.5),
        name=attack,
        failure=attack,
        status="failed",
        version=attack,
        inlets=(attack, "right"),
        tubes=tuple(f"{attack}-{name}" for name in run.tubes),
        warnings=(Notice(attack, attack, attack, 1.0),),
        violations=(Notice(attack, attack, attack, 1.0),),
        effects=tuple(replace(row, reason=attack, name=attack) for row in VERDICTS),
        spec_text=f"name: {attack}",
        settings={attack: attack},
        provenance={"python": attack, "packages": {attack: attack}},
    )
    page = open_page(hostile)
    assert page.evaluate("window.hit") is None
    assert page.text_content("h1") == attack
    assert attack in page.text_content("#warnings")
    assert page.query_selector("img") is None
    assert len(page.query_selector_all("script")) == 2


def test_a_failed_run_looks_like_one(open_page: Open) -> None:
    part = made_run(time=np.linspace(0, 1.23, 62), status="failed", failure="no step was found")
    page = open_page(part)
    assert page.title() == "FAILED: leg_made_up"
    alert = page.text_content("[role=alert]")
    assert "failed: it ended at t = 1.23 s" in alert
    assert "no step was found" in alert
    assert page.text_content("#clock") == "t = 1.23 s"
    assert "part that was computed" in page.text_content("#metrics")


def test_an_interrupted_run_says_so(open_page: Open) -> None:
    page = open_page(made_run(time=np.linspace(0, 1.23, 62), status="interrupted"))
    assert page.title() == "INTERRUPTED: leg_made_up"
    assert "interrupted: it ended at t = 1.23 s" in page.text_content("[role=alert]")


@pytest.mark.parametrize("mode", ["auto", "off"])
def test_an_error_of_pinned_effects_says_so(open_page: Open, mode: str) -> None:
    own = tuple(replace(verdict, mode=mode, taken=False) for verdict in VERDICTS[:1])
    run = made_run(effects=own, accuracy=Accuracy(5e-4, 1e-4, "made up"))
    words = open_page(run).text_content("#accuracy")
    assert (", of the model as pinned; requested" in words) == (mode == "off")
    assert (run.error_qualifier != "") == (mode == "off")


def test_one_output_time_has_no_player_and_no_sketch(open_page: Open) -> None:
    page = open_page(made_run(time=np.array([1.25]), inlet=lambda t: 0 * t + 2e4))
    assert not page.is_visible("#player")
    assert not page.is_visible("#sketch-body")
    assert page.is_visible("#actuator svg")
    assert page.text_content("#actuator .clock") == "t = 1.25 s"
    assert "One output time only, t = 1.25 s" in page.text_content("#banners")
    places = [dot.bounding_box() for dot in page.query_selector_all(".chart .dot")]
    assert len(places) > 16
    assert all(place["width"] > 4 for place in places)
    charts = page.query_selector_all(".chart svg[data-domain]")
    assert {chart.query_selector_all("text")[-1].text_content() for chart in charts} == {"1.25 s"}


def test_paper_has_the_instant_and_the_spec(open_page: Open) -> None:
    page = open_page(made_run())
    page.evaluate("seek(player, 100)")
    page.emulate_media(media="print")
    page.evaluate("window.dispatchEvent(new Event('beforeprint'))")
    assert page.is_visible("#actuator .clock")
    assert page.text_content("#actuator .clock") == "t = 2.00 s"
    assert page.is_visible("#spec")
    page.evaluate("window.dispatchEvent(new Event('afterprint'))")
    assert not page.is_visible("#spec")


def test_nothing_computed_is_no_empty_picture(open_page: Open) -> None:
    run = made_run(time=np.linspace(0, 1, 5), status="failed", failure="no start")
    empty = {name: values[:0] for name, values in run.arrays.items()}
    page = open_page(_without_metrics(run.with_arrays(**empty)))
    assert "Nothing was computed" in page.text_content("#motion")
    assert not page.is_visible("#player")


def _without_metrics(run: Any) -> Any:
    class Bare(type(run)):  # type: ignore[misc]
        metrics: dict[str, float] = {}  # noqa: RUF012

    return Bare(**{name: getattr(run, name) for name in run.__dataclass_fields__})


SKETCHED = {
    "leg_16_crossed_air": ("run.duration=2 s", "run.output_interval=5 ms"),
    "branched_tree": ("run.duration=1 s",),
    "antagonistic_two_inlets": ("run.duration=2 s",),
}


@pytest.mark.parametrize("name", SKETCHED)
def test_the_sketch_is_the_quasi_static_linear_solution(open_page: Open, name: str) -> None:
    linear = ("effects={others: off, pressure_distribution: on}", "loads.gravity=off")
    run = simulate(load(CONFIGS / f"{name}.yaml", [*linear, *SKETCHED[name]]), verify=False)
    page = open_page(run)
    found = page.evaluate("({x: [...sketch.motion.x], z: [...sketch.motion.z]})")
    distance = np.hypot(found["x"] - run.tip[:, 0], found["z"] - run.tip[:, 1])
    assert distance.max() < 1e-3 * run.length
    assert np.ptp(run.tip[:, 0]) > 0.02 * run.length


def test_a_slider_is_a_design_of_its_own(open_page: Open) -> None:
    """Twice the viscosity and half the tubes are the tool's own solution of that spec."""
    linear = (
        "effects={others: off, pressure_distribution: on}",
        "run.duration=2 s",
        "run.output_interval=5 ms",
    )
    spec = CONFIGS / "leg_16_crossed_air.yaml"
    computed = simulate(load(spec, linear), verify=False)
    page = open_page(computed)
    change = (
        "network={layout: straight, tube_radius: 0.325 mm, tube_length: 75 mm}",
        "input.start=20.205 kPa",
        "input.drop=70.65 kPa",
    )
    other = simulate(load(spec, [*linear, *change]), verify=False)
    page.check("#sketch-straight")
    page.fill("#sketch-length_factor", "0.5")
    page.fill("#sketch-amplitude", "0.5")
    assert "75 mm" in page.text_content("#sliders")
    page.evaluate("seek(player, 300)")
    end = "path => { const p = path.getPointAtLength(1e9); return [p.x, p.y]; }"
    ghost = page.eval_on_selector("#sketch-figure .ghost", end)
    np.testing.assert_allclose(ghost, 1e3 * computed.tip[300, :2], atol=0.02)
    found = page.evaluate("({x: [...sketch.motion.x], z: [...sketch.motion.z]})")
    distance = np.hypot(found["x"] - other.tip[:, 0], found["z"] - other.tip[:, 1])
    assert distance.max() < 1e-3 * other.length
    page.click("#sketch-reset")
    assert page.evaluate(
        "JSON.stringify(sketch.choice) === JSON.stringify(unchanged(sketch.numbers))"
    )


def test_readable_by_screen_readers_and_by_weak_eyes(open_page: Open) -> None:
    axe = pytest.importorskip("axe_playwright_python.sync_playwright", reason="needs axe")
    run = ablated_run(time=np.linspace(0, 1.23, 62), status="failed", failure="it broke")
    page = open_page(run, bypass_csp=True)
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        found = axe.Axe().run(page).response["violations"]
        told = [(row["id"], [node["html"][:120] for node in row["nodes"]]) for row in found]
        assert told == [], json.dumps([scheme, told], indent=1)


def test_the_band_of_the_coefficients_is_drawn_about_the_path(open_page: Open) -> None:
    run = made_run()
    variances = np.tile([4e-6, 1e-6, 1e-6], (len(run.time), 1))
    page = open_page(replace(run, uncertainty=CoefficientBand(variances, run.time, ())))
    ways = page.evaluate("document.querySelector('.tip-path .band').getAttribute('d')").split("Z")[
        :-1
    ]
    assert 100 < len(ways) <= 200
    corners = np.array([[float(v) for v in pair.split()] for pair in ways[0][1:].split("L")])
    domain, places = (
        [float(v) for v in page.get_attribute("svg.tip-path", f"data-{name}").split()]
        for name in ("domain", "range")
    )
    x = np.interp(corners[:, 0], places[:2], domain[:2])
    z = np.interp(corners[:, 1], places[2:], domain[2:])
    expected = 1e3 * (run.tip[0, :2] + CoefficientBand(variances, run.time, ()).ellipse(0, 400))
    for drawn_ones, wanted in ((x, expected[:, 0]), (z, expected[:, 1])):
        assert np.ptp(drawn_ones) == pytest.approx(np.ptp(wanted), rel=0.02)
        assert np.mean(drawn_ones) == pytest.approx(np.mean(wanted), abs=0.05)
    assert np.corrcoef(x, z)[0, 1] == pytest.approx(
        0.5, abs=0.02
    )  # covariance over both deviations
    assert page.query_selector("svg.tip-path .path") is not None


def test_what_is_known_of_the_coefficients_is_told_whole(open_page: Open) -> None:
    run, rows = made_run(), np.ones((len(made_run().time), 1))
    known = [
        UncertainNumber(f"bellows.{name}_per_pressure", 3.413e-9, "m^2/Pa", 3.413e-10, own, share)
        for name, own, share in (("extension", True, 0.6), ("area", False, 0.3999))
    ]
    small = [replace(known[1], key=f"bellows.{name}", share=5e-5) for name in ("width", "height")]
    band = CoefficientBand(rows * [4e-6, 1e-6, 1e-6], run.time, (*known, *small))
    page = open_page(replace(run, uncertainty=band), width=1200)
    table = page.query_selector("[aria-label='Table: uncertain numbers']")
    assert table.evaluate("own => own.scrollWidth - own.clientWidth") == 0
    assert len(table.query_selector_all("tbody tr")) == 2
    assert "10 %, assumed" in table.inner_text()
    assert "10 %, stated" in table.inner_text()
    assert "And 2 more, each below 0.05 % of the variance" in page.inner_text("#accuracy")
    assert page.query_selector("#band-key .key") is not None


@pytest.mark.parametrize("known", ["moving", "still", "left out", "failed", "unstated"])
def test_both_errors_are_told_as_by_the_command_line(known: str, open_page: Open) -> None:
    run = made_run()
    number = UncertainNumber("fluid.viscosity", 1.0, "Pa*s", 0.1, True, 1.0)
    size = np.tile([4e-6, 1e-6, 1e-6], (len(run.time), 1))
    changes: dict[str, Any] = {
        "moving": {"uncertainty": CoefficientBand(size, run.time, (number,))},
        "still": {"uncertainty": CoefficientBand(0 * size, run.time, ())},
        "left out": {"spec_text": f"uncertainty: typical\n{run.spec_text}"},
        "failed": {"warnings": (Notice("no_band", "no derivatives", "uncertainty"),)},
        "unstated": {},
    }
    told = replace(run, **changes[known])
    page = open_page(told)
    said = f"Both errors: {both_errors(told).replace('+-', '±')}."
    assert page.inner_text("#both-errors") == said.replace("`", "")
    assert (page.query_selector("#both-errors code") is not None) == ("`" in said)
    assert (page.query_selector(".tip-path .band") is not None) == (known == "moving")


def test_without_a_band_none_is_drawn(open_page: Open) -> None:
    assert open_page(made_run()).query_selector(".band") is None
