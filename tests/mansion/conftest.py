"""A small building of the front door, built once, and copies of it to change."""

from pathlib import Path

import pytest

import mansion

BRIEF = "a small flat for two"


@pytest.fixture(scope="session")
def flat(tmp_path_factory: pytest.TempPathFactory) -> mansion.Building:
    """A flat that nobody changes."""
    return mansion.build(BRIEF, tmp_path_factory.mktemp("front_door") / "flat", seed=4)


@pytest.fixture
def copy(flat: mansion.Building, tmp_path: Path) -> mansion.Building:
    """A copy of the flat."""
    return flat.save(tmp_path / "flat")
