"""The runs of several actuators, read again from their folder."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.coupled_specs import FLOW_ALONE, coupled_spec
from viscodesign import load_several, simulate_several
from viscodesign.cli.main import main
from viscodesign.report.page.several_page import several_data
from viscodesign.report.read_several import read_several


def test_runs_of_several_are_drawn_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    runs = simulate_several(load_several(coupled_spec(effects=FLOW_ALONE)), verify=False)
    runs.save(tmp_path, plots=False)
    found = read_several(tmp_path)
    assert found.summary()["sources"] == runs.summary()["sources"]
    assert several_data(found)["shared"] == several_data(runs)["shared"]
    for name, run in runs.runs.items():
        assert np.array_equal(found[name].tip, run.tip)
    (tmp_path / "report.html").unlink()
    assert main(["report", str(tmp_path), "--pictures"]) == 0
    written = {Path(line).relative_to(tmp_path) for line in capsys.readouterr().out.split()}
    assert written >= {Path("report.html"), Path("tips.png"), Path("left/report.html"),
                       Path("right/tip.png")}  # fmt: skip
    assert main(["report", str(tmp_path), "--film", str(tmp_path / "all.gif")]) == 2
    assert "a film shows one" in capsys.readouterr().err
