"""The files for containers parse, and what they name is in the checkout and on the command line."""

import json
import re
import shlex
import subprocess
from pathlib import Path
from typing import Any

import pytest
import typer.main
import yaml

from mansion_bringup.cli.app import app
from mansion_bringup.extras import EXTRAS

DOCKERFILES = ("docker/Dockerfile", "docker/ros.Dockerfile")
INSTRUCTIONS = {
    "ARG", "CMD", "COPY", "ENTRYPOINT", "ENV", "EXPOSE", "FROM", "HEALTHCHECK", "LABEL", "RUN", "SHELL", "USER",
    "VOLUME", "WORKDIR",
}  # fmt: skip


def instructions(file: Path) -> list[tuple[str, str]]:
    """Return the instructions of a Dockerfile with their arguments, continued lines joined."""
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if line.strip() and line[0] != "#"]
    joined = re.sub(r"\\\n\s*", "", "\n".join(lines)).splitlines()
    return [(line.split(" ", 1)[0], line.split(" ", 1)[1]) for line in joined]


@pytest.mark.parametrize("name", DOCKERFILES)
def test_a_dockerfile_has_known_instructions_and_ends_as_a_plain_user(root: Path, name: str) -> None:
    found = instructions(root / name)
    assert found[0][0] == "FROM"
    assert {instruction for instruction, _ in found} <= INSTRUCTIONS
    assert [argument for instruction, argument in found if instruction == "USER"][-1] == "mansion"
    for instruction, argument in found:
        if instruction in ("ENTRYPOINT", "CMD", "SHELL"):
            assert all(isinstance(word, str) for word in json.loads(argument))


@pytest.mark.parametrize("name", DOCKERFILES)
def test_the_user_of_an_image_has_the_id_that_mounted_folders_are_owned_by(root: Path, name: str) -> None:
    added = [argument for instruction, argument in instructions(root / name) if "useradd" in argument]
    assert len(added) == 1 and "--uid 1000 mansion" in added[0]
    assert "user id 1000" in (root / "docs" / "install.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", DOCKERFILES)
def test_the_shell_can_read_what_a_dockerfile_runs(root: Path, name: str) -> None:
    for instruction, argument in instructions(root / name):
        if instruction == "RUN":
            checked = subprocess.run(["bash", "-n", "-c", argument], capture_output=True, text=True, check=False)
            assert checked.returncode == 0, checked.stderr


@pytest.mark.parametrize("name", DOCKERFILES)
def test_files_and_extras_that_a_dockerfile_names_are_there(root: Path, name: str) -> None:
    for instruction, argument in instructions(root / name):
        if instruction == "COPY":
            sources = [word for word in shlex.split(argument)[:-1] if not word.startswith("--")]
            assert [source for source in sources if not (root / source).exists()] == []
        for path in re.findall(r"(?:src/mansion|/mansion)/(requirements/\S+|mansion)\b", argument):
            assert (root / path).is_file()
        for extra in re.findall(r"mansion_bringup\.extras (\w+)", argument):
            assert extra in EXTRAS


def test_the_entry_point_is_a_shell_script_that_can_be_run(root: Path) -> None:
    script = root / "docker" / "ros_entrypoint.sh"
    assert script.stat().st_mode & 0o111
    assert subprocess.run(["bash", "-n", str(script)], check=False).returncode == 0


def test_the_services_of_compose_name_files_and_commands_that_exist(root: Path) -> None:
    services: dict[str, Any] = yaml.safe_load((root / "compose.yaml").read_text(encoding="utf-8"))["services"]
    commands = typer.main.get_command(app).commands  # type: ignore[attr-defined]
    assert set(services) == {"graph", "client"}
    assert (root / services["graph"]["build"]["dockerfile"]).is_file()
    for service in services.values():
        assert service["command"][0] in commands
    assert services["client"]["network_mode"] == services["client"]["ipc"] == "service:graph"


def test_the_development_container_installs_extras_that_exist(root: Path) -> None:
    read = json.loads((root / ".devcontainer" / "devcontainer.json").read_text(encoding="utf-8"))
    named = read["postCreateCommand"].split("mansion_bringup.extras ")[1].split()
    assert named and set(named) <= set(EXTRAS)


def test_the_image_leaves_out_what_a_checkout_leaves_behind(root: Path) -> None:
    ignored = (root / ".dockerignore").read_text(encoding="utf-8").split()
    assert {".git", ".venv*", "out"} <= set(ignored)
