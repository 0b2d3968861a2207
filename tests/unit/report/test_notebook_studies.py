"""What notebooks show of studies: their main numbers, and the picture of their command."""

from __future__ import annotations

import base64
import re
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from tests.unit.report.every_picture import subject
from tests.unit.report.test_notebook import Tags
from viscodesign.report.layout.style import RC
from viscodesign.results.findings import Notice
from viscodesign.results.fit_result import Fit, FittedNumber


def _fit() -> Fit:
    numbers = (
        FittedNumber("fluid.viscosity", 1.3e-4, "Pa s", 1e-4, 1.2e-4, 1.4e-4),
        FittedNumber("actuator.youngs_modulus", 1.6e6, "Pa", 1.8e6, None, None, "no_end"),
    )
    return Fit(
        name="<b>leg</b>", version="0", spec_sha256="", status="complete", numbers=numbers,
        products=(), runs=subject("fit").runs, chi2_per_dof=1.0, effects=frozenset(), mesh={},
        spec="", warnings=("a clock that drifts",),
    )  # fmt: skip


STUDIES: dict[str, tuple[Any, tuple[str, ...]]] = {
    "compare": (lambda: subject("compare"), ("stated error", "differs from", "bent (failed")),
    "design": (
        lambda: replace(
            subject("design"), parameters={"input.period": 2.0}, units={"input.period": "s"}
        ),
        ("not met", "0.3 mm rms", "(allowed 0.1 mm rms)", "2 s"),
    ),
    "sweep": (
        lambda: subject("sweep_line"),
        ("incomplete", "0 mm (network.tube_length=0.01 m)", "row 1 failed"),
    ),
    "reach": (
        lambda: subject("reach"),
        ("one inlet", "6.28 cm²", "reached to 0.1 mm, stated error 0.02 mm"),
    ),
    "sensitivity": (lambda: subject("tornado"), ("% of the variance", "network.tube_radius")),
    "slopes": (lambda: subject("tornado_shifts"), ("by one percent",)),
    "fit": (_fit, ("0.00013 Pa s, 95 %: 0.00012 to 0.00014", "not known by these data", "drifts")),
}


@pytest.mark.parametrize("name", STUDIES)
def test_a_study_shows_its_numbers_and_its_picture(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(RC, "savefig.dpi", 20)
    make, words = STUDIES[name]
    page = make()._repr_html_()
    tags = Tags()
    tags.feed(page)
    assert tags.open == []
    assert "<b>" not in page
    assert [own for own in words if own not in page] == []
    (content,) = re.findall(r'src="data:image/png;base64,([^"]+)"', page)
    (shown,) = re.findall(r"width: (\d+)px", page)
    with Image.open(BytesIO(base64.b64decode(content))) as picture:
        assert float(shown) == pytest.approx(picture.size[0] * 96 / 20, abs=0.51)


def test_what_casts_doubt_on_a_study_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(RC, "savefig.dpi", 20)
    outside = (Notice("choking", "too fast"),)
    assert (
        "outside of the model: choking"
        in replace(subject("design"), violations=outside)._repr_html_()
    )
    study = subject("reach")
    point = replace(study.point, violations=outside)
    page = replace(study, point=point, interrupted=True, edge_failures=("it fell",))._repr_html_()
    assert [
        own
        for own in ("outside of the model: choking", "interrupted", "it fell")
        if own not in page
    ] == []


def test_a_sweep_without_rows_has_no_picture() -> None:
    page = replace(subject("sweep_line"), results={})._repr_html_()
    assert "<table>" in page
    assert "<img" not in page


def test_pictures_of_notebooks_leave_no_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setitem(RC, "savefig.dpi", 20)
    assert "<img" in subject("tornado_shifts")._repr_html_()
    assert list(tmp_path.iterdir()) == []
