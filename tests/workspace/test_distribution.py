"""One wheel of everything at the root, and a package for colcon in each folder of src."""

import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = sorted(folder.name for folder in (ROOT / "src").iterdir() if (folder / "package.xml").exists())


def test_the_wheel_has_every_package() -> None:
    tools = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["setuptools"]
    assert tools["package-dir"] == {name: f"src/{name}/{name}" for name in PACKAGES}
    assert tools["packages"]["find"]["where"] == [f"src/{name}" for name in PACKAGES]


@pytest.mark.parametrize("name", ["setup.py", "setup.cfg", "package.xml"])
def test_the_root_is_no_package_for_colcon(name: str) -> None:
    assert not (ROOT / name).exists()


@pytest.mark.skipif(shutil.which("colcon") is None, reason="colcon is not installed")
def test_colcon_lists_every_package() -> None:
    done = subprocess.run(
        ["colcon", "list", "--names-only", "--base-paths", str(ROOT)],
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    assert sorted(done.stdout.split()) == PACKAGES
