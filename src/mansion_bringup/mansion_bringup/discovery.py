"""How far Mansion's own commands and clients look for nodes: this machine, unless the user says otherwise."""

import os
from collections.abc import Iterator, MutableMapping
from contextlib import contextmanager

__all__ = ["stay_on_this_machine", "stays_on_this_machine"]

RANGE = "ROS_AUTOMATIC_DISCOVERY_RANGE"

CHOICES = (RANGE, "ROS_LOCALHOST_ONLY", "ROS_STATIC_PEERS", "CYCLONEDDS_URI")
"""Variables by which a user of ROS 2 chooses the range; any of them is left as it is."""

SOURCED = "AMENT_PREFIX_PATH"
"""Set where a ROS 2 is sourced: there Mansion looks as far as ``ros2 launch`` and ``ros2 service call`` do."""


def stay_on_this_machine(environment: MutableMapping[str, str] = os.environ) -> None:
    """Set the discovery range to LOCALHOST where neither the environment nor a sourced ROS 2 chooses one.

    Processes find each other only if they agree on the range: over Cyclone DDS, LOCALHOST and ROS 2's own default,
    SUBNET, do not meet even on one machine. So commands, nodes and clients all call this.
    """
    if not any(name in environment for name in (*CHOICES, SOURCED)):
        environment[RANGE] = "LOCALHOST"


@contextmanager
def stays_on_this_machine(environment: MutableMapping[str, str] = os.environ) -> Iterator[None]:
    """Keep to this machine what starts inside, whatever ROS 2 is sourced; what the user chose holds here too.

    For private graphs: on a network, somebody else's could have the same domain.
    """
    chosen = any(name in environment for name in CHOICES)
    if not chosen:
        environment[RANGE] = "LOCALHOST"
    try:
        yield
    finally:
        if not chosen:
            environment.pop(RANGE, None)
