"""Build mansion_export with colcon (ament_python) or pip."""

import re
from pathlib import Path

from setuptools import find_packages, setup

NAME = "mansion_export"

setup(
    name=NAME,
    version=re.findall("<version>(.+)</version>", Path("package.xml").read_text(encoding="utf-8"))[0],
    description="Buildings in the formats of other programs, and as pictures and a page.",
    author="Mansion maintainers",
    maintainer="Mansion maintainers",
    maintainer_email="maintainers@mansion.example",
    license="Apache-2.0",
    python_requires=">=3.11,<3.14",
    packages=find_packages(include=[NAME, f"{NAME}.*"]),
    package_data={"": ["py.typed", "**/NOTICE", "**/data/**"]},
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
        "mansion_msgs_py",
        "mansion_scene",
        "msgspec>=0.19",
        "numpy>=1.26",
        "pillow>=10.1",
        "shapely>=2.0",
    ],
    extras_require={"test": ["pytest"], "ifc": ["ifcopenshell>=0.8"], "usd": ["usd-core>=24"]},
)
