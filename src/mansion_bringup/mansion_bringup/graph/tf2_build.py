"""Build the Python package ``tf2_msgs``, which the wheels of rclpy lack, from the definitions beside this module.

The code generators of ROS 2 run in a temporary virtual environment. What they write is compiled against the headers
and libraries of the wheels, loaded once as a test, and moved into ``site-packages`` as one folder, so that it is there
whole or not at all. The folder holds the shared libraries too: the Python extension names them all, and they find each
other and those of the wheels by relative paths, so that nothing else has to know them.
"""

import fcntl
import importlib
import importlib.util
import json
import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import chain
from pathlib import Path, PurePath
from tempfile import TemporaryDirectory
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["build_tf2_msgs", "has_tf2", "missing_tools"]

_PACKAGE: Final = "tf2_msgs"
_DEFINITIONS: Final = Path(__file__).resolve().with_name(_PACKAGE)
_INTERFACES: Final = ("msg/TF2Error.msg", "msg/TFMessage.msg", "srv/FrameGraph.srv", "action/LookupTransform.action")
_REQUIREMENTS: Final = Path(__file__).resolve().parents[4] / "requirements"
_VERSION: Final = f"{sys.version_info.major}.{sys.version_info.minor}"

_DEPENDENCIES: Final = (
    "action_msgs",
    "builtin_interfaces",
    "geometry_msgs",
    "service_msgs",
    "std_msgs",
    "unique_identifier_msgs",
)
"""Packages whose types are part of the definitions."""

_TYPE_SUPPORTS: Final = ("rosidl_typesupport_fastrtps_c", "rosidl_typesupport_introspection_c")
_LIBRARIES: Final = ("rosidl_generator_c", *_TYPE_SUPPORTS, "rosidl_typesupport_c", "rosidl_generator_py")
"""The shared libraries, named by the generator of their sources, each after those that it needs."""

_GENERATORS: Final[dict[str, tuple[str, ...]]] = {
    "rosidl_generator_type_description": (),
    "rosidl_generator_c": (),
    "rosidl_typesupport_fastrtps_c": (),
    "rosidl_typesupport_introspection_c": (),
    "rosidl_typesupport_c": ("--typesupports", *_TYPE_SUPPORTS),
    "rosidl_generator_py": ("--typesupport-impls", "rosidl_typesupport_c"),
}
"""The generators in the order in which they run, with their own options."""

_RUNTIME: Final = (
    "rosidl_typesupport_c",
    "rosidl_typesupport_fastrtps_c",
    "rosidl_typesupport_fastrtps_cpp",
    "rosidl_typesupport_introspection_c",
    "rosidl_runtime_c",
    "rcutils",
    "rmw",
    "fastcdr",
)
"""Libraries of the wheels that generated code calls."""

_FOLDER_PREFIX: Final = ".tf2_msgs-build-"
_C_COMPILERS: Final = ("cc", "gcc", "clang")
_CPP_COMPILERS: Final = ("c++", "g++", "clang++")

_LOADING_TEST: Final = """
import ctypes, sys
sys.path.insert(0, sys.argv[1])
from rosidl_generator_py import import_type_support
import tf2_msgs.action, tf2_msgs.msg, tf2_msgs.srv
import_type_support("tf2_msgs")
for name in sys.argv[2:]:
    ctypes.CDLL(f"libtf2_msgs__{name}.so")
"""
"""Loads everything, the type supports by name alone, as the dispatching library does."""


@dataclass(frozen=True)
class _Places:
    """Where objects are during a build.

    Attributes
    ----------
    prefix : Path
        The environment that `tf2_msgs` is built for.
    folder : Path
        The temporary folder, on the file system of `prefix`.
    log : Path
        Commands and their output; it stays.
    """

    prefix: Path
    folder: Path
    log: Path

    @property
    def generators(self) -> Path:
        """The temporary virtual environment of the code generators."""
        return self.folder / "generators"

    @property
    def package(self) -> Path:
        """The finished package, before it is moved to its place."""
        return self.folder / "finished" / _PACKAGE

    def generated(self, generator: str) -> Path:
        """Return the folder that a generator writes to; its parent is a folder for includes."""
        return self.folder / generator / _PACKAGE


def has_tf2() -> bool:
    """Return whether the Python package tf2_msgs is installed, without importing it."""
    importlib.invalidate_caches()
    spec = importlib.util.find_spec(_PACKAGE)
    return spec is not None and spec.origin is not None


def missing_tools() -> list[str]:
    """Return what is missing of the tools that the build needs: compilers for C and C++ and the headers of Python."""
    header = Path(sysconfig.get_path("include"), "Python.h")
    present = {
        "a C compiler": bool(_on_path(_C_COMPILERS)),
        "a C++ compiler": bool(_on_path(_CPP_COMPILERS)),
        f"the headers of Python {_VERSION}": header.exists(),
    }
    return [tool for tool, is_present in present.items() if not is_present]


def build_tf2_msgs(report: Callable[[str], None]) -> None:
    """Build tf2_msgs into the running environment, unless it is there.

    Processes that start afterwards can import it. An interrupted build installs nothing.

    Parameters
    ----------
    report : callable
        Takes each line of progress.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where a ROS 2 is sourced, where the wheels of rclpy or tools are missing, or when a step fails.
    """
    _check_environment()
    prefix = Path(sys.prefix)
    try:
        with _one_build_at_a_time(prefix):
            if has_tf2():
                report("tf2_msgs is installed")
                return
            with _temporary_folder(prefix) as folder:
                _build(_Places(prefix, folder, prefix / "tf2_msgs-build.log"), report)
    except OSError as error:
        raise _unavailable(f"tf2_msgs cannot be built in {prefix}: {error}") from error


def _check_environment() -> None:
    """Raise unless tf2_msgs can be built here."""
    if os.environ.get("AMENT_PREFIX_PATH"):
        distribution = os.environ.get("ROS_DISTRO", "jazzy")
        raise _unavailable(
            f"a ROS 2 is sourced, which has its own package of tf2_msgs: sudo apt install ros-{distribution}-tf2-msgs"
        )
    wheels = ("lib/libgeometry_msgs__rosidl_generator_c.so", "include/geometry_msgs", "share/geometry_msgs")
    if not all(Path(sys.prefix, name).exists() for name in wheels):
        raise _unavailable(f"tf2_msgs is built for the wheels of rclpy, which are not installed in {sys.prefix}")
    missing = missing_tools()
    if missing:
        packages = {f"python{_VERSION}-dev" if "Python" in tool else "build-essential" for tool in missing}
        raise _unavailable(
            f"building tf2_msgs needs {' and '.join(missing)}: sudo apt install {' '.join(sorted(packages))}",
            missing=missing,
        )
    if not _lock_file().exists():
        raise _unavailable(f"building tf2_msgs needs requirements/{_lock_file().name} of a checkout of Mansion")


def _build(places: _Places, report: Callable[[str], None]) -> None:
    start = time.monotonic()
    places.log.unlink(missing_ok=True)
    report(f"installing the code generators for the time of the build, from requirements/{_lock_file().name}")
    _install_generators(places)
    report("generating the code of tf2_msgs")
    _generate(places)
    report("compiling it")
    _compile(places)
    _test_loading(places)
    places.package.rename(Path(sysconfig.get_path("platlib"), _PACKAGE))
    report(f"tf2_msgs is installed after {time.monotonic() - start:.0f} s")


def _install_generators(places: _Places) -> None:
    command = [sys.executable, "-I", "-m", "venv", str(places.generators)]
    _run(places, "making a virtual environment", command)
    pip = "-m pip install --require-hashes --only-binary=:all: --no-deps --no-compile --no-input --quiet"
    options = [*pip.split(), "--disable-pip-version-check", "--retries=2", "-r", str(_lock_file())]
    _run(places, "installing the code generators", [*_python(places), *options])


def _generate(places: _Places) -> None:
    """Write the sources: the definitions become IDL, then each generator reads that."""
    tuples = [f"{_DEFINITIONS}:{interface}" for interface in _INTERFACES]
    arguments = _write_json(places.folder / "adapter.json", {"non_idl_tuples": tuples})
    command = ["-m", "rosidl_adapter", "--package-name", _PACKAGE, "--arguments-file", arguments]
    output = (places.generated("idl"), places.folder / "idl.txt")
    command += ["--output-dir", str(output[0]), "--output-file", str(output[1])]
    _run(places, "translating the definitions", [*_python(places), *command])
    for generator, options in _GENERATORS.items():
        arguments = _write_json(places.folder / f"{generator}.json", _generator_arguments(places, generator))
        script = str(places.generators / "lib" / generator / generator)
        command = [*_python(places), script, "--generator-arguments-file", arguments, *options]
        _run(places, f"generating code with {generator}", command)
        _write_visibility_header(places, generator)


def _generator_arguments(places: _Places, generator: str) -> dict[str, str | list[str]]:
    """Return the arguments of a generator; each takes those that it knows."""
    interfaces = [PurePath(interface) for interface in _INTERFACES]
    descriptions = places.generated("rosidl_generator_type_description")
    share = places.prefix / "share"
    return {
        "package_name": _PACKAGE,
        "output_dir": str(places.generated(generator)),
        "template_dir": str(places.generators / "share" / generator / "resource"),
        "idl_tuples": [f"{places.generated('idl')}:{name.with_suffix('.idl')}" for name in interfaces],
        "type_description_tuples": [
            f"{name.with_suffix('.idl')}:{descriptions / name.with_suffix('.json')}" for name in interfaces
        ],
        "ros_interface_files": [str(_DEFINITIONS / name) for name in interfaces],
        "include_paths": [f"{name}:{share / name}" for name in _DEPENDENCIES],
        "target_dependencies": [],
    }


def _write_visibility_header(places: _Places, generator: str) -> None:
    """Fill in the template of a header that the generators leave to CMake, where there is one."""
    name = f"{generator}__visibility_control.h"
    template = places.generators / "share" / generator / "resource" / f"{name}.in"
    if template.exists():
        text = template.read_text(encoding="utf-8")
        text = text.replace("@PROJECT_NAME@", _PACKAGE)
        text = text.replace("@PROJECT_NAME_UPPER@", _PACKAGE.upper())
        (places.generated(generator) / "msg" / name).write_text(text, encoding="utf-8")


def _compile(places: _Places) -> None:
    """Compile the sources and link the libraries into the folder of the finished package."""
    python_sources = places.generated("rosidl_generator_py")
    shutil.copytree(python_sources, places.package, ignore=shutil.ignore_patterns("*.c"))
    (places.package / "__init__.py").touch()
    shutil.copy(_DEFINITIONS / "LICENSE", places.package)
    extension = next(python_sources.glob("*.c"))
    sources = {name: sorted(places.generated(name).glob("*/**/*.c*")) for name in _LIBRARIES}
    includes = _include_options(places)
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        every = [extension, *chain.from_iterable(sources.values())]
        for _ in pool.map(lambda source: _compile_source(places, source, includes), every):
            pass  # raises what the call raised
    for index, name in enumerate(_LIBRARIES):
        _link(places, f"lib{_PACKAGE}__{name}.so", sources[name], _LIBRARIES[:index])
    _link(places, f"{_PACKAGE}_s__rosidl_typesupport_c.so", [extension], _LIBRARIES)


def _include_options(places: _Places) -> list[str]:
    import numpy

    wheels = places.prefix / "include"
    folders = [
        *(places.generated(name).parent for name in _LIBRARIES),
        wheels,
        *(folder for folder in sorted(wheels.iterdir()) if (folder / folder.name).is_dir()),
        sysconfig.get_path("include"),
        sysconfig.get_path("platinclude"),
        numpy.get_include(),
    ]
    return [f"-I{folder}" for folder in folders]


def _compile_source(places: _Places, source: Path, includes: Sequence[str]) -> None:
    if source.suffix == ".c":
        compiler = [_on_path(_C_COMPILERS), "-std=gnu11"]
    else:
        compiler = [_on_path(_CPP_COMPILERS), "-std=gnu++17"]
    output = ["-o", str(source.with_suffix(".o"))]
    command = [*compiler, "-O2", "-DNDEBUG", "-fPIC", *includes, "-c", str(source), *output]
    _run(places, f"compiling {source.name}", command)


def _link(places: _Places, name: str, sources: Sequence[Path], own: Sequence[str]) -> None:
    """Link a shared library with all of `own`, so that loading it loads them, and with what it uses of the wheels."""
    place = Path(sysconfig.get_path("platlib"), _PACKAGE)
    libraries = os.path.relpath(places.prefix / "lib", place)
    of_wheels = [f"{package}__{library}" for package in _DEPENDENCIES for library in _LIBRARIES]
    command = [
        _on_path(_CPP_COMPILERS),
        "-shared",
        f"-Wl,-soname,{name}",
        f"-Wl,-rpath,$ORIGIN:$ORIGIN/{libraries}",
        *("-o", str(places.package / name)),
        *(str(source.with_suffix(".o")) for source in sources),
        *(f"-L{folder}" for folder in (places.package, places.prefix / "lib")),
        "-Wl,--no-as-needed",
        *(f"-l{_PACKAGE}__{library}" for library in own),
        "-Wl,--as-needed",
        *(f"-l{library}" for library in [*of_wheels, *_RUNTIME]),
    ]
    _run(places, f"linking {name}", command)


def _test_loading(places: _Places) -> None:
    command = [sys.executable, "-I", "-c", _LOADING_TEST, str(places.package.parent), *_LIBRARIES]
    _run(places, "loading what was built", command, LD_BIND_NOW="1")


def _run(places: _Places, step: str, command: Sequence[str], **environment: str) -> None:
    """Run a command, append it and its output to the log, and raise when it fails."""
    done = subprocess.run(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env={**os.environ, **environment},
        encoding="utf-8",
        errors="replace",
        check=False,
    )
    with places.log.open("a", encoding="utf-8") as log:
        log.write(f"$ {shlex.join(command)}\n{done.stdout}")
    if done.returncode != 0:
        lines = [line.strip() for line in done.stdout.splitlines() if line.strip()]
        errors = [line for line in lines if "error" in line.lower()] or lines
        said = " / ".join(errors[-3:]) or f"exit status {done.returncode}"
        raise _unavailable(f"tf2_msgs is not built, {step} failed: {said}; the full log is {places.log}", step=step)


@contextmanager
def _temporary_folder(prefix: Path) -> Iterator[Path]:
    """Make a folder beside the place of installation and remove it, with those that killed builds have left."""
    for left in prefix.glob(f"{_FOLDER_PREFIX}*"):
        shutil.rmtree(left, ignore_errors=True)
    with TemporaryDirectory(prefix=_FOLDER_PREFIX, dir=prefix, ignore_cleanup_errors=True) as folder:
        yield Path(folder)


@contextmanager
def _one_build_at_a_time(prefix: Path) -> Iterator[None]:
    folder = os.open(prefix, os.O_RDONLY)
    try:
        fcntl.flock(folder, fcntl.LOCK_EX)
        yield
    finally:
        os.close(folder)


def _python(places: _Places) -> list[str]:
    return [str(places.generators / "bin" / "python"), "-I"]


def _lock_file() -> Path:
    return _REQUIREMENTS / f"rosidl-{_VERSION}.txt"


def _on_path(programs: Sequence[str]) -> str:
    """Return the place of the first of these programs that is on the path, or an empty string."""
    return next(filter(None, map(shutil.which, programs)), "")


def _write_json(path: Path, content: dict[str, list[str]] | dict[str, str | list[str]]) -> str:
    path.write_text(json.dumps(content), encoding="utf-8")
    return str(path)


def _unavailable(message: str, **details: object) -> MansionError:
    return MansionError(ErrorCode.UNAVAILABLE, message, details=details)
