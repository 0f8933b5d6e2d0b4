"""Build mansion with colcon (ament_python) or pip."""

import re
from pathlib import Path

from setuptools import find_packages, setup

NAME = "mansion"

setup(
    name=NAME,
    version=re.findall("<version>(.+)</version>", Path("package.xml").read_text(encoding="utf-8"))[0],
    description="The front door: what a script or a notebook imports: buildings, their parts, edits, robots and tasks.",
    author="Mansion maintainers",
    maintainer="Mansion maintainers",
    maintainer_email="maintainers@mansion.example",
    license="Apache-2.0",
    python_requires=">=3.11,<3.14",
    packages=find_packages(include=[NAME, f"{NAME}.*"]),
    package_data={"": ["py.typed"]},
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
    ],
    zip_safe=False,
    install_requires=[
        "mansion_assets",
        "mansion_bringup",
        "mansion_editing",
        "mansion_export",
        "mansion_language",
        "mansion_msgs_py",
        "mansion_planner",
        "mansion_skills",
        "mansion_tasks",
        "mansion_world",
        "msgspec>=0.19",
        "networkx>=2.8",
        "numpy>=1.26",
    ],
    extras_require={"test": ["pytest"], "sim": ["gymnasium>=1.0"]},
)
