"""Build mansion_scene with colcon (ament_python) or pip."""

import re
from pathlib import Path

from setuptools import find_packages, setup

NAME = "mansion_scene"

setup(
    name=NAME,
    version=re.findall("<version>(.+)</version>", Path("package.xml").read_text(encoding="utf-8"))[0],
    description="Structure, openings, furniture, decoration and light: from floor layouts to furnished scenes.",
    author="Mansion maintainers",
    maintainer="Mansion maintainers",
    maintainer_email="maintainers@mansion.example",
    license="Apache-2.0",
    python_requires=">=3.11,<3.14",
    packages=find_packages(include=[NAME, f"{NAME}.*"]),
    package_data={"": ["py.typed", "**/NOTICE", "**/data/**", "**/*.json", "**/*.rviz"]},
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
    ],
    zip_safe=False,
    install_requires=[
        "mansion_assets",
        "mansion_geometry",
        "mansion_knowledge",
        "mansion_llm",
        "mansion_msgs_py",
        "matplotlib>=3.6",
        "msgspec>=0.19",
        "numpy>=1.26",
        "shapely>=2.0",
    ],
    extras_require={"test": ["pytest"]},
    entry_points={"console_scripts": ["object_placer = mansion_scene.nodes.object_placer:main"]},
)
