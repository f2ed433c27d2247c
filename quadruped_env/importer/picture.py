"""Picture of a robot in its stance."""

import struct
import zlib
from pathlib import Path
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs.rendering import SceneRenderer
from quadruped_env.robot import Robot
from quadruped_env.simulation.model import scene
from quadruped_env.utils.files import write_whole

_WIDTH, _HEIGHT = 640, 480
_AZIMUTH: Final = 135.0
"""Direction of the camera, from the front left, degrees."""
_LIGHT: Final = (0.0, 0.02, -1.0)
"""Direction of the light, not quite vertical: level faces under a vertical light have specks of shadow."""


def write_picture(robot: Robot, path: Path) -> None:
    """Write a PNG of the robot in its stance.

    Raises:
        QuadrupedError: if OpenGL cannot draw, or the file cannot be written.
    """
    model = scene(robot).compile()
    model.light_dir0[:] = _LIGHT
    data = mujoco.MjData(model)
    data.qpos[:7] = robot.skeleton.resting_pose(robot.stance)
    data.qpos[7 : robot.num_positions] = robot.stance
    mujoco.mj_forward(model, data)
    camera = mujoco.MjvCamera()
    camera.azimuth, camera.elevation = _AZIMUTH, -18.0
    camera.lookat[:] = [*data.qpos[:2], 0.55 * robot.stance_height]
    camera.distance = 3.2 * max(robot.stance_height, robot.footprint)
    renderer = SceneRenderer(model, data, "rgb_array", _WIDTH, _HEIGHT)
    try:
        image = renderer.render(data, camera)
    finally:
        renderer.close()
    assert image is not None
    write_whole({path: png(image)})


def png(image: NDArray[np.uint8]) -> bytes:
    """Return an image (height, width, 3) as PNG."""
    height, width, _ = image.shape
    rows = b"".join(b"\0" + row.tobytes() for row in image)

    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
