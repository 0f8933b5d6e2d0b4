"""Build mansion_scene with colcon (ament_python) or pip."""

from setuptools import find_packages, setup

NAME = "mansion_scene"

setup(
    name=NAME,
    version="0.1.0",
    description="From floor layouts to furnished scenes: openings, objects, light, editing and export.",
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
        "mansion_geometry",
        "mansion_llm",
        "mansion_msgs_py",
        "matplotlib>=3.6",
        "msgspec>=0.19",
        "networkx>=2.8",
        "numba>=0.59",
        "numpy>=1.26",
        "pillow>=10",
        "shapely>=2.0",
        "trimesh>=4.0",
    ],
    extras_require={
        "test": ["pytest"],
        "usd": ["usd-core>=24"],
        "sim": ["mujoco>=3.0"],
        "thor": ["ai2thor>=5.0"],
        "embeddings": ["sentence-transformers>=3"],
    },
    entry_points={
        "console_scripts": [
            "object_placer = mansion_scene.nodes.object_placer:main",
            "scene_editor = mansion_scene.nodes.scene_editor:main",
        ],
    },
)
