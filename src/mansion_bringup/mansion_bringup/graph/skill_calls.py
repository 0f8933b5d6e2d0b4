"""A skill of a session over the services of a skill server."""

from collections.abc import Mapping
from typing import Any

from mansion_bringup.client import MansionClient
from mansion_msgs_py.codec import convert, decode, encode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.interfaces import TRIGGER
from mansion_msgs_py.world import SkillResult
from mansion_skills.skills.declaration import Skill

__all__ = ["call_skill"]


def call_skill(client: MansionClient, skill: Skill, session: str, arguments: Mapping[str, Any]) -> Any:
    """Run a skill of a session and return its result, refused or not, or the answer of a query.

    Parameters
    ----------
    session : str
        The default one when empty.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for arguments that the skill does not have, or what kept it from being asked at all.
    """
    fields = {**arguments, "session": session} if session else dict(arguments)
    try:
        payload = convert(skill.arguments, fields)
    except MansionError as error:
        raise error.with_message(f"{skill.name}: {error.info.message}") from None
    name = skill.interface.name
    try:
        if skill.interface.type == TRIGGER:
            return client.call(f"{session}/{name}" if session else name, reply=skill.reply)
        return client.call(name, payload, reply=skill.reply)
    except MansionError as error:
        if "skill" not in error.info.details:
            raise
        return decode(SkillResult, encode(error.info.details))
