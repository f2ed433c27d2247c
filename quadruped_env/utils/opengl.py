"""Choice of MuJoCo's OpenGL backend on a machine without a display."""

import ctypes.util
import os
import sys
from importlib import import_module

import_errors: list[Exception] = []
"""Error of the OpenGL backend because of which MuJoCo was imported without one, if it was."""


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


def import_mujoco() -> None:
    """Import MuJoCo, without OpenGL if its backend cannot be imported: only rendering needs one."""
    chosen = os.environ.get("MUJOCO_GL")
    try:
        import_module("mujoco")
    except Exception as error:  # an unknown MUJOCO_GL, or a missing library, even as an AttributeError
        import_errors.append(error)
    else:
        return
    os.environ["MUJOCO_GL"] = "disable"
    try:
        import_module("mujoco")
    finally:
        os.environ.pop("MUJOCO_GL")
        if chosen is not None:
            os.environ["MUJOCO_GL"] = chosen
