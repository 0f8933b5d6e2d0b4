"""The Cyclone configuration that Jazzy makes from the environment, and domains by number."""

from __future__ import annotations

import os
import threading
import warnings
from collections.abc import Mapping
from xml.sax.saxutils import quoteattr

from rclpy._dds.library import PRECONDITION_NOT_MET, DDSError, dds

__all__ = ["acquire_domain", "configuration", "domain_id_from_environment", "release_domain"]

_MAX_PARTICIPANT_INDEX = 99
"""Jazzy writes 32, which is then the number of processes in a domain on one machine."""

_TRANSPORT = (
    '<Internal><SocketReceiveBufferSize max="16MB"/><NackDelay>10ms</NackDelay>'
    "<MaxQueuedRexmitBytes>16MB</MaxQueuedRexmitBytes>"
    "<Watermarks><WhcLow>64MB</WhcLow><WhcHigh>256MB</WhcHigh><WhcHighInit>256MB</WhcHighInit>"
    "</Watermarks></Internal>"
)
"""Messages of megabytes go through in one burst, and what is lost is asked for again soon.
Unacknowledged data of a keep-last writer is bounded by its depth; waiting for a reader that
stands still would only stop the publisher."""

_LOOPBACK = "<MaxMessageSize>65500B</MaxMessageSize><FragmentSize>16000B</FragmentSize>"
"""Fragments that loopback carries whole; a fifth of the time for 5 MB."""

_lock = threading.Lock()
_domains: dict[int, tuple[int, int, str]] = {}
"""Entity, number of users, and discovery range of each domain of this process."""


def domain_id_from_environment(environment: Mapping[str, str] = os.environ) -> int:
    """``ROS_DOMAIN_ID``, 0 if unset or empty."""
    text = environment.get("ROS_DOMAIN_ID", "")
    if not text:
        return 0
    try:
        number = int(text)
    except ValueError:
        raise ValueError(f"ROS_DOMAIN_ID is not an integral number: {text!r}") from None
    if not 0 <= number <= 232:
        raise ValueError(f"ROS_DOMAIN_ID is {number}; domains are numbered 0 to 232")
    return number


def configuration(environment: Mapping[str, str] = os.environ) -> str:
    """The Cyclone configuration for the discovery range that the environment asks for.

    ``ROS_AUTOMATIC_DISCOVERY_RANGE`` is SUBNET, LOCALHOST, OFF or SYSTEM_DEFAULT;
    ``ROS_STATIC_PEERS`` lists addresses separated by semicolons; ``CYCLONEDDS_URI`` comes last, so that
    what it sets wins.
    """
    reach = environment.get("ROS_AUTOMATIC_DISCOVERY_RANGE", "").upper() or "SUBNET"
    peers = [p.strip() for p in environment.get("ROS_STATIC_PEERS", "").split(";") if p.strip()]
    if environment.get("ROS_LOCALHOST_ONLY") == "1":
        warnings.warn(
            "ROS_LOCALHOST_ONLY is deprecated but still honored if it is enabled. "
            "Use ROS_AUTOMATIC_DISCOVERY_RANGE and ROS_STATIC_PEERS instead.",
            stacklevel=2,
        )
        reach, peers = "LOCALHOST", []
    if reach not in ("SUBNET", "LOCALHOST", "OFF", "SYSTEM_DEFAULT"):
        warnings.warn(
            f"Invalid value {reach!r} specified for 'ROS_AUTOMATIC_DISCOVERY_RANGE', assuming SUBNET; "
            "valid values are LOCALHOST, SUBNET, OFF and SYSTEM_DEFAULT.",
            stacklevel=2,
        )
        reach = "SUBNET"
    general = discovery = ""
    if reach in ("LOCALHOST", "OFF"):
        large = _LOOPBACK if reach == "LOCALHOST" and not peers else ""
        general = f"<General><AllowMulticast>false</AllowMulticast>{large}</General>"
    if reach == "LOCALHOST":
        peers = ["localhost", *peers]
    if reach == "OFF":
        discovery = (
            "<Discovery><ParticipantIndex>none</ParticipantIndex>"
            f"<Tag>ros_discovery_off_{os.getpid()}</Tag></Discovery>"
        )
    elif peers and reach != "SYSTEM_DEFAULT":
        listed = "".join(f"<Peer address={quoteattr(peer)}/>" for peer in peers)
        discovery = (
            "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
            f"<MaxAutoParticipantIndex>{_MAX_PARTICIPANT_INDEX}</MaxAutoParticipantIndex>"
            f"<Peers>{listed}</Peers></Discovery>"
        )
    own = f"<CycloneDDS><Domain>{general}{discovery}{_TRANSPORT}</Domain></CycloneDDS>"
    given = environment.get("CYCLONEDDS_URI", "")
    return f"{own},{given}" if given else own


def acquire_domain(number: int) -> None:
    """Create the domain with our configuration if this process has not got it yet.

    Raises
    ------
    DDSError
        If the domain cannot be made, or was made when the environment asked for another range: as in Jazzy, all nodes
        of a process that are in one domain have the same.
    """
    with _lock:
        own = configuration()
        reach = configuration({**os.environ, "CYCLONEDDS_URI": ""})
        entity, users, used = _domains.get(number, (0, 0, reach))
        if used != reach:
            raise DDSError(
                PRECONDITION_NOT_MET,
                f"use domain {number}: attempt at creating nodes in the same domain with different discovery "
                "parameters",
            )
        if users == 0:
            entity = dds.dds_create_domain(number, own.encode())
            # Somebody else's domain (a plain cyclonedds participant) is used as it is.
            if entity < 0 and entity != PRECONDITION_NOT_MET:
                raise DDSError(entity, f"create domain {number} (check CYCLONEDDS_URI)")
        _domains[number] = (entity, users + 1, used)


def release_domain(number: int) -> None:
    """Give one use back; the domain ends with its last."""
    with _lock:
        entity, users, used = _domains.get(number, (0, 0, ""))
        if users > 1:
            _domains[number] = (entity, users - 1, used)
        elif users == 1:
            del _domains[number]
            if entity > 0:
                dds.dds_delete(entity)
