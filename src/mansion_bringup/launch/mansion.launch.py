"""The whole graph: ``ros2 launch mansion_bringup mansion.launch.py [namespace:=/mansion] [...]``."""

import os
from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

from launch import LaunchDescription
from mansion_bringup.graph.processes import GRAPH_NODES
from mansion_skills.nodes.robot_names import robot_namespace

SWITCH = ["true", "false"]


def _nodes(context, *args, **kwargs):
    """Make the node actions once the arguments are known."""

    def value(name):
        return LaunchConfiguration(name).perform(context)

    simulated = value("use_sim_time") == "true"
    root = robot_namespace(value("robot_namespace"), "/" + value("namespace").strip("/"))
    actions = []
    for entry in GRAPH_NODES:
        # What is off or empty is not passed on, so that a parameter file may set it.
        parameters = [{"use_sim_time": True}] if simulated else []
        if value("allow"):
            parameters.append({"allow": value("allow").split(os.pathsep)})
        if entry.executable == "building_director" and value("lend_client") == "true":
            parameters.append({"lend_client": True})
        if entry.executable == "skill_server":
            if value("publish_clock") == "true":
                parameters.append({"publish_clock": True})
            names = ("robot_namespace", "frame_prefix")
            parameters += [{name: value(name)} for name in names if value(name)]
        files = (_file(context, "params_file"), _file(context, f"{entry.executable}_params"))
        actions.append(
            Node(
                package=entry.package,
                executable=entry.executable,
                name=entry.executable,
                namespace=value("namespace"),
                parameters=[*parameters, *(path for path in files if path)],
                ros_arguments=["--log-level", value("log_level")],
                # A node that takes the time from /clock takes that of its own building.
                remappings=[("/clock", f"{root}/clock")] if simulated and root else [],
                output="screen",
                respawn=value("respawn") == "true",
                respawn_delay=2.0,
            )
        )
    if value("rviz") == "true":
        actions.append(_rviz(simulated))
    return actions


def _file(context, name):
    """Return an argument that names a file; stop where there is none."""
    path = LaunchConfiguration(name).perform(context)
    if path and not Path(path).is_file():
        raise RuntimeError(f"{name}:={path}: there is no such file")
    return path


def _rviz(simulated):
    view = Path(get_package_share_directory("mansion_bringup"), "rviz", "mansion.rviz")
    return Node(
        package="rviz2",
        executable="rviz2",
        arguments=["-d", str(view)],
        parameters=[{"use_sim_time": simulated}],
        output="screen",
    )


def _switch(name, description):
    return DeclareLaunchArgument(name, default_value="false", choices=SWITCH, description=description)


def _arguments():
    """Declare what the launch file takes for all nodes."""
    return [
        DeclareLaunchArgument("namespace", default_value="/mansion", description="of all nodes"),
        DeclareLaunchArgument(
            "log_level",
            default_value="info",
            choices=["debug", "info", "warn", "error", "fatal"],
            description="of all nodes",
        ),
        DeclareLaunchArgument("params_file", default_value="", description="ROS parameter file for all nodes"),
        DeclareLaunchArgument(
            "robot_namespace",
            default_value="",
            description="namespace of map, odom, scan, cmd_vel, tf and clock: / for the global names; if empty, the "
            "global names under /mansion and the nodes' own namespace elsewhere",
        ),
        DeclareLaunchArgument("frame_prefix", default_value="", description="prefix of every frame, such as site_b/"),
        DeclareLaunchArgument(
            "allow",
            default_value="",
            description="folders below which services may write, besides the working folder and the temporary one: "
            "DIR, or DIR:DIR",
        ),
        _switch("use_sim_time", "take the time from /clock, in all nodes"),
        _switch("publish_clock", "have skill_server publish the world's clock on /clock"),
        DeclareLaunchArgument(
            "lend_client",
            default_value="true",
            choices=SWITCH,
            description="have building_director take the calls of `mansion call`, by a socket that is its user's alone",
        ),
        _switch("respawn", "start a node again that has ended, after 2 s"),
        _switch("rviz", "show map, frames, scan and markers in RViz (of the namespace /mansion)"),
    ]


def generate_launch_description():
    """Declare the arguments and start every node."""
    parameter_files = [
        DeclareLaunchArgument(
            f"{entry.executable}_params",
            default_value="",
            description=f"ROS parameter file for {entry.executable} alone",
        )
        for entry in GRAPH_NODES
    ]
    return LaunchDescription([*_arguments(), *parameter_files, OpaqueFunction(function=_nodes)])
