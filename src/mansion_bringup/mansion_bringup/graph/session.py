"""A client of the running graph, or of a private one that lives as long as it is needed."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from mansion_bringup.client import MansionClient
from mansion_bringup.discovery import kept_to_this_machine
from mansion_bringup.graph.domain import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses
from mansion_msgs_py.interfaces import DEFAULT_NAMESPACE

__all__ = ["graph_client"]

LOOK = 1.0
"""Seconds to look for a running graph."""


@contextmanager
def graph_client(
    *,
    namespace: str = DEFAULT_NAMESPACE,
    service: str = "build_building",
    notice: Callable[[str], None] = lambda text: None,
) -> Iterator[MansionClient]:
    """Yield a client of the graph of this domain; without one, start a private graph and end it afterwards.

    Parameters
    ----------
    namespace : str
    service : str
        What must be served for a graph to count as running.
    notice : callable
        Gets a line when a private graph is started.
    """
    with MansionClient(namespace=namespace) as client:
        if client.wait_served(service, LOOK):
            yield client
            return
    options = GraphOptions(namespace=namespace, domain_id=free_domain(), quiet=True)
    notice("no graph is running here: starting a private one")
    with kept_to_this_machine(), GraphProcesses(options) as graph:
        graph.wait_ready()
        with MansionClient(domain_id=options.domain_id, namespace=namespace) as client:
            graph.note_segments()
            yield client
