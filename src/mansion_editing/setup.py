"""Build mansion_editing with colcon (ament_python) or pip."""

import re
from pathlib import Path

from setuptools import find_packages, setup

NAME = "mansion_editing"

setup(
    name=NAME,
    version=re.findall("<version>(.+)</version>", Path("package.xml").read_text(encoding="utf-8"))[0],
    description="Changes to a furnished building: store, tools, physics and instructions.",
    author="Mansion maintainers",
    maintainer="Mansion maintainers",
    maintainer_email="maintainers@mansion.example",
    license="Apache-2.0",
    python_requires=">=3.11,<3.14",
    packages=find_packages(include=[NAME, f"{NAME}.*"]),
    package_data={"": ["py.typed", "**/data/**"]},
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
    ],
    zip_safe=False,
    install_requires=[
        "mansion_assets",
        "mansion_export",
        "mansion_geometry",
        "mansion_language",
        "mansion_knowledge",
        "mansion_llm",
        "mansion_msgs_py",
        "mansion_scene",
        "msgspec>=0.19",
        "numpy>=1.26",
        "shapely>=2.0",
    ],
    extras_require={"test": ["pytest"], "sim": ["mujoco>=3.0"], "thor": ["ai2thor>=5.0"]},
    entry_points={"console_scripts": ["scene_editor = mansion_editing.nodes.scene_editor:main"]},
)
