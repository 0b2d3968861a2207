"""The bundled specs tell where they come from, and are found where they are installed."""

from __future__ import annotations

from pathlib import Path

import pytest

from viscodesign import check, load, simulate
from viscodesign.cli import templates
from viscodesign.errors import ViscodesignError
from viscodesign.scene.effects_choice import EffectsChoice

from .conftest import CONFIGS

SPECS = sorted(CONFIGS.glob("*.yaml"))


@pytest.mark.parametrize("spec", SPECS, ids=lambda path: path.stem)
def test_a_header_names_source_and_assumptions(spec: Path) -> None:
    lines = spec.read_text().splitlines()
    header = "\n".join(line for line in lines if line.startswith("#"))
    assert "Source: " in header or "Not in the paper" in header
    assert "Assumptions" in header
    assert "material damping" in header
    assert f"name: {spec.stem}" in lines
    assert max(map(len, lines)) <= 100


def test_a_wheel_keeps_its_specs_inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    inside = tmp_path / "viscodesign" / "configs"
    inside.mkdir(parents=True)
    (inside / f"{templates.DEFAULT}.yaml").write_text("# A leg.\n#\n# Source: here\nname: leg\n")
    monkeypatch.setattr(templates, "FOLDERS", (inside, tmp_path / "configs"))
    found = templates.templates()
    assert list(found) == [templates.DEFAULT]
    assert found[templates.DEFAULT].summary() == "A leg."


def test_no_specs_anywhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(templates, "FOLDERS", (tmp_path,))
    with pytest.raises(ViscodesignError, match="install viscodesign again"):
        templates.templates()


def test_the_first_leg_is_sound() -> None:
    """Its choice of effects is free, and nothing is to be warned of."""
    scene = load(templates.template(templates.DEFAULT).path)
    assert scene.effects == EffectsChoice()
    assert check(scene).warnings == ()
    run = simulate(scene, verify=False)
    assert (run.status, run.validity, run.warnings) == ("complete", "inside", ())
