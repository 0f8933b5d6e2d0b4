"""One wheel of everything at the root, and a package for colcon in each folder of src."""

import os
import shutil
import subprocess
import sys
import tomllib
import zipfile
from email.parser import Parser
from pathlib import Path

import pytest

from mansion_msgs_py import __version__

ROOT = Path(__file__).resolve().parents[2]
EXTRAS = {
    "cluster",
    "convex",
    "dxf",
    "embeddings",
    "ifc",
    "llm",
    "record",
    "rerun",
    "sim",
    "thor",
    "usd",
    "vectors",
    "world",
}
PACKAGES = sorted(folder.name for folder in (ROOT / "src").iterdir() if (folder / "package.xml").exists())


def test_the_wheel_has_every_package() -> None:
    tools = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["setuptools"]
    assert tools["package-dir"] == {name: f"src/{name}/{name}" for name in PACKAGES}
    assert tools["packages"]["find"]["where"] == [f"src/{name}" for name in PACKAGES]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> zipfile.ZipFile:
    """The wheel that pip makes of a copy of the checkout, with what is installed here and nothing fetched."""
    pytest.importorskip("wheel")
    folder = tmp_path_factory.mktemp("distribution")
    source = folder / "source"
    shutil.copytree(ROOT / "src", source / "src", ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info"))
    shutil.copytree(ROOT / "requirements", source / "requirements")
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy2(ROOT / name, source)
    options = ["--no-deps", "--no-build-isolation", "--no-index", "--quiet", "--wheel-dir", str(folder)]
    subprocess.run([sys.executable, "-m", "pip", "wheel", *options, str(source)], check=True, timeout=240)
    return zipfile.ZipFile(next(folder.glob("*.whl")))


def test_every_file_of_every_package_is_in_the_wheel(wheel: zipfile.ZipFile) -> None:
    files = {
        str(path.relative_to(ROOT / "src" / package))
        for package in PACKAGES
        for path in (ROOT / "src" / package / package).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    assert files - set(wheel.namelist()) == set()


def test_what_ros_launches_and_shows_is_in_the_wheel(wheel: zipfile.ZipFile) -> None:
    shared = {name.partition("/data/share/")[2] for name in wheel.namelist()}
    bringup = ROOT / "src" / "mansion_bringup"
    wanted = {path for folder in ("launch", "config", "rviz") for path in (bringup / folder).glob("*.*")}
    assert {f"mansion_bringup/{path.relative_to(bringup)}" for path in wanted} <= shared


def test_the_wheel_has_the_commands_the_version_and_the_extras(wheel: zipfile.ZipFile) -> None:
    info = next(name for name in wheel.namelist() if name.endswith("METADATA"))
    metadata = Parser().parsestr(wheel.read(info).decode())
    assert metadata["Version"] == __version__
    assert set(metadata.get_all("Provides-Extra") or []) == EXTRAS
    points = wheel.read(info.replace("METADATA", "entry_points.txt")).decode()
    assert "mansion = mansion_bringup.cli:main" in points
    assert "[gymnasium.envs]" in points


def test_the_wheel_works_away_from_the_checkout(wheel: zipfile.ZipFile, tmp_path: Path) -> None:
    wheel.extractall(tmp_path)
    code = "import mansion; print(mansion.__file__); print(len(mansion.plan('a two-storey office').floors))"
    done = subprocess.run(
        [sys.executable, "-P", "-c", code],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    assert done.stdout.splitlines() == [str(tmp_path / "mansion" / "__init__.py"), "2"]


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
