"""Rendering of the robot, offscreen or in a window."""

import ctypes.util
import functools
import importlib
import os
import sys
import threading
import warnings
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError

NO_OPENGL: Final = (
    "no OpenGL to render with: install a software renderer (Debian and Ubuntu: 'apt-get install libegl1 "
    "libgl1-mesa-dri', or 'libosmesa6'), or set MUJOCO_GL to a backend that works here, such as 'egl' without a display"
)
_CAMERA: Final = "track"
_PROBE_SIZE: Final = 8
"""Width and height of an image that any working OpenGL can render, pixels."""
_OFF: Final = ("disable", "disabled", "off", "false", "0")
"""Values of MUJOCO_GL that disable rendering in MuJoCo."""
_WITHOUT_DISPLAY: Final = ("egl", "osmesa")
"""Values of MUJOCO_GL for which no display is needed."""
_WRONG_VARIABLE: Final = (
    "an environment variable keeps OpenGL from starting; change or unset it (MUJOCO_GL: 'egl', 'osmesa' or 'glfw')"
)
_PROBING: Final = threading.Lock()


class SceneRenderer:
    """Renders one model in the mode `rgb_array`, in images of a size in pixels, or shows its data in a window: `human`.

    The model's offscreen buffer is enlarged to the size of the images if necessary.

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


def has_display() -> bool:
    """True if a window could be opened."""
    return not sys.platform.startswith("linux") or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def choose_opengl() -> bool:
    """Set MUJOCO_GL to a backend that renders without a display; False if none is installed."""
    for backend, library in (("egl", "EGL"), ("osmesa", "OSMesa")):
        if ctypes.util.find_library(library):
            os.environ["MUJOCO_GL"] = backend
            return True
    return False


@functools.cache
def opengl_failure() -> str:
    """Why OpenGL cannot render in this process, with the fix; empty if it can.

    Tried once, before any other image: a `mujoco.Renderer` after a failed one can abort the process.
    """
    chosen = os.environ.get("MUJOCO_GL", "").lower().strip()
    if chosen in _OFF:
        return f"rendering is switched off: MUJOCO_GL is {chosen!r}; unset it"
    if chosen not in _WITHOUT_DISPLAY and not has_display():
        if chosen in ("glfw", "glx"):
            return f"MUJOCO_GL is {chosen!r}, which needs a display, and there is none; unset it, or set it to 'egl'"
        if not choose_opengl():
            return NO_OPENGL
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            # MuJoCo has read MUJOCO_GL when it was imported.
            importlib.reload(sys.modules[mujoco.Renderer.__module__].gl_context)
            mujoco.Renderer(mujoco.MjModel.from_xml_string("<mujoco/>"), _PROBE_SIZE, _PROBE_SIZE).close()
            return ""
        except Exception as failure:  # backends raise various errors, even AttributeError for a missing library
            error = failure
    reasons = "; ".join(dict.fromkeys([*(str(entry.message) for entry in caught), f"{type(error).__name__}: {error}"]))
    cause = _WRONG_VARIABLE if "environment variable" in reasons else NO_OPENGL
    return f"{cause} ({reasons})"


def _make_renderer(model: mujoco.MjModel, width: int, height: int) -> mujoco.Renderer:
    with _PROBING:
        failure = opengl_failure()
    if failure:
        raise QuadrupedError(failure)
    buffer = model.vis.global_
    before = buffer.offwidth, buffer.offheight
    buffer.offwidth, buffer.offheight = max(before[0], width), max(before[1], height)
    try:
        return mujoco.Renderer(model, height, width)
    except Exception as error:  # as above
        buffer.offwidth, buffer.offheight = before
        raise QuadrupedError(
            f"OpenGL works here, but not for images of {width} x {height} pixels; use a smaller width or height "
            f"({type(error).__name__}: {error})"
        ) from error


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
