"""The whole graph: ``ros2 launch mansion_bringup mansion.launch.py [namespace:=/mansion] [...]``."""

from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

from launch import LaunchDescription
from mansion_bringup.graph.nodes import GRAPH_NODES


def _nodes(context, *args, **kwargs):
    """Make the node actions once the arguments are known."""
    namespace = LaunchConfiguration("namespace").perform(context)
    log_level = LaunchConfiguration("log_level").perform(context)
    params_file = LaunchConfiguration("params_file").perform(context)
    actions = []
    for entry in GRAPH_NODES:
        overrides = LaunchConfiguration(f"{entry.executable}_params").perform(context)
        parameters = [path for path in (params_file, overrides) if path]
        actions.append(
            Node(
                package=entry.package,
                executable=entry.executable,
                name=entry.executable,
                namespace=namespace,
                parameters=parameters,
                arguments=["--ros-args", "--log-level", log_level],
                output="screen",
            )
        )
    return actions


def generate_launch_description():
    """Declare the arguments and start every node."""
    arguments = [
        DeclareLaunchArgument("namespace", default_value="/mansion", description="of all nodes"),
        DeclareLaunchArgument(
            "log_level",
            default_value="info",
            choices=["debug", "info", "warn", "error", "fatal"],
            description="of all nodes",
        ),
        DeclareLaunchArgument(
            "params_file", default_value="", description="ROS parameter file for all nodes"
        ),
    ]
    arguments += [
        DeclareLaunchArgument(
            f"{entry.executable}_params",
            default_value="",
            description=f"ROS parameter file for {entry.executable} alone",
        )
        for entry in GRAPH_NODES
    ]
    return LaunchDescription([*arguments, OpaqueFunction(function=_nodes)])
