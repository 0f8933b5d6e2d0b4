"""Build mansion_planner with colcon (ament_python) or pip."""

import re
from pathlib import Path

from setuptools import find_packages, setup

NAME = "mansion_planner"

setup(
    name=NAME,
    version=re.findall("<version>(.+)</version>", Path("package.xml").read_text(encoding="utf-8"))[0],
    description="From a sentence to a building program, room graphs and floor layouts.",
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
        "mansion_assets",
        "mansion_geometry",
        "mansion_knowledge",
        "mansion_language",
        "mansion_llm",
        "mansion_msgs_py",
        "msgspec>=0.19",
        "networkx>=2.8",
        "numba>=0.59",
        "numpy>=1.26",
        "shapely>=2.0",
    ],
    extras_require={"dxf": ["ezdxf>=1.1"], "ifc": ["ifcopenshell>=0.8"], "test": ["pytest"]},
    entry_points={
        "console_scripts": [
            "program_planner = mansion_planner.nodes.program_planner:main",
            "floor_solver = mansion_planner.nodes.floor_solver:main",
        ]
    },
)
