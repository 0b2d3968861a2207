"""The notebooks run from top to bottom, in a kernel as a notebook server starts it."""

from __future__ import annotations

import itertools
import os
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from tests.scenes import ROOT

NOTEBOOKS = ROOT / "examples" / "notebooks"
MOST_CELLS = 12
LONGEST_CELL_S = 300
SHOWN = {
    "1_how_does_my_leg_move": {"text/html": 3, "image/png": 1},
    "2_which_tube_and_which_fluid": {"text/html": 2, "image/png": 1},
    "3_a_path_that_i_want": {"text/html": 1},
    "4_numbers_from_my_video": {"text/html": 2},
    "5_rehearse_a_pump": {"image/png": 1},
    "6_two_runs_beside_each_other": {"text/html": 2},
}
"""How many tables, pages and pictures each notebook shows."""


@pytest.fixture(scope="module")
def nbformat() -> Any:
    """The format of notebooks; without it and a kernel there is nothing to run."""
    for name in ("nbclient", "ipykernel"):
        pytest.importorskip(name, reason=f"needs {name}: pip install 'viscodesign[dev]'")
    return pytest.importorskip("nbformat")


def files() -> list[Path]:
    return sorted(NOTEBOOKS.glob("*.ipynb"))


def test_every_notebook_is_known() -> None:
    assert [file.stem for file in files()] == list(SHOWN)


def test_notebooks_are_short_and_kept_without_outputs(nbformat: Any) -> None:
    for file in files():
        book = nbformat.read(file, as_version=4)
        nbformat.validate(book)
        assert len(book.cells) < MOST_CELLS
        assert book.cells[0].cell_type == "markdown"
        assert book.cells[0].source.startswith("# ")
        assert not any(cell.get("outputs") for cell in book.cells)


@pytest.mark.filterwarnings("default")
def test_notebooks_run_and_show_what_they_promise(
    nbformat: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One after the other in one kernel, which costs seconds to start; each begins with no names."""
    from nbclient import NotebookClient

    monkeypatch.delenv("MPLBACKEND", raising=False)  # the kernel has a backend of its own
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(ROOT), os.environ.get("PYTHONPATH", "")]))
    books = [nbformat.read(file, as_version=4) for file in files()]
    cells = [[nbformat.v4.new_code_cell("%reset -f"), *book.cells] for book in books]
    together = nbformat.v4.new_notebook(
        cells=list(itertools.chain(*cells)), metadata=books[0].metadata
    )
    client = NotebookClient(
        together, timeout=LONGEST_CELL_S, kernel_name="python3",
        resources={"metadata": {"path": str(NOTEBOOKS)}},
    )  # fmt: skip
    client.execute()
    for file, own in zip(files(), cells, strict=True):
        outputs = [output for cell in own for output in cell.get("outputs", [])]
        told = [output.text for output in outputs if output.get("name") == "stderr"]
        assert told == [], file.name
        kinds = Counter(kind for output in outputs for kind in output.get("data", {}))
        assert {kind: kinds[kind] for kind in SHOWN[file.stem]} == SHOWN[file.stem], file.name
