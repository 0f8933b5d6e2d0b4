"""The range in which Mansion's commands and clients look for nodes: this machine, unless the user chooses another.

``ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST`` limits whom a node looks for, not who reaches it: Fast DDS still listens on
every interface, and a peer that names this host's address can call its services. Where nobody chose a range, Mansion's
processes therefore use a middleware profile, ``loopback.xml``, whose sockets are bound to 127.0.0.1. The profile holds
no shared memory transport, which over loopback is not faster, needs room in /dev/shm and leaves segments behind when a
process is killed.
"""

import os
from collections.abc import Iterator, Mapping, MutableMapping
from contextlib import contextmanager
from pathlib import Path
from typing import Final

__all__ = ["CHOICES", "LOOPBACK_PROFILE", "keep_to_this_machine", "kept_to_this_machine", "loopback_variables"]

RANGE: Final = "ROS_AUTOMATIC_DISCOVERY_RANGE"
PROFILE: Final = "FASTRTPS_DEFAULT_PROFILES_FILE"

CHOICES: Final = (
    RANGE,
    "ROS_LOCALHOST_ONLY",
    "ROS_STATIC_PEERS",
    "ROS_DISCOVERY_SERVER",
    "CYCLONEDDS_URI",
    PROFILE,
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTDDS_BUILTIN_TRANSPORTS",
)
"""Variables by which a user of ROS 2 chooses the range or the transport; any of them is left as it is."""

CHOSEN_FILES: Final = ("DEFAULT_FASTRTPS_PROFILES.xml", "DEFAULT_FASTDDS_PROFILES.xml")
"""Profiles that Fast DDS reads from the working directory: a choice of the user too."""

SOURCED: Final = "AMENT_PREFIX_PATH"
"""Set where a ROS 2 is sourced: there Mansion looks as far as ``ros2 launch`` and ``ros2 service call`` do."""

LOOPBACK_PROFILE: Final = Path(__file__).with_name("loopback.xml")


def keep_to_this_machine(environment: MutableMapping[str, str] = os.environ) -> None:
    """Keep processes with this environment to loopback where neither it nor a sourced ROS 2 chooses a range.

    Parameters
    ----------
    environment : mutable mapping
        Is given the variables.
    """
    if not _is_chosen(environment) and SOURCED not in environment:
        environment.update(loopback_variables(environment))


@contextmanager
def kept_to_this_machine(environment: MutableMapping[str, str] = os.environ) -> Iterator[None]:
    """Keep to loopback what starts inside, whatever ROS 2 is sourced; what the user chose holds here too.

    For private graphs: on a network, somebody else's could have the same domain.
    """
    added = {} if _is_chosen(environment) else loopback_variables(environment)
    environment.update(added)
    try:
        yield
    finally:
        for name in added:
            environment.pop(name, None)


def _is_chosen(environment: Mapping[str, str]) -> bool:
    return any(name in environment for name in CHOICES) or any(Path(name).exists() for name in CHOSEN_FILES)


def loopback_variables(environment: Mapping[str, str]) -> dict[str, str]:
    """Return the variables of loopback for the middleware that this environment runs on."""
    if SOURCED in environment:
        # It may be any middleware: each knows the range, and Fast DDS the profile beside it.
        return {RANGE: "LOCALHOST", PROFILE: str(LOOPBACK_PROFILE)}
    # The wheels' Fast DDS. With LOCALHOST, rmw_fastrtps would add transports of its own to those of the profile.
    return {RANGE: "SYSTEM_DEFAULT", PROFILE: str(LOOPBACK_PROFILE)}
