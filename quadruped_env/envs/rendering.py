"""Rendering of the robot, offscreen or in a window."""

import os
import sys
import warnings
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env._opengl import has_display
from quadruped_env.errors import QuadrupedError

NO_OPENGL: Final = (
    "no OpenGL to render with: install a software renderer (Debian and Ubuntu: 'apt-get install libegl1 "
    "libgl1-mesa-dri', or 'libosmesa6'), or set MUJOCO_GL to a backend that works here"
)
_CAMERA: Final = "track"
_PROBE_SIZE: Final = 8
"""Width and height of an image that any working OpenGL can render, pixels."""
_OFF: Final = ("disable", "disabled", "off", "false", "0")
"""Values of MUJOCO_GL that disable rendering in MuJoCo."""
_SETTINGS: Final = ("PYOPENGL_PLATFORM", "MUJOCO_EGL_DEVICE_ID")
"""Environment variables that MuJoCo's error messages explain."""


class SceneRenderer:
    """Renders one model in one mode.

    Args:
        model: model of the scene; its offscreen buffer is enlarged to the size of the image if necessary.
        data: MuJoCo data that a window in `human` mode shows.
        render_mode: `rgb_array` or `human`.
        width, height: size of the image, pixels.

    Raises:
        QuadrupedError: if OpenGL is missing or cannot render an image of this size, or there is no display for a
            window; the message names the cause and the fix.
    """

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, render_mode: str, width: int = 640, height: int = 480
    ) -> None:
        self._window = None
        self._renderer = None
        if render_mode == "human":
            _check_display()
            from mujoco import viewer

            self._window = viewer.launch_passive(model, data, show_left_ui=False, show_right_ui=False)
        else:
            self._renderer = _make_renderer(model, width, height)

    def render(self, data: mujoco.MjData, camera: str | mujoco.MjvCamera = _CAMERA) -> NDArray[np.uint8] | None:
        """Image (height, width, 3), or None if a window was updated; the window controls its own camera."""
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


def _make_renderer(model: mujoco.MjModel, width: int, height: int) -> mujoco.Renderer:
    buffer = model.vis.global_
    before = buffer.offwidth, buffer.offheight
    buffer.offwidth, buffer.offheight = max(before[0], width), max(before[1], height)
    try:
        return mujoco.Renderer(model, height, width)
    except Exception as error:  # backends raise various errors, even AttributeError for a missing library
        buffer.offwidth, buffer.offheight = before
        raise QuadrupedError(f"{_cause(model, width, height, error)} ({type(error).__name__}: {error})") from error


def _cause(model: mujoco.MjModel, width: int, height: int, error: Exception) -> str:
    """Message with the cause of a rendering failure and the fix."""
    chosen = os.environ.get("MUJOCO_GL", "").lower().strip()
    if chosen in _OFF:
        return f"rendering is switched off: MUJOCO_GL is {chosen!r}; unset it"
    if any(name in str(error) for name in _SETTINGS):
        return "an environment variable keeps OpenGL from starting; change or unset it"
    try:
        mujoco.Renderer(model, _PROBE_SIZE, _PROBE_SIZE).close()
    except Exception:  # as above
        if chosen in ("glfw", "glx") and not has_display():
            return f"MUJOCO_GL is {chosen!r}, which needs a display, and there is none; unset it, or set it to 'egl'"
        return NO_OPENGL
    return f"OpenGL works here, but not for images of {width} x {height} pixels; use a smaller width or height"


def _check_display() -> None:
    """Raise a QuadrupedError if no window can be opened, because MuJoCo's window library would exit the process."""
    if not has_display():
        raise QuadrupedError("render_mode 'human' needs a display, and there is none; use 'rgb_array'")
    if sys.platform.startswith("linux"):
        import glfw

        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            opened = glfw.init()
        if not opened:
            named = ", ".join(
                f"{name}={os.environ[name]}" for name in ("DISPLAY", "WAYLAND_DISPLAY") if name in os.environ
            )
            reasons = "; ".join(str(entry.message) for entry in caught)
            raise QuadrupedError(
                f"render_mode 'human': no window can be opened on the display ({named}); start it, unset the variable, "
                f"or use 'rgb_array' ({reasons})"
            )
