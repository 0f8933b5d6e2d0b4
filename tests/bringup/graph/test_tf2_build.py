"""tf2_msgs is built from the definitions of the package, whole or not at all, and carries transforms."""

import hashlib
import json
import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

from mansion_bringup.graph import tf2_build
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.tf2_build import build_tf2_msgs, has_tf2, missing_tools
from mansion_msgs_py.errors import ErrorCode, MansionError

HASH = "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"
"""What ROS 2 Jazzy says of tf2_msgs/msg/TFMessage."""

DEFINITIONS = Path(tf2_build.__file__).with_name("tf2_msgs")

REFERENCED = {
    "builtin_interfaces/msg/Time": "int32 sec\nuint32 nanosec",
    "geometry_msgs/msg/Quaternion": "float64 x\nfloat64 y\nfloat64 z\nfloat64 w",
    "geometry_msgs/msg/Transform": "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation",
    "geometry_msgs/msg/TransformStamped": (
        "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform"
    ),
    "geometry_msgs/msg/Vector3": "float64 x\nfloat64 y\nfloat64 z",
    "std_msgs/msg/Header": "builtin_interfaces/Time stamp\nstring frame_id",
}
"""The messages that a TFMessage is made of."""

NESTED, NESTED_SEQUENCE = 1, 145
TYPE_IDS = {"int32": 6, "uint32": 7, "float64": 11, "string": 17}
"""Of type_description_interfaces/msg/FieldType."""


def described(name: str, definition: str) -> dict[str, object]:
    """Return an IndividualTypeDescription of a message without its default values, as its hash is taken."""
    fields = []
    for line in definition.splitlines():
        kind, field = line.split()
        package, _, message = kind.removesuffix("[]").partition("/")
        type_id = TYPE_IDS.get(kind) or (NESTED_SEQUENCE if kind.endswith("[]") else NESTED)
        nested = f"{package}/msg/{message}" if message else ""
        sort = {"type_id": type_id, "capacity": 0, "string_capacity": 0, "nested_type_name": nested}
        fields.append({"name": field, "type": sort})
    return {"type_name": name, "fields": fields}


def test_a_transform_message_has_the_type_hash_of_jazzy() -> None:
    definition = (DEFINITIONS / "msg" / "TFMessage.msg").read_text(encoding="utf-8")
    description = {
        "type_description": described("tf2_msgs/msg/TFMessage", definition),
        "referenced_type_descriptions": [described(*item) for item in sorted(REFERENCED.items())],
    }
    digest = hashlib.sha256(json.dumps(description).encode()).hexdigest()
    assert f"RIHS01_{digest}" == HASH


def test_colcon_finds_no_package_in_the_definitions() -> None:
    files = {str(path.relative_to(DEFINITIONS)) for path in DEFINITIONS.rglob("*") if path.is_file()}
    assert files == {
        "LICENSE",
        "README.md",
        "action/LookupTransform.action",
        "msg/TF2Error.msg",
        "msg/TFMessage.msg",
        "srv/FrameGraph.srv",
    }


@pytest.fixture
def environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the prefix of an environment that has the wheels of rclpy, as far as their presence is looked at."""
    for folder in ("include/geometry_msgs", "share/geometry_msgs", "lib/site-packages"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "lib" / "libgeometry_msgs__rosidl_generator_c.so").touch()
    places = {**sysconfig.get_paths(), "platlib": str(tmp_path / "lib" / "site-packages")}
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    monkeypatch.setattr(sysconfig, "get_path", places.__getitem__)
    monkeypatch.setattr(tf2_build, "has_tf2", lambda: False)
    monkeypatch.delenv("AMENT_PREFIX_PATH", raising=False)
    return tmp_path


def refusal() -> str:
    """Return what building says when it refuses."""
    with pytest.raises(MansionError) as caught:
        build_tf2_msgs(print)
    assert caught.value.code == ErrorCode.UNAVAILABLE
    assert "\n" not in caught.value.info.message
    return caught.value.info.message


def test_a_folder_of_that_name_is_not_the_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    (tmp_path / "tf2_msgs").mkdir()
    assert not has_tf2()
    (tmp_path / "tf2_msgs" / "__init__.py").touch()
    assert has_tf2()


def test_missing_tools_are_named_with_the_packages_that_have_them(
    environment: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    monkeypatch.setenv("PATH", str(environment))
    monkeypatch.setattr(sysconfig, "get_path", lambda name: str(environment / name))
    assert missing_tools() == ["a C compiler", "a C++ compiler", f"the headers of Python {version}"]
    assert refusal() == (
        f"building tf2_msgs needs a C compiler and a C++ compiler and the headers of Python {version}: "
        f"sudo apt install build-essential python{version}-dev"
    )


def test_beside_a_sourced_ros_its_own_package_is_named(environment: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("AMENT_PREFIX_PATH", "/opt/ros/kilted")
    monkeypatch.setenv("ROS_DISTRO", "kilted")
    assert refusal().endswith("sudo apt install ros-kilted-tf2-msgs")


def test_without_the_wheels_of_rclpy_nothing_is_built(environment: Path) -> None:
    shutil.rmtree(environment / "include")
    assert "the wheels of rclpy, which are not installed" in refusal()


needs_tools = pytest.mark.skipif(bool(missing_tools()), reason=f"missing: {', '.join(missing_tools())}")


@needs_tools
def test_a_failing_step_is_quoted_and_leaves_nothing_but_its_log(
    environment: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = set(environment.rglob("*"))
    fails = [sys.executable, "-c", "import sys; print('Reading'); sys.exit('error: no such type')"]
    monkeypatch.setattr(tf2_build, "_install_generators", lambda places: None)
    monkeypatch.setattr(tf2_build, "_python", lambda places: fails)
    log = environment / "tf2_msgs-build.log"
    assert refusal() == (
        f"tf2_msgs is not built, translating the definitions failed: error: no such type; the full log is {log}"
    )
    assert set(environment.rglob("*")) - before == {log}
    assert "Reading\n" in log.read_text(encoding="utf-8")


@needs_tools
def test_an_interrupted_build_leaves_nothing(environment: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(places: tf2_build._Places) -> None:
        places.package.mkdir(parents=True)
        raise KeyboardInterrupt

    before = set(environment.rglob("*"))
    for name in ("_install_generators", "_generate", "_compile"):
        monkeypatch.setattr(tf2_build, name, lambda places: None)
    monkeypatch.setattr(tf2_build, "_test_loading", interrupt)
    with pytest.raises(KeyboardInterrupt):
        build_tf2_msgs(print)
    assert set(environment.rglob("*")) == before


BUILD = """
from mansion_bringup.graph.tf2_build import build_tf2_msgs, has_tf2
assert not has_tf2()
build_tf2_msgs(print)
assert has_tf2()
build_tf2_msgs(print)
"""

TALK = """
import time
import rclpy
from geometry_msgs.msg import TransformStamped
from tf2_msgs.action import LookupTransform
from tf2_msgs.msg import TF2Error, TFMessage
from tf2_msgs.srv import FrameGraph

sent = TransformStamped(child_frame_id="base_link")
sent.header.frame_id = "map"
sent.transform.translation.x = 1.5
heard = []
rclpy.init()
talker, listener = rclpy.create_node("talker"), rclpy.create_node("listener")
listener.create_subscription(TFMessage, "/tf", heard.append, 10)
publisher = talker.create_publisher(TFMessage, "/tf", 10)
talker.create_service(FrameGraph, "/frames", lambda request, response: response)
end = time.monotonic() + 30
while not heard and time.monotonic() < end:
    publisher.publish(TFMessage(transforms=[sent]))
    rclpy.spin_once(listener, timeout_sec=0.1)
assert heard and heard[0].transforms == [sent], heard
print(listener.get_publishers_info_by_topic("/tf")[0].topic_type_hash)
assert TF2Error.TRANSFORM_ERROR == 6
assert LookupTransform.Goal().advanced is False
rclpy.shutdown()
"""


@pytest.mark.graph
@needs_tools
def test_what_is_built_carries_transforms_between_nodes(tmp_path: Path) -> None:
    needs_wheels_and_registry(tmp_path)
    prefix = tmp_path / "environment"
    ignored = shutil.ignore_patterns("__pycache__", "tf2_msgs", ".tf2_msgs-build-*", "*.log")
    shutil.copytree(sys.prefix, prefix, symlinks=True, ignore=ignored, copy_function=link_or_copy)
    assert "tf2_msgs is installed after" in run(prefix, BUILD)
    assert HASH in run(prefix, TALK)
    assert [path.name for path in prefix.glob(".tf2*")] == []


def needs_wheels_and_registry(folder: Path) -> None:
    """Skip the test where the build of a copy of this environment is refused or cannot reach a package registry."""
    if os.environ.get("AMENT_PREFIX_PATH"):
        pytest.skip("a ROS 2 is sourced")
    if sys.prefix == sys.base_prefix:
        pytest.skip("this Python is in no virtual environment that could be copied")
    if not Path(sys.prefix, "include", "geometry_msgs").exists():
        pytest.skip("the wheels of rclpy are not installed")
    command = ["-m", "pip", "download", "--no-deps", "--retries=0", "-d", str(folder), "ros-rpyutils==0.4.2"]
    done = subprocess.run([sys.executable, *command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        pytest.skip("pip reaches no package registry")


def link_or_copy(source: str, target: str) -> None:
    """Copy a file, by a hard link where both are on one file system."""
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target)


def run(prefix: Path, code: str) -> str:
    """Run code in an environment and a ROS domain of its own; return what it prints."""
    packages = [Path(sys.modules[name].__path__[0]).parent for name in ("mansion_bringup", "mansion_msgs_py")]
    variables = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(map(str, packages)),
        "ROS_DOMAIN_ID": str(free_domain()),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
    }
    command = [prefix / "bin" / "python", "-c", code]
    done = subprocess.run(command, env=variables, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
