"""Choice of MuJoCo's OpenGL backend on a machine without a display."""

import ctypes.util
import os
import sys


def has_display() -> bool:
    """True if a window could be opened."""
    return not sys.platform.startswith("linux") or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def choose_opengl() -> None:
    """Set MUJOCO_GL to a backend that renders without a display, if one is needed, installed and not chosen yet."""
    if "MUJOCO_GL" in os.environ or has_display():
        return
    for backend, library in (("egl", "EGL"), ("osmesa", "OSMesa")):
        if ctypes.util.find_library(library):
            os.environ["MUJOCO_GL"] = backend
            return
