"""``object_placer``: the furnished scene of one floor (Algorithm 1, lines 9 to 17)."""

from collections.abc import Sequence
from pathlib import Path

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.callback_groups import ReentrantCallbackGroup

from mansion_assets.catalogue import load_catalogue
from mansion_assets.library.folders import library_folders
from mansion_msgs_py.interfaces import service, topic
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.nodes.run import run_node
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_service
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import FurnishRequest
from mansion_scene.assembly import furnish_floor

__all__ = ["ObjectPlacer", "main"]


class ObjectPlacer(MansionNode):
    """Serves ``furnish_floor`` and publishes each scene, latched."""

    def __init__(self) -> None:
        super().__init__("object_placer")
        self.declare_parameter(
            "catalogue_folders", [""], ParameterDescriptor(description="folders with assets and room types of your own")
        )
        self._scenes = JsonPublisher(self, topic("floor_scene"))
        add_json_service(self, service("furnish_floor"), self.furnish, callback_group=ReentrantCallbackGroup())

    def furnish(self, request: FurnishRequest) -> FloorScene:
        """Furnish one floor and publish its scene."""
        folders = self.get_parameter("catalogue_folders").value or []
        named = [Path(folder) for folder in folders if folder] or None
        catalogue = load_catalogue(named, preferred=library_folders(request.libraries))
        scene = furnish_floor(request, catalogue=catalogue)
        self._scenes.publish(scene)
        self.get_logger().info(
            f"{scene.building_id} floor {scene.floor}: {len(scene.rooms)} rooms, "
            f"{len(scene.objects)} objects, {len(scene.downgrades)} downgrades"
        )
        return scene


def main(args: Sequence[str] | None = None) -> None:
    """Run the node."""
    run_node(ObjectPlacer, args)


if __name__ == "__main__":
    main()
