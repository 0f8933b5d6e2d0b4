"""Names of a robot's topics and frames, so that several robots and buildings can share one ROS domain."""

from dataclasses import dataclass, replace

from mansion_msgs_py.interfaces import DEFAULT_NAMESPACE, TopicInterface, topic
from mansion_skills.world.overlay import DEFAULT_SESSION

__all__ = ["RobotNames", "robot_namespace"]


def robot_namespace(wanted: str, node_namespace: str) -> str:
    """Return where the topics of a robot stack (``map``, ``odom``, ``scan``, ``cmd_vel``, ...) live.

    Parameters
    ----------
    wanted : str
        The parameter; empty for the rule: the global names in the default namespace, else the node's own namespace.
    node_namespace : str

    Examples
    --------
    >>> robot_namespace("", "/mansion"), robot_namespace("", "/site_b"), robot_namespace("robots/", "/site_b")
    ('', '/site_b', '/robots')
    """
    if not wanted:
        wanted = "/" if node_namespace == DEFAULT_NAMESPACE else node_namespace
    inner = wanted.strip("/")
    return f"/{inner}" if inner else ""


@dataclass(frozen=True)
class RobotNames:
    """The names of one session's robot.

    Parameters
    ----------
    namespace : str
        Namespace of the robot stack, as `robot_namespace` returns it.
    frame_prefix : str
        Prefix of every frame, with its separator (``site_b/``).
    session : str
        The default session's topics have no further part; the others' have the session in front.

    Examples
    --------
    >>> names = RobotNames("", "", "r2")
    >>> names.interface("/odom").name, names.interface("robot_pose").name, names.frame("odom")
    ('/r2/odom', 'r2/robot_pose', 'odom')
    >>> RobotNames("/site_b", "site_b/", DEFAULT_SESSION).interface("/odom").name
    '/site_b/odom'
    """

    namespace: str
    frame_prefix: str
    session: str

    def interface(self, name: str) -> TopicInterface:
        """Return a row of the interface table with this robot's name of the topic."""
        entry = topic(name)
        inner = "" if self.session == DEFAULT_SESSION else self.session
        if name.startswith("/"):
            own = f"{self.namespace}/{inner}{name}" if inner else f"{self.namespace}{name}"
        else:
            own = f"{inner}/{name}" if inner else name
        return replace(entry, name=own)

    def frame(self, name: str) -> str:
        """Return the name of a frame."""
        return self.frame_prefix + name
