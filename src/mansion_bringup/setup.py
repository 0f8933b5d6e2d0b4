"""Build mansion_bringup with colcon (ament_python) or pip."""

import re
from glob import glob
from pathlib import Path

from setuptools import find_packages, setup

NAME = "mansion_bringup"

setup(
    name=NAME,
    version=re.findall("<version>(.+)</version>", Path("package.xml").read_text(encoding="utf-8"))[0],
    description="Mansion end to end: the building director, launch files, the command line and the RViz view.",
    author="Mansion maintainers",
    maintainer="Mansion maintainers",
    maintainer_email="maintainers@mansion.example",
    license="Apache-2.0",
    python_requires=">=3.11,<3.14",
    packages=find_packages(include=[NAME, f"{NAME}.*"]),
    package_data={
        "": ["py.typed", "**/data/**", "**/*.json", "**/*.rviz", "loopback.xml"],
        "mansion_bringup.graph": ["tf2_msgs/*", "tf2_msgs/*/*"],
    },
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
        (f"share/{NAME}/launch", sorted(glob("launch/*.py"))),
        (f"share/{NAME}/config", sorted(glob("config/*.yaml"))),
        (f"share/{NAME}/rviz", sorted(glob("rviz/*.rviz"))),
    ],
    zip_safe=False,
    install_requires=[
        "mansion_assets",
        "mansion_editing",
        "mansion_export",
        "mansion_geometry",
        "mansion_knowledge",
        "mansion_language",
        "mansion_llm",
        "mansion_msgs_py",
        "mansion_planner",
        "mansion_scene",
        "mansion_skills",
        "mansion_tasks",
        "mansion_world",
        "matplotlib>=3.6",
        "msgspec>=0.19",
        "networkx>=2.8",
        "numpy>=1.26",
        "pillow>=10",
        "pyyaml>=6.0",
        "rich>=13",
        "shapely>=2.0",
        "typer>=0.12",
    ],
    extras_require={
        "test": ["pytest"],
        "cluster": ["distributed>=2024.1"],
        "record": ["mcap>=1.1", "mcap-ros2-support>=0.5"],
        "rerun": ["mcap>=1.1", "mcap-ros2-support>=0.5", "rerun-sdk>=0.41"],
    },
    entry_points={
        "console_scripts": [
            "building_director = mansion_bringup.nodes.building_director:main",
            "mansion = mansion_bringup.cli:main",
        ]
    },
)
