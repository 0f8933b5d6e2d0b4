"""A ROS domain that nobody on this machine uses."""

import os
import socket

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["free_domain"]

PORT_BASE = 7400
DOMAIN_GAIN = 250
FIRST_UNICAST = 10
LAST_DOMAIN = 101
"""Above it, the ports of a domain fall into Linux's ephemeral range."""


def free_domain(start: int | None = None) -> int:
    """Return a domain whose first participant's discovery port (RTPS 2.2, 9.6.1.1) is free on loopback.

    Parameters
    ----------
    start : int, optional
        Where to begin looking; depends on the process id when absent, so that neighbours rarely try the same.
    """
    first = os.getpid() if start is None else start
    for step in range(LAST_DOMAIN):
        domain = 1 + (first + step) % LAST_DOMAIN
        if str(domain) != os.environ.get("ROS_DOMAIN_ID") and _is_free(domain):
            return domain
    raise MansionError(ErrorCode.UNAVAILABLE, "every ROS domain of this machine is in use")


def _is_free(domain: int) -> bool:
    port = PORT_BASE + DOMAIN_GAIN * domain + FIRST_UNICAST
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(("127.0.0.1", port))
        except OSError:
            return False
    return True
