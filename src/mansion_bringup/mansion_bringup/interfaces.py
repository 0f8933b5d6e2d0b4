"""The whole interface table: the services, topics and payloads of every node, and the documentation made from it.

    python -m mansion_bringup.interfaces docs

writes the parts of ``interfaces.md`` and ``skills.md`` that are made from the table.
"""

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final

from mansion_msgs_py import interfaces as table
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import TOPICS, TRIGGER, ServiceInterface
from mansion_msgs_py.payloads import PAYLOADS as SHARED_PAYLOADS
from mansion_skills.skills.registry import SKILL_PAYLOADS, SKILLS

__all__ = ["PAGES", "PAYLOADS", "SERVICES", "markdown_table", "page", "payload_type", "skill_commands", "skill_table"]

_AFTER: Final = "load_building"
"""The service behind which the skills stand in the table."""


def _services() -> tuple[ServiceInterface, ...]:
    place = next(i for i, entry in enumerate(table.SERVICES) if entry.name == _AFTER) + 1
    skills = [skill.interface for skill in SKILLS.values()]
    return (*table.SERVICES[:place], *skills, *table.SERVICES[place:])


SERVICES: Final = _services()

PAYLOADS: Final[Mapping[str, type[Any]]] = {**SHARED_PAYLOADS, **SKILL_PAYLOADS}
"""The payload types by name, as ``mansion schema NAME`` lists them."""


def payload_type(name: str) -> type[Any]:
    """Return the payload type of that name.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with the names that exist.
    """
    try:
        return PAYLOADS[name]
    except KeyError:
        known = ", ".join(sorted(PAYLOADS))
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no payload {name!r}; payloads are {known}") from None


def _payload_name(kind: Any) -> str:
    if kind is None:
        return ""
    return getattr(kind, "__name__", str(kind)) if kind is not dict else "object"


def markdown_table() -> str:
    """Return the table of all interfaces as Markdown."""
    lines = ["| service | type | arguments | reply | node | what it does |", "| --- | --- | --- | --- | --- | --- |"]
    lines += [
        f"| `{s.name}` | `{s.type}` | {_payload_name(s.arguments)} | {_payload_name(s.reply)} "
        f"| `{s.node}` | {s.description} |"
        for s in SERVICES
    ]
    lines += ["", "| topic | type | payload | node | QoS | what it carries |", "| --- | --- | --- | --- | --- | --- |"]
    lines += [
        f"| `{t.name}` | `{t.type}` | {_payload_name(t.payload)} | `{t.node}` | {t.qos} | {t.description} |"
        for t in TOPICS
    ]
    return "\n".join(lines) + "\n"


def skill_table() -> str:
    """Return what each skill takes and can fail with as Markdown."""
    lines = ["| skill | arguments | can fail with |", "| --- | --- | --- |"]
    for skill in SKILLS.values():
        taken = "; ".join(f"`{name}`: {argument.description}" for name, argument in skill.parameters.items())
        failures = ", ".join(f"`{status.value}`" for status in skill.failures)
        lines.append(f"| {skill.name} | {taken} | {failures} |")
    return "\n".join(lines) + "\n"


def skill_commands() -> str:
    """Return a call of each service below ``skills/`` from a shell as Markdown."""
    parts = []
    for entry in SERVICES:
        if not entry.name.startswith("skills/"):
            continue
        shell, ros = "", ""
        if entry.type != TRIGGER:
            escaped = entry.example.replace('"', '\\"')
            shell, ros = f" '{entry.example}'", f" '{{load_namespace: \"{escaped}\"}}'"
        parts.append(
            f"**{entry.name}**: {entry.description}\n\n    mansion call {entry.name}{shell}\n"
            f"    ros2 service call /mansion/{entry.name} {entry.type}{ros}\n"
        )
    return "\n".join(parts)


PAGES: Final[Mapping[str, tuple[Callable[[], str], ...]]] = {
    "interfaces.md": (markdown_table,),
    "skills.md": (skill_table, skill_commands),
}
"""Pages of the documentation, with the functions that make parts of them, each between two comments that name it."""


def page(name: str, text: str) -> str:
    """Return a page with the parts that are made from the table."""
    for make in PAGES[name]:
        begin, end = f"<!-- {make.__name__} -->\n", f"<!-- end of {make.__name__} -->\n"
        before, _, rest = text.partition(begin)
        after = rest.partition(end)[2]
        text = f"{before}{begin}\n{make()}\n{end}{after}"
    return text


def main(docs: Path) -> None:
    """Rewrite the generated parts of the pages."""
    for name in PAGES:
        file = docs / name
        file.write_text(page(name, file.read_text()))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
