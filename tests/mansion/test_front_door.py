"""What `import mansion` gives a script."""

import subprocess
import sys

import pytest

import mansion


@pytest.mark.parametrize("name", mansion.__all__)
def test_every_name_leads_to_its_home(name: str) -> None:
    assert getattr(mansion, name).__name__ == name
    assert name in dir(mansion)


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'castle'"):
        mansion.castle  # noqa: B018


def test_nothing_heavy_is_loaded_before_it_is_asked_for() -> None:
    code = "import sys, mansion; print([name for name in ('numba', 'shapely', 'rclpy') if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"
