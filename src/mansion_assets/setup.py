"""Build mansion_assets with colcon (ament_python) or pip."""

import re
from pathlib import Path

from setuptools import find_packages, setup

NAME = "mansion_assets"

setup(
    name=NAME,
    version=re.findall("<version>(.+)</version>", Path("package.xml").read_text(encoding="utf-8"))[0],
    description="The catalogue of furniture and fittings, their meshes, and finding them by words.",
    author="Mansion maintainers",
    maintainer="Mansion maintainers",
    maintainer_email="maintainers@mansion.example",
    license="Apache-2.0",
    python_requires=">=3.11,<3.14",
    packages=find_packages(include=[NAME, f"{NAME}.*"]),
    package_data={"": ["py.typed", "**/NOTICE", "**/data/**", "**/*.json"]},
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
        "msgspec>=0.19",
        "numpy>=1.26",
        "pillow>=10.1",
        "trimesh>=4.0",
    ],
    extras_require={
        "test": ["pytest"],
        "convex": ["coacd>=1.0.5"],
        "embeddings": ["sentence-transformers>=3"],
        "vectors": ["wordllama>=0.3"],
    },
)
