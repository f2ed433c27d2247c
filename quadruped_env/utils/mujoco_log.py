"""Destination of MuJoCo's warnings."""

import mujoco

_DEFAULT_FILE = "MUJOCO_LOG.TXT"


def log_to_console_only() -> None:
    """Let MuJoCo print its warnings, from whichever thread, but not write them to a file in the working directory.

    The setting holds for the whole process. One that differs from MuJoCo's default was chosen on purpose and is kept.
    """
    config = mujoco.MjLogConfig.get()
    if config.logto_file and config.logfile == _DEFAULT_FILE:
        config.logto_file = False
        config.set()
