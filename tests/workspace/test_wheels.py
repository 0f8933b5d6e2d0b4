"""Each package builds into a wheel that carries its data files and type marker."""

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

pytest.importorskip("wheel")


@pytest.fixture(scope="module")
def wheels(packages: list[Path], tmp_path_factory: pytest.TempPathFactory) -> dict[str, set[str]]:
    """Package name -> names in its wheel, built from a copy of the sources."""
    folder = tmp_path_factory.mktemp("wheels")
    ignore = shutil.ignore_patterns("__pycache__", "build", "*.egg-info")
    sources = [shutil.copytree(package, folder / "src" / package.name, ignore=ignore) for package in packages]
    for source in sources:
        command = [sys.executable, "setup.py", "--quiet", "bdist_wheel", "--dist-dir", str(folder)]
        subprocess.run(command, cwd=source, check=True, timeout=60, stderr=subprocess.DEVNULL)
    return {path.name.split("-")[0]: set(zipfile.ZipFile(path).namelist()) for path in sorted(folder.glob("*.whl"))}


def test_every_file_of_a_package_is_in_its_wheel(packages: list[Path], wheels: dict[str, set[str]]) -> None:
    assert list(wheels) == [package.name for package in packages]
    for package in packages:
        files = {
            str(path.relative_to(package))
            for path in (package / package.name).rglob("*")
            if path.is_file() and "__pycache__" not in path.parts
        }
        assert f"{package.name}/py.typed" in files
        assert files - wheels[package.name] == set()


def test_launch_files_and_manifests_are_shared_data(packages: list[Path], wheels: dict[str, set[str]]) -> None:
    for package in packages:
        shared = {"package.xml"} | {
            str(path.relative_to(package))
            for folder in ("launch", "config", "rviz")
            for path in (package / folder).glob("*.*")
        }
        prefix = next(name for name in wheels[package.name] if name.endswith("/package.xml"))
        base = prefix.removesuffix("package.xml")
        assert {base + name for name in shared} <= wheels[package.name]
