"""Time to decode a scene of 5 MB: ``python benchmarks/msgs/decode_scene.py [--megabytes 5]``."""

import argparse
import time

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.scene import FloorScene, SceneObject


def scene_of(size: int) -> bytes:
    """Return the JSON of a scene of at least `size` bytes."""
    square = [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)]
    scene = FloorScene(
        building_id="bench",
        floor=1,
        floors=1,
        label="G",
        elevation=0.0,
        height=3.2,
        outline=square,
        rooms=[],
        walls=[],
        doors=[],
    )
    while True:
        for _ in range(1000):
            number = len(scene.objects)
            scene.objects.append(
                SceneObject(
                    id=f"F1/open_office_1/office_chair_{number}",
                    room="F1/open_office_1",
                    category="office_chair",
                    asset="office_chair",
                    position=(number % 97 / 7.0, number % 89 / 3.0, 0.45),
                    rotation=90.0,
                    size=(0.6, 0.6, 0.9),
                    states={"open": False},
                )
            )
        data = encode_bytes(scene)
        if len(data) >= size:
            return data


def main() -> None:
    """Print the best of several decodings."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--megabytes", type=float, default=5.0)
    parser.add_argument("--repeat", type=int, default=10)
    options = parser.parse_args()
    data = scene_of(int(options.megabytes * 1e6))
    seconds = []
    for _ in range(options.repeat):
        start = time.perf_counter()
        decode(FloorScene, data)
        seconds.append(time.perf_counter() - start)
    print(f"{len(data) / 1e6:.2f} MB decoded in {min(seconds) * 1000:.1f} ms (best of {len(seconds)})")


if __name__ == "__main__":
    main()
