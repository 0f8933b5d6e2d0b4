"""The whole graph: ``ros2 launch mansion_bringup mansion.launch.py [namespace:=/mansion] [...]``."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

from launch import LaunchDescription
from mansion_bringup.graph.nodes import GRAPH_NODES

SWITCH = ["true", "false"]


def _nodes(context, *args, **kwargs):
    """Make the node actions once the arguments are known."""

    def value(name):
        return LaunchConfiguration(name).perform(context)

    simulated = value("use_sim_time") == "true"
    actions = []
    for entry in GRAPH_NODES:
        # Switches that are off are not passed on, so that a parameter file may set what they set.
        parameters = [{"use_sim_time": True}] if simulated else []
        if entry.executable == "skill_server" and value("publish_clock") == "true":
            parameters.append({"publish_clock": True})
        files = (value("params_file"), value(f"{entry.executable}_params"))
        actions.append(
            Node(
                package=entry.package,
                executable=entry.executable,
                name=entry.executable,
                namespace=value("namespace"),
                parameters=[*parameters, *(path for path in files if path)],
                ros_arguments=["--log-level", value("log_level")],
                output="screen",
                respawn=value("respawn") == "true",
                respawn_delay=2.0,
            )
        )
    if value("rviz") == "true":
        actions.append(_rviz(simulated))
    return actions


def _rviz(simulated):
    view = Path(get_package_share_directory("mansion_bringup"), "rviz", "mansion.rviz")
    return Node(
        package="rviz2",
        executable="rviz2",
        arguments=["-d", str(view)],
        parameters=[{"use_sim_time": simulated}],
        output="screen",
    )


def generate_launch_description():
    """Declare the arguments and start every node."""

    def switch(name, description):
        return DeclareLaunchArgument(
            name, default_value="false", choices=SWITCH, description=description
        )

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
        switch("use_sim_time", "take the time from /clock, in all nodes"),
        switch("publish_clock", "have skill_server publish the world's clock on /clock"),
        switch("respawn", "start a node again that has ended, after 2 s"),
        switch("rviz", "show map, frames, scan and markers in RViz (of the namespace /mansion)"),
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
