"""Load the shared libraries of the ROS wheels when ROS is first imported; set-up copies this file into site-packages.

Every start of Python imports this module, so it imports nothing that Python has not loaded by then.
"""

import sys

FIRST_MODULES = ("rclpy", "rosidl_generator_py")
"""Whatever loads a shared library of ROS imports one of these before."""


class LibraryLoader:
    """A finder that finds nothing, but loads the libraries when a module is looked for that needs them."""

    @classmethod
    def find_spec(cls, fullname: str, path: object = None, target: object = None) -> None:
        """Load the libraries before the first import of ROS; leave the search to the other finders."""
        if fullname in FIRST_MODULES:
            sys.meta_path.remove(cls)
            from _mansion_ros_wheels import load_for

            load_for(fullname)


sys.meta_path.insert(0, LibraryLoader)
