"""Draw a floor's model into arrays; all of it is called in the thread that owns the OpenGL context."""

from dataclasses import dataclass
from math import cos, radians, sin
from typing import Any

import numpy as np

from mansion_skills.vision.floor_model import FloorModel
from mansion_skills.vision.frame import NOTHING, Depth, Intrinsics, Labels, Picture

__all__ = ["CameraPose", "Parts", "Renderer"]

MAX_GEOMS = 20_000

RANGE = 150.0
"""Metres; what is farther away has no depth."""


@dataclass(frozen=True)
class CameraPose:
    """Position and direction of a camera: metres in the floor's frame, degrees; up is positive."""

    x: float
    y: float
    z: float
    yaw: float
    pitch: float = 0.0


@dataclass(frozen=True)
class Parts:
    """Which of its three pictures a frame has."""

    rgb: bool = True
    depth: bool = True
    segmentation: bool = True


class Renderer:
    """MuJoCo's buffers for one floor.

    Parameters
    ----------
    floor : FloorModel
    width, height : int
        Size of the largest picture, pixels.
    """

    def __init__(self, floor: FloorModel, width: int, height: int) -> None:
        import mujoco

        self._mj: Any = mujoco
        self._floor = floor
        model = floor.model
        model.vis.global_.offwidth = width
        model.vis.global_.offheight = height
        self._scene: Any = mujoco.MjvScene(model, maxgeom=min(MAX_GEOMS, model.ngeom + 100))
        self._context: Any = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, self._context)
        self._option: Any = mujoco.MjvOption()
        self._camera: Any = mujoco.MjvCamera()
        self._camera.type = mujoco.mjtCamera.mjCAMERA_FREE
        for flag in (mujoco.mjtRndFlag.mjRND_SHADOW, mujoco.mjtRndFlag.mjRND_REFLECTION):
            self._scene.flags[flag] = False

    def close(self) -> None:
        """Free what the pictures are drawn into."""
        self._context.free()

    def draw(
        self, eye: CameraPose, intrinsics: Intrinsics, geoms: "np.ndarray[Any, Any]", parts: Parts
    ) -> tuple[Picture, Depth, Labels]:
        """Draw what `FloorModel.show` has chosen.

        Parameters
        ----------
        geoms : array of int
            The geoms that are drawn, ascending.

        Returns
        -------
        tuple of arrays
            RGB, depth and labels; empty ones for the parts that are not wanted.
        """
        mj, height, width = self._mj, intrinsics.height, intrinsics.width
        self._look(eye, intrinsics)
        # Another floor's renderer may have drawn since, into a buffer of its own.
        mj.mjr_setBuffer(mj.mjtFramebuffer.mjFB_OFFSCREEN.value, self._context)
        rect = mj.MjrRect(0, 0, width, height)
        rgb = np.empty((height, width, 3) if parts.rgb else (0, 0, 3), dtype=np.uint8)
        window = np.empty((height, width) if parts.depth else (0, 0), dtype=np.float32)
        depth_at = window if parts.depth else None
        if parts.rgb or not parts.segmentation:
            mj.mjr_render(rect, self._scene, self._context)
            mj.mjr_readPixels(rgb if parts.rgb else None, depth_at, rect, self._context)
            depth_at = None
        labels = np.empty((0, 0), dtype=np.int32)
        if parts.segmentation:
            labels = self._labels(rect, geoms, depth_at)
        depth = self._metres(window)
        return np.ascontiguousarray(rgb[::-1]), depth, labels

    def _look(self, eye: CameraPose, intrinsics: Intrinsics) -> None:
        """Fill MuJoCo's scene for a free camera one metre behind what it looks at."""
        mj, floor = self._mj, self._floor
        yaw, pitch = radians(eye.yaw), radians(eye.pitch)
        ahead = (cos(yaw) * cos(pitch), sin(yaw) * cos(pitch), sin(pitch))
        self._camera.lookat[:] = [p + a for p, a in zip((eye.x, eye.y, eye.z), ahead)]
        self._camera.distance = 1.0
        self._camera.azimuth, self._camera.elevation = eye.yaw, eye.pitch
        floor.model.vis.global_.fovy = intrinsics.vertical_fov
        every = mj.mjtCatBit.mjCAT_ALL.value
        mj.mjv_updateScene(floor.model, floor.data, self._option, None, self._camera, every, self._scene)

    def _labels(self, rect: Any, geoms: "np.ndarray[Any, Any]", depth_at: Any) -> Labels:
        """Draw each geom in the colour of its number in the scene, and read back what it belongs to."""
        mj, flags = self._mj, self._scene.flags
        flags[mj.mjtRndFlag.mjRND_SEGMENT] = flags[mj.mjtRndFlag.mjRND_IDCOLOR] = True
        coded = np.empty((rect.height, rect.width, 3), dtype=np.uint8)
        mj.mjr_render(rect, self._scene, self._context)
        mj.mjr_readPixels(coded, depth_at, rect, self._context)
        flags[mj.mjtRndFlag.mjRND_SEGMENT] = flags[mj.mjtRndFlag.mjRND_IDCOLOR] = False
        number = coded[::-1].astype(np.int32) @ np.array([1, 256, 65536], dtype=np.int32)
        # The scene holds the chosen geoms in their order; 0 is the background.
        table = np.concatenate([[NOTHING], self._floor.label[geoms]]).astype(np.int32)
        labels: Labels = table[number]
        return labels

    def _metres(self, window: Depth) -> Depth:
        """Turn window depth (0 at the near plane, 1 at the far one) into metres along the optical axis."""
        model = self._floor.model
        near, far = model.vis.map.znear * model.stat.extent, model.vis.map.zfar * model.stat.extent
        flipped = window[::-1]
        with np.errstate(divide="ignore"):
            metres = near * far / (far - flipped * (far - near))
        # The sky is drawn as a box half as far as the far plane; that is not a distance.
        metres[metres > RANGE] = np.inf
        return np.ascontiguousarray(metres, dtype=np.float32)
