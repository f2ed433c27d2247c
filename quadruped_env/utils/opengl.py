"""Import of MuJoCo: its OpenGL backend on a machine without a display, and where its warnings go."""

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
    """Import MuJoCo, without OpenGL if its backend cannot be imported: only rendering needs one.

    It then prints its warnings, from whichever thread, and writes no MUJOCO_LOG.TXT into the working directory, unless
    the process has chosen a file of another name.
    """
    choose_opengl()
    chosen = os.environ.get("MUJOCO_GL")
    try:
        mujoco = import_module("mujoco")
    except Exception as error:  # an unknown MUJOCO_GL, or a missing library, even as an AttributeError
        import_errors.append(error)
        os.environ["MUJOCO_GL"] = "disable"
        try:
            mujoco = import_module("mujoco")
        finally:
            os.environ.pop("MUJOCO_GL")
            if chosen is not None:
                os.environ["MUJOCO_GL"] = chosen
    config = mujoco.MjLogConfig.get()
    if config.logto_file and config.logfile == "MUJOCO_LOG.TXT":
        config.logto_file = False
        config.set()
