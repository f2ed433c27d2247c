"""Pictures of the robot: off screen, or in a window."""

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env._opengl import has_display
from quadruped_env.errors import QuadrupedError

NO_OPENGL = (
    "no OpenGL to render with: install a software renderer (Debian and Ubuntu: 'apt-get install libegl1 "
    "libgl1-mesa-dri', or 'libosmesa6'), or set MUJOCO_GL to a backend that works here"
)
_CAMERA = "track"


class SceneRenderer:
    """Renders one model in one mode.

    Args:
        model: the scene.
        data: what a window in `human` mode shows.
        render_mode: `rgb_array` or `human`.
        width, height: of a picture, in pixels.

    Raises:
        QuadrupedError: if there is no OpenGL, or no display to open a window on.
    """

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, render_mode: str, width: int = 640, height: int = 480
    ) -> None:
        self._window = None
        self._renderer = None
        if render_mode == "human":
            if not has_display():
                # MuJoCo's window library ends the whole process here.
                raise QuadrupedError("render_mode 'human' needs a display, and there is none; use 'rgb_array'")
            from mujoco import viewer

            self._window = viewer.launch_passive(model, data, show_left_ui=False, show_right_ui=False)
        else:
            try:
                self._renderer = mujoco.Renderer(model, height, width)
            except Exception as error:
                # Every backend fails in its own way, down to AttributeError from a missing library.
                raise QuadrupedError(f"{NO_OPENGL} ({type(error).__name__}: {error})") from error

    def render(self, data: mujoco.MjData, camera: str | mujoco.MjvCamera = _CAMERA) -> NDArray[np.uint8] | None:
        """A picture (height, width, 3), or None where a window was updated; a window has a camera of its own."""
        if self._window is not None:
            self._window.sync()
            return None
        assert self._renderer is not None
        self._renderer.update_scene(data, camera=camera)
        return self._renderer.render()

    def close(self) -> None:
        """Close the window or free the OpenGL context."""
        if self._window is not None:
            self._window.close()
        if self._renderer is not None:
            self._renderer.close()
