"""Agents by the names that the command line takes."""

from collections.abc import Callable

from mansion_llm import LlmClient
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.wording import choices
from mansion_tasks.agents.baselines import OracleAgent, RandomAgent
from mansion_tasks.agents.bumble import Bumble
from mansion_tasks.agents.come_robot import ComeRobot
from mansion_tasks.agents.explorer import Explorer
from mansion_tasks.agents.interface import Agent

__all__ = ["AGENTS", "ASKING", "LEARNING", "check_agents", "make_agent"]

_SCRIPTED: dict[str, Callable[[], Agent]] = {"random": RandomAgent, "oracle": OracleAgent, "explorer": Explorer}
_MODELLED: dict[str, Callable[[LlmClient], Agent]] = {
    "bumble": Bumble,
    "bumble_text": lambda client: Bumble(client, types=True),
    "come": ComeRobot,
}

AGENTS = (*_SCRIPTED, *_MODELLED)
"""Names of all agents."""

ASKING = tuple(_MODELLED)
"""Agents that ask a language model."""

LEARNING = ("bumble", "bumble_text")
"""Agents that keep lessons between episodes, whose episodes in a building therefore run in order."""


def check_agents(names: list[str]) -> None:
    """Refuse names of no agent.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with the names that there are.
    """
    for name in names:
        if name not in AGENTS:
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no agent {name!r}; {choices(name, AGENTS, 'agents')}")


def _client() -> LlmClient:
    return LlmClient.from_environment(otherwise=f"take an agent of {', '.join(_SCRIPTED)}")


def make_agent(name: str, client: Callable[[], LlmClient] = _client) -> Agent:
    """Return an agent.

    Parameters
    ----------
    name : str
        One of `AGENTS`.
    client : callable
        Makes the client of those that ask a model; the environment's when absent.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a name of no agent, ``UNAVAILABLE`` when a model is needed and none is configured.

    Examples
    --------
    >>> make_agent("explorer").name
    'explorer'
    """
    check_agents([name])
    if name in _SCRIPTED:
        return _SCRIPTED[name]()
    return _MODELLED[name](client())
