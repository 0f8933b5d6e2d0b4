"""The next image of a robot's camera in a graph."""

import threading

import numpy as np
import numpy.typing as npt
from sensor_msgs.msg import Image

from mansion_bringup.client import MansionClient
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import topic

__all__ = ["CameraImages"]


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
