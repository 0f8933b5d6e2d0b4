"""What `import mansion` gives a script, and what it costs."""

import subprocess
import sys

import pytest

import mansion
from mansion_msgs_py import __version__


@pytest.mark.parametrize("name", [name for name in mansion.__all__ if not name.startswith("_")])
def test_every_name_leads_to_its_home(name: str) -> None:
    assert getattr(mansion, name).__name__ == name
    assert name in dir(mansion)


def test_the_version_is_that_of_the_packages() -> None:
    assert mansion.__version__ == __version__


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'castle'"):
        mansion.castle  # noqa: B018


def test_nothing_heavy_is_loaded_before_it_is_asked_for() -> None:
    heavy = ("gymnasium", "matplotlib", "mujoco", "networkx", "numba", "numpy", "rclpy", "rich", "shapely", "typer")
    code = f"import sys, mansion; print([name for name in {heavy!r} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"


def test_a_building_is_planned_and_read_without_the_middleware() -> None:
    code = (
        "import sys, mansion; mansion.plan('a small flat'); mansion.load; mansion.build; mansion.Robot;"
        "print([name for name in sys.modules if name.split('.')[0] == 'rclpy'])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"
