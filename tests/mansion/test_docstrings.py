"""Every example of the front door's docstrings runs; `b` is a building and `mansion` is imported."""

import doctest
import importlib
import pkgutil
from pathlib import Path

import pytest

import mansion

MODULES = ["mansion", *(f"mansion.{entry.name}" for entry in pkgutil.iter_modules(mansion.__path__))]


def examples() -> list[doctest.DocTest]:
    finder = doctest.DocTestFinder(exclude_empty=True)
    found = [test for name in MODULES for test in finder.find(importlib.import_module(name), name)]
    return [test for test in found if test.examples]


@pytest.mark.parametrize("test", examples(), ids=lambda test: test.name)
def test_an_example_does_what_it_says(
    test: doctest.DocTest, copy: mansion.Building, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    if "b.env(" in test.docstring or "b.look(" in test.docstring or "b.edit(" in test.docstring:
        pytest.importorskip("mujoco")
        pytest.importorskip("gymnasium")
    test.globs = {**test.globs, "mansion": mansion, "b": copy}
    said: list[str] = []
    doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=said.append)
    assert not said, "".join(said)


def test_the_parts_of_the_front_door_have_examples() -> None:
    shown = " ".join(test.name for test in examples())
    for name in ("build", "load", "plan", "Building.edit", "Building.look", "Building.env", "Robot", "Objects.find"):
        assert f".{name}" in shown
