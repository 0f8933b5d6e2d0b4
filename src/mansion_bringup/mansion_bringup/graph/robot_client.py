"""A robot of a running graph as its clients reach it: its skills by services, its camera by a topic."""

import threading
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt
from sensor_msgs.msg import Image

from mansion_bringup.client import MansionClient
from mansion_msgs_py.codec import convert, decode, encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import TRIGGER, topic
from mansion_msgs_py.world import SkillResult
from mansion_skills.skills.declaration import Skill

__all__ = ["CameraImages", "call_skill"]


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


class CameraImages:
    """The camera topic of a session, listened to from the first picture on.

    Parameters
    ----------
    client : MansionClient
    session : str
        The default one when empty.
    """

    def __init__(self, client: MansionClient, session: str) -> None:
        entry = topic("camera/image")
        self._timeout = client.timeout
        self._name = f"{session}/{entry.name}" if session else entry.name
        self._arrived = threading.Event()
        self._last: Image | None = None
        self._stop = client.subscribe(Image, self._name, self._take, entry.qos)

    def _take(self, image: Image) -> None:
        self._last = image
        self._arrived.set()

    def next(self) -> npt.NDArray[np.uint8]:
        """Return the next image that arrives, ``(height, width, 3)``.

        Raises
        ------
        MansionError
            ``TIMEOUT`` when none does.
        """
        self._arrived.clear()
        if not self._arrived.wait(self._timeout) or self._last is None:
            raise MansionError(ErrorCode.TIMEOUT, f"{self._name}: no image in {self._timeout:g} s")
        image = self._last
        return np.frombuffer(bytes(image.data), np.uint8).reshape(image.height, image.width, 3)
