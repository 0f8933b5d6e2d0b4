"""The furniture of a floor's rooms by a model; what stays faulty comes from the room type's own list."""

from collections.abc import Sequence

import msgspec

from mansion_assets.catalogue import Catalogue, load_catalogue
from mansion_assets.catalogue.records import Item
from mansion_llm import LlmClient
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.stages import FurnishRequest
from mansion_msgs_py.usage import LlmUsage
from mansion_scene.llm.answers import ObjectsAnswer
from mansion_scene.llm.objects import object_faults, object_items, objects_prompt

__all__ = ["ModelChooser"]


class ModelChooser:
    """An `ItemChooser` that asks a language model.

    Parameters
    ----------
    client : LlmClient
    catalogue : Catalogue
    request : FurnishRequest
        Names building type, style and brief.

    Attributes
    ----------
    sources : dict of str to str
        ``objects/ROOM`` to ``llm``, ``llm without ...`` or ``rules: REASON``.
    """

    def __init__(self, client: LlmClient, catalogue: Catalogue, request: FurnishRequest) -> None:
        self._client, self._catalogue, self._request = client, catalogue, request
        self.sources: dict[str, str] = {}
        self._known: dict[str, tuple[list[Item] | None, str]] = {}

    @classmethod
    def of_request(cls, request: FurnishRequest, catalogue: Catalogue | None) -> "ModelChooser":
        """Return the chooser of a floor with the configured model.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when no model is configured.
        """
        return cls(LlmClient.from_environment(), catalogue or load_catalogue(), request)

    @property
    def usage(self) -> LlmUsage:
        """What the answers took, without what differs between a run and its replay."""
        return msgspec.structs.replace(self._client.usage, from_store=0, retries=0, seconds=0.0)

    def __call__(self, room: SceneRoom, area: float, extent: tuple[float, float]) -> Sequence[Item] | None:
        """Return a room's floor objects, or ``None`` for the room type's own list."""
        piece = f"objects/{room.id}"
        if not self._client.wants("objects"):
            self.sources[piece] = "rules"
            return None
        if not self._catalogue.room_program(room.room_type).floor:
            self.sources[piece] = "rules: such rooms stay empty"
            return None
        prompt = objects_prompt(
            self._catalogue,
            room.room_type,
            area,
            extent,
            building_type=self._request.building_type or "building",
            style=self._request.style or "neutral",
            description=self._request.description,
        )
        if prompt.user not in self._known:
            answer = self._client.ask(
                prompt,
                ObjectsAnswer,
                lambda value: object_faults(value, self._catalogue, room.room_type, area, extent),
                array_field="objects",
            )
            faulty = answer.faulty_pieces()
            items: list[Item] | None = None
            source = f"rules: {answer.reason}"
            if answer.value is not None and "room" not in faulty:
                items = object_items(answer.value, faulty)
                source = f"llm without {', '.join(sorted(faulty))}: {answer.reason}" if faulty else "llm"
            if not items:
                items, source = None, f"rules: {answer.reason}"
            self._known[prompt.user] = (items, source)
        chosen, self.sources[piece] = self._known[prompt.user]
        return chosen
