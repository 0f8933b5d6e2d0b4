"""Every notebook of ``examples/`` is kept without outputs, and its code runs from top to bottom."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from notebook_cells import cells_of, run_notebook

EXAMPLES = Path(__file__).parents[2] / "examples"
NOTEBOOKS = sorted(EXAMPLES.glob("*.ipynb"))
MOST_BYTES = 20_000


@pytest.fixture
def workplace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty working folder, and figures that open no window."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    yield tmp_path
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_is_small_and_has_no_outputs(notebook: Path) -> None:
    assert notebook.stat().st_size < MOST_BYTES
    for cell in cells_of(notebook):
        if cell["cell_type"] == "code":
            assert (cell["outputs"], cell["execution_count"]) == ([], None)


def test_the_readme_lists_every_notebook() -> None:
    text = (EXAMPLES / "README.md").read_text(encoding="utf-8")
    assert len(NOTEBOOKS) >= 2
    assert [notebook.name for notebook in NOTEBOOKS if f"]({notebook.name})" not in text] == []


def test_the_tour_ends_with_a_robot_in_the_kitchen(workplace: Path, capsys: pytest.CaptureFixture[str]) -> None:
    space, shown = run_notebook(EXAMPLES / "tour.ipynb")
    printed = capsys.readouterr().out
    assert "F1/living_room/mug_1" in printed and "faults: ()" in printed
    assert space["robot"].where_am_i().room == "F1/kitchen"
    assert space["task"].oracle
    assert len(space["flat"].objects.filter(category="mug", room="F1/living_room")) == 0
    assert any("<svg" in text for text in shown) and any("<table" in text for text in shown)
    space["flat"].close()


def test_the_experiment_runs_each_agent_at_each_task(workplace: Path) -> None:
    space, _ = run_notebook(EXAMPLES / "experiment.ipynb")
    rows: list[dict[str, Any]] = space["rows"]
    assert len(rows) == len(space["SEEDS"]) * space["TASKS"] * len(space["AGENTS"])
    assert all(row["success"] for row in rows if row["agent"] == "oracle")
    assert space["summary"]["oracle"][0] == 1.0
    for row in rows:
        assert row["skills"] > 0
