"""ROS domains for private graphs: one that nobody on this machine uses, given to one process alone."""

import errno
import os
import socket
from collections import deque
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["free_domain"]

PORT_BASE: Final = 7400
DOMAIN_GAIN: Final = 250
FIRST_UNICAST: Final = 10
"""Offset of the first participant's discovery port; each further participant's is two higher."""

CLAIM: Final = 2
"""Offset of a port that RTPS gives to nobody (2.2, 9.6.1.1: 0 and 1 are multicast, 10 and above unicast)."""

PROBED_PARTICIPANTS: Final = 8
"""More than one is looked at: the first participant may have ended before the others."""

LAST_DOMAIN: Final = 101
"""Above it, the ports of a domain fall into Linux's ephemeral range."""

SPREAD: Final = 37
"""Domains between the first choices of processes with successive ids, so that neighbours rarely try the same."""

CLAIMS_KEPT: Final = 12
"""A claim must last until the first node has bound its port, some seconds; a process may ask hundreds of times."""

_claims: deque[socket.socket] = deque(maxlen=CLAIMS_KEPT)


def free_domain(start: int | None = None) -> int:
    """Return a domain without participants on loopback, and claim it.

    The claim is a bound UDP port, seen by all processes of this machine. It ends with this process, or when the process
    has asked for twelve more domains; by then the graph's own ports show that the domain is in use.

    Parameters
    ----------
    start : int, optional
        Where to begin looking; depends on the process id when absent.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when every domain is in use.
    """
    first = os.getpid() * SPREAD if start is None else start
    for step in range(LAST_DOMAIN):
        domain = 1 + (first + step) % LAST_DOMAIN
        if str(domain) == os.environ.get("ROS_DOMAIN_ID"):
            continue
        claim = _bound(domain, CLAIM)
        if claim is None:
            continue
        if all(_is_free(domain, FIRST_UNICAST + 2 * participant) for participant in range(PROBED_PARTICIPANTS)):
            _claims.append(claim)
            return domain
        claim.close()
    raise MansionError(ErrorCode.UNAVAILABLE, "every ROS domain of this machine is in use")


def _is_free(domain: int, offset: int) -> bool:
    probe = _bound(domain, offset)
    if probe is None:
        return False
    probe.close()
    return True


def _bound(domain: int, offset: int) -> socket.socket | None:
    """Bind a port of a domain on loopback; None when another socket has it."""
    bound = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        bound.bind(("127.0.0.1", PORT_BASE + DOMAIN_GAIN * domain + offset))
    except OSError as error:
        bound.close()
        if error.errno != errno.EADDRINUSE:
            raise MansionError(
                ErrorCode.UNAVAILABLE, f"no UDP port of 127.0.0.1 can be bound: {error.strerror}"
            ) from error
        return None
    return bound
