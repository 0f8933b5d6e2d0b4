"""The Python client: Mansion's services and topics from a script, over the node graph.

Each client has a ROS context of its own, so one script can drive several graphs in several domains at once.
"""

import itertools
import os
import threading
import time
from collections.abc import Callable
from typing import Any, TypeVar

import rclpy
from rclpy.client import Client
from rclpy.context import Context
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String

from mansion_bringup.discovery import keep_to_this_machine
from mansion_bringup.graph.peer_processes import PeerProcesses
from mansion_bringup.graph.rclpy_available import check_rclpy
from mansion_msgs_py import interfaces
from mansion_msgs_py.closing import Closing
from mansion_msgs_py.codec import decode_reply, encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import Qos, ServiceInterface
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.nodes.node import wake_regularly
from mansion_msgs_py.nodes.shell import CALLS, JsonCall, Trigger, qos_profile
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import BuildJob, BuildReply, FurnishRequest, PlanReply
from mansion_msgs_py.wording import choices

__all__ = ["MansionClient"]

T = TypeVar("T")

_numbers = itertools.count(1)
_KNOWN: dict[str, ServiceInterface] = {entry.name: entry for entry in interfaces.SERVICES}

LOOK_FOR_SERVER = 0.25
"""Seconds between two looks whether the node that was asked is still there."""

GONE = 1.0
"""Seconds after which a node that discovery no longer knows counts as ended."""

LOOK = 0.01
"""Seconds between two looks for a service; rclpy's own wait looks four times a second."""


class MansionClient(Closing):
    """Calls the services of one graph, on this machine unless the environment's ROS 2 variables say otherwise.

    Parameters
    ----------
    domain_id : int, optional
        ROS domain; ``ROS_DOMAIN_ID`` when absent.
    namespace : str
        Where the graph lives.
    timeout : float
        Seconds that a call may take unless it says otherwise.

    Examples
    --------
    With a graph running (``mansion up``)::

        with MansionClient() as mansion:
            print(mansion.build("a small flat", output="/tmp/flat").path)
            mansion.call("load_building", {"path": "/tmp/flat"})
    """

    def __init__(
        self, *, domain_id: int | None = None, namespace: str = interfaces.DEFAULT_NAMESPACE, timeout: float = 600.0
    ) -> None:
        check_rclpy()
        if not rclpy.ok():
            # Where nodes run already, their range holds: a process has but one for a domain.
            keep_to_this_machine()
        self.timeout = timeout
        self._context = Context()
        rclpy.init(context=self._context, args=[], domain_id=domain_id)
        self.node: Node = rclpy.create_node(
            f"_mansion_client_{os.getpid()}_{next(_numbers)}",
            namespace=namespace,
            context=self._context,
            start_parameter_services=False,
            enable_rosout=False,
            use_global_arguments=False,
        )
        self._clients: dict[tuple[str, str], Client] = {}
        self._peers = PeerProcesses(self._own_endpoint, os.getpid())
        self._lock = threading.Lock()
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self.node)
        self._closed = threading.Event()
        wake_regularly(self.node)
        self._thread = threading.Thread(target=self._spin, name="mansion_client", daemon=True)
        self._thread.start()

    def _spin(self) -> None:
        try:
            while not self._closed.is_set():
                self._executor.spin_once()
        except ExternalShutdownException:
            return
        except Exception:
            # A signal may end the context between two calls of the executor, which then fail in many ways.
            if self._context.ok():
                raise

    def close(self) -> None:
        """End the client and its context; to close it again does nothing."""
        if self._closed.is_set():
            return
        # The executor's thread ends first: what it waits for must not be taken away under it.
        self._closed.set()
        self._executor.create_task(lambda: None)  # which ends its wait; waking it alone does not
        self._thread.join(timeout=2.0)
        self._executor.shutdown(timeout_sec=2.0)
        self.node.destroy_node()
        rclpy.try_shutdown(context=self._context)

    def call(
        self,
        name: str,
        arguments: Any = None,
        *,
        reply: type[T] | Any = Any,
        timeout: float | None = None,
        wait: float = 5.0,
        cancelled: Callable[[], bool] = lambda: False,
    ) -> Any:
        """Call a service by its name below the namespace and return the decoded reply.

        Parameters
        ----------
        name : str
            As in the interface table, or any Trigger or AddDiagnostics service of the graph.
        arguments : payload or JSON-compatible object, optional
        reply : type
            What to decode the answer into; plain dicts and lists when absent.
        timeout : float, optional
            Seconds for the answer.
        wait : float
            Seconds for the service to appear.
        cancelled : callable
            Asked a few times a second whether the answer is not wanted any more.

        Raises
        ------
        MansionError
            What the service answered, ``UNAVAILABLE`` when no node serves it or its node is gone, ``TIMEOUT``, or
            ``CANCELED``.

        Notes
        -----
        Discovery knows a killed node for some seconds more. No request is sent where only nodes are known whose
        processes have ended. A call during which its node ends is made again, of the node that takes its place, where
        the table says that it is repeatable.
        """
        client = self._client(name, arguments)
        if not self._becomes_served(client, wait):
            raise self._unserved(str(client.service_name))
        request = client.srv_type.Request()
        if client.srv_type is JsonCall:
            request.load_namespace = encode({} if arguments is None else arguments)
        deadline = time.monotonic() + (limit := self.timeout if timeout is None else timeout)
        again = name in _KNOWN and _KNOWN[name].repeatable
        while (response := self._answer(client, request, deadline, cancelled)) is None:
            if cancelled():
                raise MansionError(ErrorCode.CANCELED, f"{client.service_name}: the call was cancelled")
            if time.monotonic() >= deadline:
                details = {"service": client.service_name}
                text = f"{client.service_name}: no answer in {limit:g} s"
                raise MansionError(ErrorCode.TIMEOUT, text, details=details)
            if not again or not self._becomes_served(client, min(wait, deadline - time.monotonic())):
                raise _lost(client)
        return decode_reply(reply, response.message, success=response.success)

    def is_served(self, name: str) -> bool:
        """Whether a node serves `name` now."""
        return self._has_server(self._client(name, {}))

    def wait_served(self, name: str, timeout: float) -> bool:
        """Wait until a node serves `name`; False when none does after `timeout` seconds."""
        return self._becomes_served(self._client(name, {}), timeout)

    def sees_node(self, name: str) -> bool:
        """Whether a node `name` runs in the namespace of this client."""
        found = self.node.get_node_names_and_namespaces()
        return (name, self.node.get_namespace()) in found

    def _answer(self, client: Client, request: Any, deadline: float, cancelled: Callable[[], bool]) -> Any:
        """Return the response to a request; ``None`` where it is cancelled, late, or all nodes that got it are gone."""
        future = client.call_async(request)
        answered = threading.Event()
        future.add_done_callback(lambda _: answered.set())
        # After the request has left, so that the look costs no time: an answer is on its way meanwhile.
        asked = self._servers(client)
        there = time.monotonic()
        while not answered.wait(timeout=min(LOOK_FOR_SERVER, max(0.0, deadline - time.monotonic()))):
            now = time.monotonic()
            if client.service_is_ready() and (not asked or asked & self._running_servers(client)):
                there = now
            if now >= deadline or now - there > GONE or cancelled():
                client.remove_pending_request(future)
                return None
        return future.result()

    def _servers(self, client: Client) -> set[bytes]:
        """Return the ids of the writers that answer for a service, as the middleware knows them."""
        replies = f"rr{client.service_name}Reply"
        found = self.node.get_publishers_info_by_topic(replies, no_mangle=True)
        servers = {bytes(each.endpoint_gid) for each in found}
        self._peers.note(servers)
        return servers

    def _running_servers(self, client: Client) -> set[bytes]:
        return {server for server in self._servers(client) if not self._peers.ended(server)}

    def _has_server(self, client: Client) -> bool:
        """Whether a service is there, and not only because discovery still knows a process that has ended."""
        if not client.service_is_ready():
            return False
        servers = self._servers(client)
        return not servers or not all(self._peers.ended(server) for server in servers)

    def _becomes_served(self, client: Client, timeout: float) -> bool:
        """Wait until a service has a server; False when it has none after `timeout` seconds."""
        return _becomes(lambda: self._has_server(client), timeout)

    def _own_endpoint(self) -> bytes | None:
        """Return the id of an endpoint of this client, once it has one."""
        for client in tuple(self._clients.values()):
            requests = f"rq{client.service_name}Request"
            for found in self.node.get_publishers_info_by_topic(requests, no_mangle=True):
                if found.node_name == self.node.get_name():
                    return bytes(found.endpoint_gid)
        return None

    def _unserved(self, name: str) -> MansionError:
        """Return the error for a service that no node serves, with the services that are served."""
        callable_here = [
            found
            for found, types in sorted(self.node.get_service_names_and_types())
            if found != name and {interfaces.TRIGGER, interfaces.JSON_CALL} & set(types)
        ]
        hint = "is the graph running (`mansion up`)?"
        if callable_here:
            hint = choices(name, callable_here, "services")
        return MansionError(ErrorCode.UNAVAILABLE, f"no node serves {name}; {hint}", details={"service": name})

    def _client(self, name: str, arguments: Any) -> Client:
        kind = self._service_type(name, arguments)
        with self._lock:
            key = (name, kind.__name__)
            if key not in self._clients:
                self._clients[key] = self.node.create_client(kind, name, qos_profile=CALLS)
            return self._clients[key]

    def _service_type(self, name: str, arguments: Any) -> Any:
        if name in _KNOWN:
            return JsonCall if _KNOWN[name].type == interfaces.JSON_CALL else Trigger
        full = name if name.startswith("/") else f"{self.node.get_namespace().rstrip('/')}/{name}"
        for found, types in self.node.get_service_names_and_types():
            if found == full:
                return Trigger if interfaces.TRIGGER in types else JsonCall
        return Trigger if arguments is None else JsonCall

    def plan(self, request: BuildRequest) -> PlanReply:
        """Program, room graphs and solver problems of a request."""
        reply: PlanReply = self.call("plan_program", request, reply=PlanReply)
        return reply

    def solve(self, problem: FloorProblem) -> FloorLayout:
        """The layout of one floor."""
        reply: FloorLayout = self.call("solve_floor", problem, reply=FloorLayout)
        return reply

    def furnish(self, request: FurnishRequest) -> FloorScene:
        """The furnished scene of one floor."""
        reply: FloorScene = self.call("furnish_floor", request, reply=FloorScene)
        return reply

    def build(self, description: str, *, output: str | None = None, **fields: Any) -> BuildReply:
        """Build a whole building.

        Parameters
        ----------
        description : str
        output : str, optional
            Folder, seen from the director's process.
        **fields
            Other fields of `BuildJob`.
        """
        job = BuildJob(description=description, output=output, **fields)
        reply: BuildReply = self.call("build_building", job, reply=BuildReply)
        return reply

    def listen(self, name: str, handler: Callable[[str], None], qos: Qos | None = None) -> Callable[[], None]:
        """Call `handler` with the text of each message of a String topic; return how to stop.

        Parameters
        ----------
        qos : Qos, optional
            By default that of the interface table if the topic is in it, else reliable and volatile.
        """
        return self.subscribe(String, name, lambda message: handler(message.data), qos)

    def subscribe(
        self, kind: Any, name: str, handler: Callable[[Any], None], qos: Qos | None = None
    ) -> Callable[[], None]:
        """Call `handler` with each message of a topic of any type; return how to stop.

        Parameters
        ----------
        kind : type
            Type of the messages.
        qos : Qos, optional
            By default that of the interface table if the topic is in it, else reliable and volatile.
        """
        if qos is None:
            known = {entry.name: entry.qos for entry in interfaces.TOPICS}
            qos = known.get(name, interfaces.STREAM)
        stopped = threading.Event()

        def receive(message: Any) -> None:
            if not stopped.is_set():
                handler(message)

        self.node.create_subscription(kind, name, receive, qos_profile(qos))
        # The subscription itself stays: rclpy does not survive that one is destroyed while its executor waits.
        return stopped.set


def _lost(client: Client) -> MansionError:
    return MansionError(
        ErrorCode.UNAVAILABLE,
        f"the node that serves {client.service_name} disappeared during the call, "
        "which may or may not have been carried out",
        details={"service": client.service_name},
    )


def _becomes(condition: Callable[[], bool], timeout: float) -> bool:
    """Wait until a condition holds; False when it does not after `timeout` seconds."""
    deadline = time.monotonic() + timeout
    while not condition():
        if time.monotonic() >= deadline:
            return False
        time.sleep(LOOK)
    return True
