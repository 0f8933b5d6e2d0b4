"""Every package is what colcon, rosdep and `ros2 run` take it for."""

import importlib.util
import os
import re
import runpy
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import setuptools

from mansion_msgs_py import __version__

catkin_package = pytest.importorskip("catkin_pkg.package")

NAMES = [
    "mansion",
    "mansion_assets",
    "mansion_bringup",
    "mansion_editing",
    "mansion_export",
    "mansion_geometry",
    "mansion_knowledge",
    "mansion_language",
    "mansion_llm",
    "mansion_msgs_py",
    "mansion_planner",
    "mansion_scene",
    "mansion_skills",
    "mansion_tasks",
    "mansion_world",
]

# Keys of rosdep's python.yaml with a rule for Ubuntu 24.04: an unknown one stops `rosdep install`.
ROSDEP_KEYS = {
    "python3-matplotlib",
    "python3-networkx",
    "python3-numpy",
    "python3-pil",
    "python3-pytest",
    "python3-shapely",
    "python3-yaml",
}

ROS_PACKAGES = {
    "ament_index_python",
    "builtin_interfaces",
    "diagnostic_msgs",
    "geometry_msgs",
    "launch",
    "launch_ros",
    "nav_msgs",
    "rcl_interfaces",
    "rclpy",
    "rosgraph_msgs",
    "ros2launch",
    "rviz2",
    "sensor_msgs",
    "std_msgs",
    "std_srvs",
    "tf2_msgs",
    "visualization_msgs",
}

NODES = {
    "mansion_bringup": ["building_director"],
    "mansion_editing": ["scene_editor"],
    "mansion_planner": ["floor_solver", "program_planner"],
    "mansion_scene": ["object_placer"],
    "mansion_skills": ["skill_server"],
}


def setup_arguments(package: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """What the package's setup.py passes to setuptools."""
    passed: dict[str, Any] = {}
    monkeypatch.setattr(setuptools, "setup", lambda **arguments: passed.update(arguments))
    monkeypatch.chdir(package)
    runpy.run_path("setup.py")
    return passed


def console_scripts(arguments: dict[str, Any]) -> dict[str, str]:
    """Name -> ``module:function``."""
    lines = arguments.get("entry_points", {}).get("console_scripts", [])
    return dict(re.split(r"\s*=\s*", line, maxsplit=1) for line in lines)


def test_colcon_lists_each_package_as_ament_python(root: Path, tmp_path: Path) -> None:
    environment = {**os.environ, "COLCON_HOME": str(tmp_path)}
    listed = subprocess.run(
        [sys.executable, "-m", "colcon", "list", "--base-paths", str(root / "src")],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    rows = [line.split("\t") for line in listed.stdout.splitlines()]
    assert [(row[0], row[2]) for row in rows] == [(name, "(ros.ament_python)") for name in NAMES]
    assert listed.stderr == ""


def test_manifests_are_valid_without_a_warning(packages: list[Path]) -> None:
    assert [package.name for package in packages] == NAMES
    for package in packages:
        warnings: list[str] = []
        manifest = catkin_package.parse_package(str(package), warnings=warnings)
        manifest.validate(warnings=warnings)
        assert warnings == []
        assert manifest.package_format == 3
        assert manifest.name == package.name
        assert manifest.get_build_type() == "ament_python"
        assert manifest.licenses == ["Apache-2.0"]


def test_every_dependency_is_ours_a_ros_package_or_a_rosdep_key(packages: list[Path]) -> None:
    known = {*NAMES, *ROS_PACKAGES, *ROSDEP_KEYS}
    for package in packages:
        manifest = catkin_package.parse_package(str(package))
        named = {depend.name for depend in [*manifest.exec_depends, *manifest.test_depends]}
        assert named <= known, package.name


def test_one_version_everywhere(root: Path, packages: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    for package in packages:
        assert catkin_package.parse_package(str(package)).version == __version__, package.name
        assert setup_arguments(package, monkeypatch)["version"] == __version__, package.name
    assert f"\nversion: {__version__}\n" in (root / "CITATION.cff").read_text(encoding="utf-8")
    changelog = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    assert re.search(rf"(?m)^## {re.escape(__version__)}( |$)", changelog)


def test_descriptions_agree(packages: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    for package in packages:
        manifest = catkin_package.parse_package(str(package))
        assert setup_arguments(package, monkeypatch)["description"] == manifest.description


def test_each_node_is_an_executable_of_its_package(packages: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    for package in packages:
        scripts = console_scripts(setup_arguments(package, monkeypatch))
        command = scripts.pop("mansion", None)
        assert command == ("mansion_bringup.cli:main" if package.name == "mansion_bringup" else None)
        assert scripts == {node: f"{package.name}.nodes.{node}:main" for node in NODES.get(package.name, [])}


def test_each_executable_has_its_main(packages: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    for package in packages:
        for target in console_scripts(setup_arguments(package, monkeypatch)).values():
            module, function = target.split(":")
            found = importlib.util.find_spec(module)
            assert found is not None and found.origin is not None, module
            source = Path(found.origin).read_text(encoding="utf-8")
            assert re.search(rf"^def {function}\(|^from .* import .*\b{function}\b", source, re.M)


def test_colcon_installs_executables_where_ros2_run_looks(packages: list[Path]) -> None:
    for package in packages:
        settings = (package / "setup.cfg").read_text(encoding="utf-8")
        assert f"script_dir = $base/lib/{package.name}" in settings
        assert f"install_scripts = $base/lib/{package.name}" in settings
        assert f"testpaths = ../../tests/{package.name.removeprefix('mansion_')}\n" in settings


def test_the_package_index_and_the_manifest_are_installed(
    packages: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    for package in packages:
        files = dict(setup_arguments(package, monkeypatch)["data_files"])
        assert files["share/ament_index/resource_index/packages"] == [f"resource/{package.name}"]
        assert files[f"share/{package.name}"] == ["package.xml"]
        assert (package / "resource" / package.name).is_file()


def test_no_fixture_overrides_another_in_the_tests_that_colcon_runs(root: Path, packages: list[Path]) -> None:
    """From a package's folder pytest gives every conftest.py below the whole of ``../../tests/NAME``."""
    for package in packages:
        tests = root / "tests" / package.name.removeprefix("mansion_")
        names = [
            name
            for file in sorted(tests.rglob("conftest.py"))
            for name in re.findall(r"^@pytest\.fixture.*\ndef (\w+)", file.read_text(encoding="utf-8"), re.MULTILINE)
        ]
        assert len(names) == len(set(names)), package.name
