"""A graph of real node processes in a domain of its own, on loopback."""

import os
from collections.abc import Iterator

import pytest

from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")


@pytest.fixture(scope="module")
def graph(tmp_path_factory: pytest.TempPathFactory) -> Iterator[GraphProcesses]:
    """All nodes of the graph, running; ended by their process ids."""
    root = tmp_path_factory.mktemp("buildings")
    options = GraphOptions(
        domain_id=free_domain(), parameters={"building_director": {"output_root": str(root), "stage_timeout": "60.0"}}
    )
    with GraphProcesses(options) as running:
        running.wait_ready(300.0)
        yield running
