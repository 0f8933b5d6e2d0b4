"""``mansion skill``: run a skill through the running graph, or in this process."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from mansion_bringup.cli.console import complaints, print_json
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import DEFAULT_NAMESPACE
from mansion_msgs_py.wording import choices
from mansion_msgs_py.world import SkillResult, SkillStatus

if TYPE_CHECKING:
    from mansion_skills.skills.declaration import Skill

__all__ = ["register"]


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("skill", no_args_is_help=True)(skill)


def skill(
    name: Annotated[str, typer.Argument(help="CallElevator or call_elevator; `list` lists them.")],
    arguments: Annotated[str, typer.Argument(help="JSON object.")] = "{}",
    building: Annotated[
        Path | None, typer.Option("--building", "-b", help="Run in this process, on this building folder.")
    ] = None,
    session: Annotated[str, typer.Option("--session", "-s", help="Which robot.")] = "",
    reset: Annotated[bool, typer.Option(help="With --building: start over.")] = False,
    namespace: Annotated[str, typer.Option("--namespace", "-n")] = DEFAULT_NAMESPACE,
) -> None:
    """Run one skill and print its result as JSON; exit status 1 when it does not succeed.

    Examples:

      mansion skill GoToLandmark '{"landmark": "elevator"}'

      mansion skill CallElevator --building out/office

      mansion skill list
    """
    from mansion_skills.skills.registry import SKILLS, skill_named

    if name == "list":
        print_json({key: entry.name for key, entry in SKILLS.items()})
        return
    found = skill_named(name)
    if found is None:
        known = choices(name, (entry.name for entry in SKILLS.values()), "skills")
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no skill {name!r}; {known}; `mansion skill list` lists all")
    fields: dict[str, Any] = decode(dict[str, Any], arguments)
    if session:
        fields["session"] = session
    if building is not None:
        _finish(_in_process(building, found.name, fields, reset=reset))
    else:
        _finish(_through_graph(namespace, found, fields))


def _in_process(building: Path, name: str, fields: dict[str, Any], *, reset: bool) -> Any:
    from mansion_skills import Robot

    session, arguments = _parted(fields)
    return Robot(building, session, reset=reset).skill(name, **arguments)


def _through_graph(namespace: str, found: "Skill", fields: dict[str, Any]) -> Any:
    from mansion_bringup.client import MansionClient
    from mansion_bringup.graph.robot_client import call_skill

    session, arguments = _parted(fields)
    with MansionClient(namespace="/" + namespace.strip("/")) as client:
        return call_skill(client, found, session, arguments)


def _parted(fields: dict[str, Any]) -> tuple[str, dict[str, Any]]:
    """Return the name of the session, empty where none is given, and the other fields."""
    return fields.get("session", ""), {name: value for name, value in fields.items() if name != "session"}


def _finish(result: Any) -> None:
    """Print a result; a refusal is said once more on standard error and ends with status 1."""
    print_json(result)
    if isinstance(result, SkillResult) and result.status is not SkillStatus.SUCCESS:
        wish = f"; to succeed: {result.satisfied_by}" if result.satisfied_by else ""
        text = f"{result.skill}: {result.status.value}: {result.message}{wish}"
        complaints.print(text, markup=False, highlight=False)
        raise typer.Exit(1)
