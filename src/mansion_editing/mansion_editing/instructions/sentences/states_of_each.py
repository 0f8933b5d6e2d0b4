"""How things are that came to several places: ``a candle on each table, lit``."""

from collections.abc import Sequence

import msgspec

from mansion_editing.instructions.statements import Add, Amount, Ensure, SetState, Statement

__all__ = ["with_states_of_each"]


def with_states_of_each(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which a state that is told right after things at each of several places is that of all."""
    out: list[Statement] = []
    for statement in statements:
        last = out[-1] if out else None
        several = isinstance(last, Add | Ensure) and (last.each or last.things.amount.number > 1)
        if several and isinstance(statement, SetState) and statement.things.refers == "last":
            bare = not statement.things.noun and not statement.things.amount.number
            them = msgspec.structs.replace(statement.things, plural=True, amount=Amount(kind="all", number=0))
            statement = msgspec.structs.replace(statement, things=them) if bare else statement
        out.append(statement)
    return out
