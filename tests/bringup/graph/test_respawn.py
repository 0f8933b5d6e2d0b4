"""``mansion up`` ends with a node that ends, or starts it again where that is wished."""

import pytest

from mansion_bringup.cli import graph
from mansion_msgs_py.errors import ErrorCode, MansionError


class Nodes:
    """Nodes of which one has ended, and then the user has enough."""

    def __init__(self) -> None:
        self.started: list[str] = []

    def ended(self) -> dict[str, int]:
        if self.started:
            raise KeyboardInterrupt
        return {"skill_server": -9}

    def start(self, executable: str) -> int:
        self.started.append(executable)
        return 1


@pytest.fixture(autouse=True)
def without_delay(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mansion_bringup.cli.graph.RESPAWN_DELAY", 0.0)


def test_a_node_that_ends_ends_the_graph() -> None:
    nodes = Nodes()
    with pytest.raises(MansionError, match="node skill_server ended with status -9") as caught:
        graph._watch(nodes, respawn=False)  # type: ignore[arg-type]
    assert caught.value.code == ErrorCode.UNAVAILABLE and nodes.started == []


def test_a_node_that_ends_is_started_again() -> None:
    nodes = Nodes()
    with pytest.raises(KeyboardInterrupt):
        graph._watch(nodes, respawn=True)  # type: ignore[arg-type]
    assert nodes.started == ["skill_server"]
