"""``mansion schema``: the JSON Schema of a payload."""

from typing import Annotated

import typer

from mansion_bringup.cli.console import AsJson, print_json
from mansion_msgs_py.codec import schema as schema_of
from mansion_msgs_py.payloads import PAYLOADS

__all__ = ["register"]


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("schema")(schema)


def schema(
    name: Annotated[str | None, typer.Argument(help="Payload type; all names when absent.")] = None,
    as_json: AsJson = False,
) -> None:
    """Print the JSON Schema of a payload, or the names of all payloads.

    Examples:

      mansion schema

      mansion schema BuildRequest
    """
    if name in PAYLOADS:
        # The skills, which declare the other payloads, bring compiled kernels with them.
        print_json(schema_of(PAYLOADS[name]))
        return
    from mansion_bringup import interfaces

    if name is None:
        names = sorted(interfaces.PAYLOADS)
        print_json(names) if as_json else typer.echo("\n".join(names))
    else:
        print_json(schema_of(interfaces.payload_type(name)))
