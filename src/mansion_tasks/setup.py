"""Build mansion_tasks with colcon (ament_python) or pip."""

import re
from pathlib import Path

from setuptools import find_packages, setup

NAME = "mansion_tasks"

setup(
    name=NAME,
    version=re.findall("<version>(.+)</version>", Path("package.xml").read_text(encoding="utf-8"))[0],
    description="Tasks for a robot in a building, agents that do them, episodes and a Gymnasium environment.",
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
        "mansion_geometry",
        "mansion_language",
        "mansion_knowledge",
        "mansion_llm",
        "mansion_msgs_py",
        "mansion_skills",
        "msgspec>=0.19",
        "numpy>=1.26",
        "pillow>=10.1",
    ],
    extras_require={
        "test": ["pytest"],
        "llm": ["openai>=1.0"],
        "record": ["mcap>=1.1", "mcap-ros2-support>=0.5"],
        "sim": ["gymnasium>=1.0"],
    },
    entry_points={"gymnasium.envs": ["__root__ = mansion_tasks.env.registration:register_environments"]},
)
