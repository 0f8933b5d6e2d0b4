"""How often a model may give nothing that is of use."""

from typing import Any, Final

from mansion_llm import Answer
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_tasks.agents.interface import Stop

__all__ = ["PATIENCE", "Patience"]

PATIENCE: Final = 3
"""Questions in a row without a usable answer."""


class Patience:
    """Counts useless answers in a row."""

    def __init__(self) -> None:
        self._vain = 0

    def reward(self) -> None:
        """Count from zero again, after a usable answer."""
        self._vain = 0

    def strain(self, answer: Answer[Any] | None) -> Stop | None:
        """Count one; return the end of the episode when it is enough.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when it is enough and the endpoint gave no answer at all: that says nothing of the agent.
        """
        self._vain += 1
        if self._vain < PATIENCE:
            return None
        if answer is not None and answer.value is None and not answer.faults:
            raise MansionError(
                ErrorCode.UNAVAILABLE, f"no answer from the model {PATIENCE} times in a row: {answer.reason}"
            )
        return Stop(f"the model gave no usable answer {PATIENCE} times in a row")
