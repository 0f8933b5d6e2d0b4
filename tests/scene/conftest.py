"""Sample floors for the tests of the scene's stages."""

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest


@pytest.fixture(scope="session")
def sample_floors() -> ModuleType:
    """Return the module of sample furnish requests."""
    file = Path(__file__).with_name("sample_floors.py")
    spec = importlib.util.spec_from_file_location("sample_floors", file)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
