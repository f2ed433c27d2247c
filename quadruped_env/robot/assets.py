"""Model files, and the model compiled from them."""

import copy
import functools
import importlib.util
from pathlib import Path

import mujoco

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.motors import MotorConfig

ASSETS = ("mini_quadruped.urdf", "mini_quadruped.xml", "scene.xml")
MAPS = ("dyna1.toml",)


@functools.cache
def _asset_directory() -> Path:
    """Directory of the assets: inside an installed package, or next to it in a checkout."""
    # An editable install maps the package `quadruped_env.assets` to the checkout's folder, and a wheel holds a
    # copy inside the package: find_spec finds both. A checkout on sys.path has only the folder.
    spec = importlib.util.find_spec("quadruped_env.assets")
    if spec is not None and spec.submodule_search_locations:
        return Path(next(iter(spec.submodule_search_locations)))
    return Path(__file__).parents[2] / "assets"


def asset_path(name: str) -> Path:
    """Path of a file of the robot (URDF, MJCF, MJCF scene), or of a map for recordings.

    Raises:
        QuadrupedError: if there is no such asset.
    """
    if name not in (*ASSETS, *MAPS):
        raise QuadrupedError(f"asset_path: unknown asset {name!r}; valid names are {', '.join([*ASSETS, *MAPS])}")
    return _asset_directory() / ("maps" if name in MAPS else "mini_quadruped") / name


def load_model(timestep: float | None = None, motors: MotorConfig | None = None) -> mujoco.MjModel:
    """Compiled model of the robot on flat ground; every call returns a new copy.

    Args:
        timestep: physics time step, s. None: that of the model file.
        motors: motors that replace those of the model file.
    """
    files = tuple(asset_path(name) for name in ("scene.xml", "mini_quadruped.xml"))
    # Compiling takes thirty times as long as copying, so every process compiles each variant once.
    return copy.copy(_compiled(timestep, motors, files, tuple(file.stat().st_mtime_ns for file in files)))


@functools.lru_cache(maxsize=8)
def _compiled(
    timestep: float | None, motors: MotorConfig | None, files: tuple[Path, ...], _modified: tuple[int, ...]
) -> mujoco.MjModel:
    spec = mujoco.MjSpec.from_file(str(files[0]))
    if timestep is not None:
        spec.option.timestep = timestep
    if motors is not None and motors != MotorConfig():
        motors.write(spec)
    return spec.compile()
