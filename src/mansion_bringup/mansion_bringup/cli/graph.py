"""``mansion up``, ``call``, ``echo`` and ``graph``: the node graph from the shell."""

import os
import queue
import shutil
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from mansion_bringup.cli.console import AsJson, err, print_json
from mansion_bringup.cli.socket_call import CALL_TIMEOUT, absolute_namespace, json_argument
from mansion_bringup.graph.call_progress import CallProgress, progress_line, progress_topic
from mansion_bringup.graph.call_socket import ask_resident
from mansion_bringup.graph.rclpy_available import check_domain
from mansion_msgs_py.codec import decode, decode_reply, encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interface_types import DEFAULT_NAMESPACE

if TYPE_CHECKING:
    from mansion_bringup.client import MansionClient
    from mansion_bringup.graph.processes import GraphProcesses

__all__ = ["register"]

ECHO_STEP = 0.2
"""Seconds between looks for a topic."""

ECHO_PATIENCE = 2.0
"""Seconds of silence after which ``echo`` says what it knows of the topic."""

RESPAWN_DELAY = 2.0
"""Seconds before a node is started again, as in the launch file."""

Namespace = Annotated[str, typer.Option("--namespace", "-n", help="Where the graph lives.")]


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    app.command("up")(up)
    app.command("call", no_args_is_help=True)(call)
    app.command("echo", no_args_is_help=True)(echo)
    app.command("graph")(graph)


def up(
    namespace: Namespace = DEFAULT_NAMESPACE,
    log_level: Annotated[str, typer.Option(help="debug, info, warn, error or fatal.")] = "info",
    params_file: Annotated[Path | None, typer.Option(exists=True, dir_okay=False, help="ROS parameter file.")] = None,
    processes: Annotated[
        bool, typer.Option("--processes", help="Start plain processes even if ros2 launch is available.")
    ] = False,
    with_tf: Annotated[
        bool,
        typer.Option("--with-tf", help="Build tf2_msgs first if it is missing, to publish /tf (needs a C++ compiler)."),
    ] = False,
    respawn: Annotated[bool, typer.Option("--respawn", help="Restart nodes that end.")] = False,
    allow: Annotated[
        list[Path] | None,
        typer.Option(
            "--allow",
            metavar="DIR",
            help="Let services write below DIR too, besides the working and the temporary folder; may be repeated.",
        ),
    ] = None,
) -> None:
    """Start the node graph and stay until Ctrl-C.

    Examples:

      mansion up

      mansion up --namespace /site_b/mansion --log-level debug

      mansion up --with-tf

      mansion up --allow /srv/buildings

      ROS_DOMAIN_ID=7 mansion up
    """
    if not processes and _has_launch():
        _exec_launch(namespace, log_level, params_file, allow or [], respawn=respawn)
    from mansion_bringup.graph.processes import GraphOptions, GraphProcesses
    from mansion_bringup.graph.tf2_build import build_tf2_msgs, has_tf2

    if with_tf and not has_tf2():
        build_tf2_msgs(lambda text: err.print(text, highlight=False))
    options = GraphOptions(
        namespace=absolute_namespace(namespace), log_level=log_level, params_file=params_file, allow=tuple(allow or ())
    )
    with GraphProcesses(options) as running:
        running.wait_ready()
        from mansion_bringup.graph.resident_client import ResidentClient

        names = ", ".join(f"{node.executable}" for node in running.nodes)
        with ResidentClient(options.namespace):
            err.print(f"up in {options.namespace}: {names}. Ctrl-C ends them.", highlight=False)
            try:
                _watch(running, respawn=respawn)
            except KeyboardInterrupt:
                err.print("ending the nodes")


def _watch(running: "GraphProcesses", *, respawn: bool) -> None:
    """Stay until a node ends; start it again instead, after a while, where that is wanted."""
    while True:
        ended = running.ended()
        for name, status in ended.items():
            if not respawn:
                raise MansionError(ErrorCode.UNAVAILABLE, f"node {name} ended with status {status}")
            err.print(f"node {name} ended with status {status}; restarting it", highlight=False)
        if ended:
            time.sleep(RESPAWN_DELAY)
            for name in ended:
                running.start(name)
        time.sleep(0.2)


def _has_launch() -> bool:
    share = Path("share/ament_index/resource_index/packages/mansion_bringup")
    prefixes = os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep)
    return shutil.which("ros2") is not None and any(prefix and (Path(prefix) / share).exists() for prefix in prefixes)


def _exec_launch(namespace: str, log_level: str, params_file: Path | None, allow: list[Path], *, respawn: bool) -> None:
    arguments = [
        f"namespace:={absolute_namespace(namespace)}",
        f"log_level:={log_level}",
        f"respawn:={str(respawn).lower()}",
    ]
    if params_file is not None:
        arguments.append(f"params_file:={params_file.absolute()}")
    if allow:
        arguments.append(f"allow:={os.pathsep.join(str(folder.absolute()) for folder in allow)}")
    sys.stdout.flush()
    os.execvp("ros2", ["ros2", "launch", "mansion_bringup", "mansion.launch.py", *arguments])


def call(
    service: Annotated[str, typer.Argument(help="Name below the namespace, or absolute.")],
    arguments: Annotated[str | None, typer.Argument(help="JSON; @FILE reads a file.")] = None,
    namespace: Namespace = DEFAULT_NAMESPACE,
    timeout: Annotated[float, typer.Option(min=0.1, help="Seconds to wait for the reply.")] = CALL_TIMEOUT,
) -> None:
    """Call a service and print the reply's JSON; exit status 1 when it fails. Long calls say how far they are.

    Examples:

      mansion call build_building '{"description": "a small flat", "output": "/tmp/flat"}'

      mansion call load_building '{"path": "/tmp/flat"}'

      mansion call skills/call_elevator
    """
    payload = None if arguments is None else json_argument(arguments)
    check_domain()
    progress = CallProgress(service, quiet=err.quiet)
    try:
        reply = _answer(service, payload, absolute_namespace(namespace), timeout, progress)
        progress.end()
        print_json(reply)
    except MansionError as error:
        progress.end()
        print_json(error.reply())
        raise


def _answer(service: str, payload: Any, namespace: str, timeout: float, progress: CallProgress) -> Any:
    """Return a reply by way of the process that keeps the graph, or of a participant of this process."""
    answer = ask_resident(service, payload, namespace=namespace, timeout=timeout, progress=progress)
    if answer is not None:
        return decode_reply(object, answer.message, success=answer.success)
    from mansion_bringup.client import MansionClient

    with MansionClient(namespace=namespace) as client, _told_by_topic(client, service, payload, progress):
        return client.call(service, payload, timeout=timeout)


@contextmanager
def _told_by_topic(client: "MansionClient", service: str, payload: Any, progress: CallProgress) -> Iterator[None]:
    """Pass on what the node of a service publishes of how far it is, and the time, until the end of the block."""
    topic = progress_topic(service)
    ended = threading.Event()

    def hear(text: str) -> None:
        with suppress(MansionError):
            if (line := progress_line(topic or "", text, payload)) is not None:
                told.put(line)

    told: queue.SimpleQueue[str] = queue.SimpleQueue()
    if topic is not None:
        client.listen(topic, hear)

    def show() -> None:
        while not ended.is_set():
            try:
                progress.told(told.get(timeout=ECHO_STEP))
            except queue.Empty:
                progress.tick()

    shower = threading.Thread(target=show, daemon=True)
    shower.start()
    try:
        yield
    finally:
        ended.set()
        shower.join()


def echo(
    topic: Annotated[str, typer.Argument(help="Name below the namespace, or absolute.")],
    namespace: Namespace = DEFAULT_NAMESPACE,
    count: Annotated[int, typer.Option("--count", "-c", min=0, help="0: until Ctrl-C.")] = 0,
    timeout: Annotated[float, typer.Option(min=0, help="Seconds to wait for a message; 0: forever.")] = 0,
    as_json: Annotated[bool, typer.Option("--json", help="Each message as one line of JSON.")] = False,
) -> None:
    """Print the messages of a topic: text as it is, a line each; other types as YAML. Latched ones come at once.

    Examples:

      mansion echo progress

      mansion echo floor_scene --count 4

      mansion echo /map --count 1
    """
    from mansion_bringup.client import MansionClient
    from mansion_bringup.graph.topic_echo import silence

    received: queue.Queue[str] = queue.Queue()
    with MansionClient(namespace=absolute_namespace(namespace)) as client:
        printed, begun, said, listening = 0, time.monotonic(), False, False
        try:
            while count == 0 or printed < count:
                listening = listening or _listen(client.node, topic, received, as_json=as_json)
                try:
                    text = received.get(timeout=ECHO_STEP)
                except queue.Empty:
                    waited = time.monotonic() - begun
                    if timeout and waited >= timeout:
                        why = silence(client.node, topic)
                        raise MansionError(
                            ErrorCode.TIMEOUT, f"no message on {topic} in {timeout:g} s: {why}"
                        ) from None
                    if not said and waited >= ECHO_PATIENCE:
                        err.print(f"{silence(client.node, topic)}; waiting", highlight=False)
                        said = True
                    continue
                sys.stdout.write(text)
                sys.stdout.flush()
                printed, begun, said = printed + 1, time.monotonic(), True
        except KeyboardInterrupt:
            return


def _listen(node: Any, topic: str, received: Any, *, as_json: bool) -> bool:
    """Subscribe to a topic as soon as its type is known, and say whether it is."""
    from mansion_bringup.graph.topic_echo import find_topic, message_class, message_values, message_yaml
    from mansion_msgs_py.interfaces import STRING
    from mansion_msgs_py.nodes.shell import qos_profile

    found = find_topic(node, topic)
    if found is None:
        return False

    def show(message: Any) -> None:
        if found.type == STRING:
            received.put(f"{_one_line(message.data) if as_json else message.data}\n")
        else:
            received.put(f"{encode(message_values(message))}\n" if as_json else f"{message_yaml(message)}---\n")

    node.create_subscription(message_class(found), found.name, show, qos_profile(found.qos))
    return True


def _one_line(text: str) -> str:
    """Return the JSON of a payload as one line; text that is not JSON becomes a JSON string."""
    try:
        return encode(decode(object, text))
    except MansionError:
        return encode(text)


def graph(
    namespace: Namespace = DEFAULT_NAMESPACE,
    wait: Annotated[float, typer.Option(min=0, help="Seconds for discovery.")] = 1.0,
    as_json: AsJson = False,
) -> None:
    """List the nodes, topics and services of this domain.

    Examples:

      mansion graph

      mansion graph --json
    """
    from mansion_bringup.client import MansionClient

    with MansionClient(namespace=absolute_namespace(namespace)) as client:
        time.sleep(wait)
        node = client.node
        found = {
            "nodes": sorted(
                f"{space.rstrip('/')}/{name}"
                for name, space in node.get_node_names_and_namespaces()
                if not name.startswith("_")
            ),
            "topics": dict(sorted(node.get_topic_names_and_types())),
            "services": dict(sorted(node.get_service_names_and_types())),
        }
    if as_json:
        print_json(found)
        return
    _print_graph(found)


def _print_graph(found: dict[str, Any]) -> None:
    from rich.table import Table

    from mansion_bringup.cli.console import out

    out.print("[bold]nodes[/bold]")
    for name in found["nodes"]:
        out.print(f"  {name}", highlight=False)
    hidden = ("parameter", "get_type_description")
    for kind in ("topics", "services"):
        table = Table(kind.rstrip("s"), "type", box=None)
        for name, types in found[kind].items():
            last = name.rsplit("/", 1)[-1]
            if kind == "services" and any(word in last for word in hidden):
                continue
            table.add_row(name, ", ".join(types))
        out.print(table)
