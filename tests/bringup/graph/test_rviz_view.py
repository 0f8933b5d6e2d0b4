"""Every display of the RViz view listens to a topic that a node publishes, with the type that the display reads."""

from pathlib import Path
from typing import Any

import pytest
import yaml

from mansion_msgs_py.interfaces import TOPICS

VIEW = Path(__file__).parents[3] / "src/mansion_bringup/rviz/mansion.rviz"
READS = {
    "rviz_default_plugins/Map": "nav_msgs/msg/OccupancyGrid",
    "rviz_default_plugins/MarkerArray": "visualization_msgs/msg/MarkerArray",
    "rviz_default_plugins/LaserScan": "sensor_msgs/msg/LaserScan",
    "rviz_default_plugins/Path": "nav_msgs/msg/Path",
    "rviz_default_plugins/Odometry": "nav_msgs/msg/Odometry",
    "rviz_default_plugins/Pose": "geometry_msgs/msg/PoseStamped",
    "rviz_default_plugins/PoseArray": "geometry_msgs/msg/PoseArray",
}
NO_TOPIC = {"rviz_default_plugins/Grid", "rviz_default_plugins/TF"}


def displays() -> list[dict[str, Any]]:
    view: dict[str, Any] = yaml.safe_load(VIEW.read_text(encoding="utf-8"))
    assert view["Visualization Manager"]["Global Options"]["Fixed Frame"] == "map"
    return list(view["Visualization Manager"]["Displays"])


@pytest.mark.parametrize("display", displays(), ids=lambda display: display["Name"])
def test_a_display_reads_a_topic_of_its_type(display: dict[str, Any]) -> None:
    if display["Class"] in NO_TOPIC:
        return
    published = {topic.name if topic.name.startswith("/") else f"/mansion/{topic.name}": topic.type for topic in TOPICS}
    assert published[display["Topic"]["Value"]] == READS[display["Class"]]
