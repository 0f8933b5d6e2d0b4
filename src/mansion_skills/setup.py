"""Build mansion_skills with colcon (ament_python) or pip."""

import re
from pathlib import Path

from setuptools import find_packages, setup

NAME = "mansion_skills"

setup(
    name=NAME,
    version=re.findall("<version>(.+)</version>", Path("package.xml").read_text(encoding="utf-8"))[0],
    description="The robot in the building: world state, navigation, skills and camera.",
    author="Mansion maintainers",
    maintainer="Mansion maintainers",
    maintainer_email="maintainers@mansion.example",
    license="Apache-2.0",
    python_requires=">=3.11,<3.14",
    packages=find_packages(include=[NAME, f"{NAME}.*"]),
    package_data={"": ["py.typed", "**/data/**", "**/*.json", "**/*.rviz"]},
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
    ],
    zip_safe=False,
    install_requires=[
        "mansion_geometry",
        "mansion_language",
        "mansion_msgs_py",
        "msgspec>=0.19",
        "numpy>=1.26",
        "pillow>=10.1",
        "shapely>=2.0",
    ],
    extras_require={"test": ["pytest"], "sim": ["mujoco>=3.0"], "thor": ["ai2thor>=5.0"]},
    entry_points={"console_scripts": ["skill_server = mansion_skills.nodes.skill_server:main"]},
)
