"""How far Mansion's own commands and clients look for nodes: this machine, unless the user says otherwise."""

import os
from collections.abc import MutableMapping

__all__ = ["stay_on_this_machine"]

CHOICES = (
    "ROS_AUTOMATIC_DISCOVERY_RANGE",
    "ROS_LOCALHOST_ONLY",
    "ROS_STATIC_PEERS",
    "CYCLONEDDS_URI",
)
"""Variables by which a user of ROS 2 chooses the range; any of them is left as it is."""


def stay_on_this_machine(environment: MutableMapping[str, str] = os.environ) -> None:
    """Set the discovery range to LOCALHOST where the environment does not choose one.

    Processes in one range find each other only if they agree on it, so commands, nodes and clients all call this.
    """
    if not any(name in environment for name in CHOICES):
        environment["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
