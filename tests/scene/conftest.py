"""Sample floors for the tests of the scene's stages."""

from types import ModuleType

import pytest

import sample_floors as module


@pytest.fixture(scope="session")
def sample_floors() -> ModuleType:
    """Return the module of sample furnish requests."""
    return module
