"""Declarations of skills: what each does, takes and can fail with, said once beside its implementation.

`skill` turns a function into a `Skill`. The services of the skill server, the cards that
a language model reads, the actions of the Gymnasium environment, the payloads of ``mansion schema`` and the tables of
the documentation follow from the skills that `mansion_skills.skills.registry` finds.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias, get_type_hints

import msgspec

from mansion_msgs_py.interface_types import ServiceInterface
from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.world import SkillResult, SkillStatus

__all__ = ["Action", "Argument", "Card", "Skill", "skill", "snake_case"]

Kind: TypeAlias = Literal["landmark", "object", "floor", "number", "text"]


@dataclass(frozen=True)
class Argument:
    """What an argument of a skill means: metadata of its annotation, ``Annotated[Any, Argument("number", "metres")]``.

    Attributes
    ----------
    kind : str
        ``landmark``, ``object`` and ``floor`` name something of the building; else a ``number`` or a ``text``.
    description : str
        What it is, with its unit.
    """

    kind: Kind
    description: str

    @property
    def json_type(self) -> str:
        """What a language model writes for it: ``number`` or ``text``."""
        return "number" if self.kind in ("floor", "number") else "text"


@dataclass(frozen=True)
class Card:
    """How a skill is described to a language model that may choose it.

    Attributes
    ----------
    description : str
        What the skill does, and what it needs.
    arguments : tuple of str
        Arguments that the model gives, in this order.
    optional : tuple of str
        Those of them that may be left out.
    """

    description: str
    arguments: tuple[str, ...] = ()
    optional: tuple[str, ...] = ()


@dataclass(frozen=True)
class Action:
    """A call of a skill that is one value of the Gymnasium environment's first index.

    Attributes
    ----------
    indexed : str
        Argument that a further index chooses, among the landmarks, objects or floors; empty for none.
    fixed : mapping
        Arguments that the action always has.
    """

    indexed: str = ""
    fixed: Mapping[str, Any] = field(default_factory=dict)


def snake_case(name: str) -> str:
    """Return the name of a skill in snake case.

    Examples
    --------
    >>> snake_case("CallElevator")
    'call_elevator'
    """
    return "".join(f"_{c.lower()}" if c.isupper() else c for c in name).lstrip("_")


@dataclass(frozen=True)
class Skill:
    """A skill of the robot.

    Attributes
    ----------
    name : str
        As the skill cards write it, ``CallElevator``.
    description : str
        What it does, for the interface table.
    call : callable
        ``(world, robot, arguments, *, realtime)`` to a running skill, or, of a query, ``(world, robot, arguments)`` to
        its answer.
    arguments : type
        Payload of a call, a `SessionArgs` whose further fields are annotated with `Argument`.
    reply : type
        `SkillResult`, or the answer of a query.
    example : str
        Arguments of an example as JSON; a skill without one takes none, and its service is a Trigger.
    failures : tuple of SkillStatus
        Statuses it can end with beside ``SUCCESS`` and, where it takes time, ``CANCELED``.
    card : Card, optional
        Absent where a language model is not offered the skill.
    actions : tuple of Action
    """

    name: str
    description: str
    call: Callable[..., Any]
    arguments: type[SessionArgs] = SessionArgs
    reply: type[Any] = SkillResult
    example: str = ""
    failures: tuple[SkillStatus, ...] = ()
    card: Card | None = None
    actions: tuple[Action, ...] = ()

    @property
    def service(self) -> str:
        """The name in snake case, ``call_elevator``."""
        return snake_case(self.name)

    @property
    def query(self) -> bool:
        """Whether it only answers, and changes nothing."""
        return self.reply is not SkillResult

    @property
    def interface(self) -> ServiceInterface:
        """The service of the skill server."""
        arguments = self.arguments if self.example else None
        return ServiceInterface(
            f"skills/{self.service}", "skill_server", self.description, arguments, self.reply, self.example
        )

    @property
    def parameters(self) -> dict[str, Argument]:
        """The arguments by name, without the session and the token, which every call has."""
        hints = get_type_hints(self.arguments, include_extras=True)
        return {
            entry.name: next(note for note in hints[entry.name].__metadata__ if isinstance(note, Argument))
            for entry in msgspec.structs.fields(self.arguments)
            if entry.name not in SessionArgs.__struct_fields__
        }


def skill(
    name: str,
    description: str,
    *,
    arguments: type[SessionArgs] = SessionArgs,
    reply: type[Any] = SkillResult,
    example: str = "",
    failures: tuple[SkillStatus, ...] = (),
    card: Card | None = None,
    actions: tuple[Action, ...] = (),
) -> Callable[[Callable[..., Any]], Skill]:
    """Declare a function as a skill; see `Skill` for the parameters.

    Examples
    --------
    ::

        @skill("Wait", "Stand still.", arguments=WaitArgs, example='{"seconds": 2}')
        def wait(world: World, robot: RobotBody, arguments: WaitArgs, *, realtime: bool) -> Run:
            yield Step(arguments.seconds, 1.0, "waiting")
            return done(world, robot, "Wait", "waited")
    """

    def declare(call: Callable[..., Any]) -> Skill:
        return Skill(name, description, call, arguments, reply, example, failures, card, actions)

    return declare
