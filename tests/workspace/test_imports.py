"""Who imports rclpy, and that what is imported is declared and locked; import-linter keeps the order of packages."""

import ast
import re
import sys
from functools import cache
from pathlib import Path

import pytest

# Distribution -> module, where the two differ.
MODULES = {
    "pillow": "PIL",
    "pyyaml": "yaml",
    "usd_core": "pxr",
    "dask": "dask",
    "mcap_ros2_support": "mcap_ros2",
    "rerun_sdk": "rerun",
}

ROS_MODULES = {
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
    "sensor_msgs",
    "std_msgs",
    "std_srvs",
    "tf2_msgs",
    "visualization_msgs",
}


@cache
def imports(source: Path) -> frozenset[str]:
    """Top-level names of the modules that a file imports, anywhere in it."""
    names: list[str] = []
    for node in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            names.append(node.module)
    return frozenset(name.partition(".")[0] for name in names)


def sources(package: Path) -> list[Path]:
    """The package's modules."""
    return sorted((package / package.name).rglob("*.py"))


def modules_of(requirements: str) -> set[str]:
    """Modules of the distributions that are named in a text of requirements."""
    names = re.findall(r"^\s*\"?([A-Za-z][\w.-]*)", requirements, re.MULTILINE)
    normal = [name.lower().replace("-", "_") for name in names]
    return {MODULES.get(name, name) for name in normal}


def declared(package: Path) -> set[str]:
    """Modules that the package's setup.py declares, extras included."""
    setup = ast.parse((package / "setup.py").read_text(encoding="utf-8"))
    call = next(
        node
        for node in ast.walk(setup)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "setup"
    )
    lines: list[str] = []
    for keyword in call.keywords:
        if keyword.arg == "install_requires":
            lines += ast.literal_eval(keyword.value)
        elif keyword.arg == "extras_require":
            lines += [line for extra in ast.literal_eval(keyword.value).values() for line in extra]
    return modules_of("\n".join(lines))


def test_only_nodes_and_bringup_import_ros(packages: list[Path]) -> None:
    for package in packages:
        if package.name == "mansion_bringup":
            continue
        for source in sources(package):
            if "nodes" not in source.relative_to(package).parts:
                assert not ROS_MODULES & imports(source), source


def test_what_is_imported_is_declared(packages: list[Path]) -> None:
    undeclared = {}
    for package in packages:
        known = declared(package) | ROS_MODULES | {package.name} | set(sys.stdlib_module_names)
        for source in sources(package):
            if missing := imports(source) - known:
                undeclared[str(source.relative_to(package))] = missing
    assert undeclared == {}


def test_what_is_declared_is_locked(root: Path, packages: list[Path]) -> None:
    locked = set()
    for name in (
        "core",
        "rclpy",
        "record",
        "rerun",
        "sim",
        "llm",
        "thor",
        "embeddings",
        "usd",
        "dxf",
        "ifc",
        "cluster",
        "convex",
        "test",
        "vectors",
        "world",
    ):
        locked |= modules_of((root / f"requirements/{name}-3.12.txt").read_text(encoding="utf-8"))
    for package in packages:
        ours = {name for name in declared(package) if name.startswith("mansion_")}
        assert declared(package) - ours <= locked, package.name


def test_manifests_name_the_ros_packages_that_are_imported(packages: list[Path]) -> None:
    catkin_package = pytest.importorskip("catkin_pkg.package")
    unnamed = {}
    for package in packages:
        manifest = catkin_package.parse_package(str(package))
        named = {depend.name for depend in manifest.exec_depends} | {package.name}
        for source in sources(package):
            needed = {name for name in imports(source) if name in ROS_MODULES or name.startswith("mansion_")}
            if missing := needed - named:
                unnamed[str(source.relative_to(package))] = missing
    assert unnamed == {}


HELD = "importing"
"""The lock under which a function imports."""

ONE_THREAD = {"cli", "nodes"}
"""Folders whose functions the main thread calls first: of a command, and of a node that is being made."""


def unheld_imports(source: Path) -> list[str]:
    """Lines at which a function imports modules of Mansion's without holding the lock.

    A module's ``__getattr__`` may run while another module is imported, where nothing may wait for the lock.
    """
    found = []

    def look(node: ast.AST, *, inside: bool, held: bool) -> None:
        if isinstance(node, ast.FunctionDef):
            if node.name == "__getattr__":
                return
            inside = True
        if isinstance(node, ast.With):
            held = held or any(
                isinstance(item.context_expr, ast.Name) and item.context_expr.id == HELD for item in node.items
            )
        modules = [node.module or ""] if isinstance(node, ast.ImportFrom) else []
        if isinstance(node, ast.Import):
            modules = [alias.name for alias in node.names]
        if inside and not held and any(name.startswith("mansion") for name in modules):
            found.append(f"{source.name}:{node.lineno}")
        for child in ast.iter_child_nodes(node):
            look(child, inside=inside, held=held)

    look(ast.parse(source.read_text(encoding="utf-8")), inside=False, held=False)
    return found


def test_functions_that_several_threads_may_call_first_import_under_the_lock(packages: list[Path]) -> None:
    modules = [module for package in packages for module in sources(package)]
    looked_at = [m for m in modules if not ONE_THREAD & set(m.parts) and m.name != "__main__.py"]
    assert len(looked_at) > 500
    assert [line for module in looked_at for line in unheld_imports(module)] == []
