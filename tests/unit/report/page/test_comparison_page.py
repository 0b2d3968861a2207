"""The page of a comparison: what it holds, and what it draws."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tests.trajectories import made_run
from viscodesign import Comparison, compare
from viscodesign.report.page.comparison_page import comparison_data, write_comparison_page
from viscodesign.results.coefficient_band import CoefficientBand, UncertainNumber

EVIL = "</script><b onclick=x>leg</b>"
POINTS = """() => [...document.querySelectorAll("#paths path.curve")].map((path) => {
  const [x0, x1, z0, z1] = path.ownerSVGElement.dataset.domain.split(" ").map(Number);
  const [p0, p1, q0, q1] = path.ownerSVGElement.dataset.range.split(" ").map(Number);
  return path.getAttribute("d").split(/[ML]/).slice(1).map((pair) => pair.split(" ").map(Number))
    .map(([p, q]) => [x0 + (p - p0) / (p1 - p0) * (x1 - x0), z0 + (q - q0) / (q1 - q0) * (z1 - z0)]);
})"""


def pair() -> Comparison:
    """Two runs, of which one failed and has a name that is HTML."""
    short = made_run(time=np.linspace(0, 3, 151), bending=0.8)
    return compare(made_run(), replace(short, name=EVIL, status="failed", failure="no step"))


def test_it_is_small_self_contained_and_takes_no_text_for_html(tmp_path: Path) -> None:
    text = write_comparison_page(pair(), tmp_path / "a" / "compare.html").read_text()
    assert len(text) < 150_000
    assert "default-src 'none'" in text
    assert EVIL not in text
    assert text.count("</script>") == 2
    assert "http://" not in text.replace("http://www.w3.org/2000/svg", "")


def test_long_motions_are_thinned_and_it_says_so() -> None:
    time = np.linspace(0, 8, 20_001)
    data = comparison_data(compare(made_run(), made_run(time=time)))
    assert any("1,500 of 20,001 rows of leg_made_up 2" in note for note in data["notes"])


def test_what_is_drawn_and_said(browser: Any, tmp_path: Path) -> None:
    found = pair()
    page, messages = browser.new_page(), []
    page.on("console", lambda message: messages.append(message.text))
    page.on("pageerror", lambda error: messages.append(str(error)))
    page.goto(write_comparison_page(found, tmp_path / "compare.html").as_uri())
    for drawn, motion in zip(page.evaluate(POINTS), found.motions, strict=True):
        np.testing.assert_allclose(drawn, 1e3 * motion.tip, atol=0.01)
    assert found.differences[0].sentence in page.inner_text("#differences")
    assert "failed at 3 s" in page.inner_text("#banners")
    assert page.query_selector("b") is None
    assert messages == []
    page.close()


def test_the_band_of_coefficients_is_drawn_and_told(browser: Any, tmp_path: Path) -> None:
    run = made_run(bending=0.8)
    rows = np.tile([4e-6, 1e-6, 0.0], (len(run.time), 1))
    known = UncertainNumber("fluid.viscosity", 1.0, "Pa*s", 0.1, False, 1.0)
    found = compare(made_run(), replace(run, uncertainty=CoefficientBand(rows, run.time, (known,))))
    page, messages = browser.new_page(), []
    page.on("pageerror", lambda error: messages.append(str(error)))
    page.goto(write_comparison_page(found, tmp_path / "compare.html").as_uri())
    box = page.evaluate("""() => {
      const band = document.querySelector("#paths path.band"), box = band.getBBox();
      const [x0, x1] = band.ownerSVGElement.dataset.domain.split(" ").map(Number);
      const [p0, p1] = band.ownerSVGElement.dataset.range.split(" ").map(Number);
      return box.width * (x1 - x0) / (p1 - p0);
    }""")
    expected = 1e3 * (np.ptp(run.tip[:, 0]) + 2 * 1.96 * 2e-3)
    assert abs(box - expected) < 0.02 * expected
    assert found.differences[0].band_sentence in page.inner_text("#differences")
    assert "+-3.92 mm (95 %)" in page.inner_text("#metrics")
    assert messages == []
    page.close()
