"""The checkout under test, and miniature ones: the real launcher, one tiny package, a lock of one tiny wheel."""

import base64
import hashlib
import json
import os
import shutil
import subprocess
import sys
import zipfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
VERSION = f"{sys.version_info.major}.{sys.version_info.minor}"

MAIN = """\
import json, os, sys
import brick
try:
    import rclpy
    ros = rclpy.__file__
except ImportError:
    ros = None
print(json.dumps({"arguments": sys.argv[1:], "path": sys.path, "prefix": sys.prefix,
                  "folder": os.getcwd(), "brick": brick.__file__, "rclpy": ros}))
sys.exit(3 if "fail" in sys.argv else 0)
"""


@dataclass(frozen=True)
class Miniature:
    """A miniature checkout at `folder`, run with an environment of its own."""

    folder: Path
    environment: dict[str, str]

    @property
    def venv(self) -> Path:
        """The environment that the launcher makes by default."""
        return self.folder / ".venv"

    def command(self, *arguments: str) -> list[str]:
        """The launcher's command line."""
        return [str(self.folder / "mansion"), *arguments]

    def start(self, *arguments: str, **environment: str) -> subprocess.Popen[str]:
        """Start the launcher in a process group of its own."""
        return subprocess.Popen(
            self.command(*arguments),
            env={**self.environment, **environment},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )

    def run(self, *arguments: str, cwd: Path | None = None, **environment: str) -> subprocess.CompletedProcess[str]:
        """Run the launcher to its end."""
        return subprocess.run(
            self.command(*arguments),
            cwd=cwd or self.folder,
            env={**self.environment, **environment},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
            timeout=120,
        )

    def report(self, *arguments: str, cwd: Path | None = None, **environment: str) -> Any:
        """Run the launcher, expect success, and return what its command saw."""
        done = self.run(*arguments, cwd=cwd, **environment)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    def write_lock(
        self, name: str = "core", *, wheel: str = "brick", digest: str | None = None, note: str = ""
    ) -> None:
        """Write a lock of a tiny wheel, with another hash or another comment than the right ones."""
        file = self.folder / "wheels" / f"{wheel}-1.0-py3-none-any.whl"
        right = hashlib.sha256(file.read_bytes()).hexdigest()
        (self.folder / "requirements" / f"{name}-{VERSION}.txt").write_text(
            f'# {note}\n--no-index\n--find-links "{file.parent}"\n{wheel}==1.0 --hash=sha256:{digest or right}\n',
            encoding="utf-8",
        )

    def with_quick_python(self, template: Path) -> "Miniature":
        """Return this checkout with a Python whose ``-m venv`` copies an environment that a launcher made."""
        python = self.folder / "quick-python"
        python.write_text(
            f"""#!/bin/sh
case $1 in
-I) echo "{VERSION} $0" ;;
-m) for venv; do :; done
    cp -al "{template}/." "$venv"
    rm -rf "$venv"/.mansion-stamp "$venv"/lib/python*/site-packages/brick* ;;
*) exit 1 ;;
esac
""",
            encoding="utf-8",
        )
        python.chmod(0o755)
        return replace(self, environment={**self.environment, "MANSION_PYTHON": str(python)})


def make_miniature(folder: Path) -> Miniature:
    """Make a miniature checkout in `folder`."""
    (folder / "requirements").mkdir(parents=True)
    shutil.copy2(ROOT / "mansion", folder)
    shutil.copy2(ROOT / "requirements" / "setup.sh", folder / "requirements")
    package = folder / "src" / "mansion_bringup" / "mansion_bringup"
    package.mkdir(parents=True)
    (package.parent / "setup.py").write_text("", encoding="utf-8")
    (package / "__init__.py").write_text("", encoding="utf-8")
    (package / "__main__.py").write_text(MAIN, encoding="utf-8")
    for file in (ROOT / "requirements").glob("ros_wheels*.py"):
        shutil.copy2(file, folder / "requirements")
    for name in ("brick", "rclpy"):
        _make_wheel(folder / "wheels", name)
    kept = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("PIP_", "ROS_", "AMENT_", "MANSION_", "COV", "PYTHON"))
    }
    base = getattr(sys, "_base_executable", sys.executable)
    miniature = Miniature(folder, {**kept, "MANSION_PYTHON": base, "PIP_CONFIG_FILE": os.devnull})
    miniature.write_lock()
    miniature.write_lock("rclpy", wheel="rclpy")
    return miniature


def _make_wheel(folder: Path, name: str) -> None:
    folder.mkdir(exist_ok=True)
    info = f"{name}-1.0.dist-info"
    files = {
        f"{name}.py": "",
        f"{info}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n",
        f"{info}/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    rows = []
    for path, text in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(text.encode()).digest()).rstrip(b"=")
        rows.append(f"{path},sha256={digest.decode()},{len(text)}")
    files[f"{info}/RECORD"] = "\n".join([*rows, f"{info}/RECORD,,"]) + "\n"
    with zipfile.ZipFile(folder / f"{name}-1.0-py3-none-any.whl", "w") as wheel:
        for path, text in files.items():
            wheel.writestr(path, text)


@pytest.fixture(scope="session")
def root() -> Path:
    """The checkout."""
    return ROOT


@pytest.fixture(scope="session")
def packages() -> list[Path]:
    """The folders of the ament_python packages."""
    return sorted(path.parent for path in ROOT.glob("src/*/package.xml"))


@pytest.fixture(scope="module")
def first_use(tmp_path_factory: pytest.TempPathFactory) -> tuple[Miniature, subprocess.CompletedProcess[str]]:
    """A miniature whose launcher has run once, and what came of that."""
    checkout = make_miniature(tmp_path_factory.mktemp("ready") / "a checkout")
    done = checkout.run("first")
    assert done.returncode == 0, done.stderr
    return checkout, done


@pytest.fixture
def ready(first_use: tuple[Miniature, subprocess.CompletedProcess[str]]) -> Miniature:
    """A miniature whose launcher has run."""
    return first_use[0]


@pytest.fixture
def fresh(tmp_path: Path) -> Miniature:
    """A miniature whose launcher has never run."""
    return make_miniature(tmp_path / "checkout")


@pytest.fixture
def quick(ready: Miniature, fresh: Miniature) -> Miniature:
    """A miniature whose launcher has never run, and will copy an environment instead of making one."""
    return fresh.with_quick_python(ready.venv)
