"""Plans that a model writes as code: read as a list of skill calls, never executed as a program."""

import ast
from typing import Any, Final

from mansion_msgs_py.task import SkillCall
from mansion_skills.skills.declaration import snake_case
from mansion_tasks.agents.skill_cards import CARDS, faulty_arguments

__all__ = ["MAX_CALLS", "PlanError", "read_plan"]

MAX_CALLS: Final = 40
MAX_LENGTH: Final = 6000
_SNAKE: Final = {snake_case(name): name for name in CARDS}


class PlanError(ValueError):
    """A plan that is more, or less, than calls of skills with literal arguments."""


def read_plan(code: str) -> list[SkillCall]:
    """Return the calls of a plan.

    The text is parsed and looked at, nothing of it runs: each statement must be the call of a skill by its name
    (``GoToLandmark`` or ``go_to_landmark``), each argument a number or a string.

    Raises
    ------
    PlanError
        With the line, what stands there, and what may.

    Examples
    --------
    >>> read_plan('go_to_landmark("elevator")  # first\\nMoveAhead(-0.5)')[1].arguments
    {'distance': -0.5}
    >>> read_plan('__import__("os").system("ls")')
    Traceback (most recent call last):
        ...
    mansion_tasks.agents.plan_code.PlanError: line 1: a statement must be one call of a skill
    """
    if len(code) > MAX_LENGTH:
        raise PlanError(f"the plan has {len(code)} characters; at most {MAX_LENGTH} are allowed")
    try:
        tree = ast.parse(code)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        line = getattr(error, "lineno", None) or 1
        raise PlanError(f"line {line}: {str(error)[:100]}; write calls of skills") from None
    if len(tree.body) > MAX_CALLS:
        raise PlanError(f"the plan has {len(tree.body)} calls; at most {MAX_CALLS} are allowed")
    return [_call(statement) for statement in tree.body]


def _call(statement: ast.stmt) -> SkillCall:
    place = f"line {statement.lineno}"
    call = statement.value if isinstance(statement, ast.Expr) else None
    if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Name):
        raise PlanError(f"{place}: a statement must be one call of a skill")
    skill = _SNAKE.get(call.func.id, call.func.id)
    if skill not in CARDS:
        raise PlanError(f"{place}: there is no skill {call.func.id[:40]!r}; known are {', '.join(CARDS)}")
    names = list(CARDS[skill].arguments)
    if len(call.args) > len(names):
        raise PlanError(f"{place}: {skill} takes {len(names)} arguments")
    arguments: dict[str, Any] = {}
    for name, value in zip(names, call.args):
        arguments[name] = _literal(value, place)
    for keyword in call.keywords:
        if keyword.arg is None or keyword.arg in arguments:
            raise PlanError(f"{place}: an argument is given twice, or unpacked")
        arguments[keyword.arg] = _literal(keyword.value, place)
    fault = faulty_arguments(skill, arguments)
    if fault:
        raise PlanError(f"{place}: {fault}")
    return SkillCall(skill=skill, arguments=arguments)


def _literal(value: ast.expr, place: str) -> str | int | float:
    sign = 1
    if isinstance(value, ast.UnaryOp) and isinstance(value.op, ast.USub):
        sign, value = -1, value.operand
    found = value.value if isinstance(value, ast.Constant) else None
    if isinstance(found, str) and sign == 1:
        return found
    if isinstance(found, int | float) and not isinstance(found, bool):
        return sign * found
    raise PlanError(f"{place}: an argument must be a number or a string")
