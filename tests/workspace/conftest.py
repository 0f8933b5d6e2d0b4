"""The checkout under test, and the list of its packages."""

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def root() -> Path:
    """The checkout."""
    return ROOT


@pytest.fixture(scope="session")
def packages() -> list[Path]:
    """The folders of the ament_python packages."""
    return sorted(path.parent for path in ROOT.glob("src/*/package.xml"))
