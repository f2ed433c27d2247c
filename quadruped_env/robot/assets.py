"""Files of the robot."""

import functools
import importlib.util
from pathlib import Path

from quadruped_env.errors import QuadrupedError

ASSETS = ("mini_quadruped.urdf", "mini_quadruped.xml", "scene.xml")
MAPS = ("dyna1.toml",)


@functools.cache
def _asset_directory() -> Path:
    """Return the directory of the assets: inside an installed package, or next to it in a checkout."""
    # An editable install maps the package `quadruped_env.assets` to the checkout's folder, and a wheel holds a
    # copy inside the package: find_spec finds both. A checkout on sys.path has only the folder.
    spec = importlib.util.find_spec("quadruped_env.assets")
    if spec is not None and spec.submodule_search_locations:
        return Path(next(iter(spec.submodule_search_locations)))
    return Path(__file__).parents[2] / "assets"


def asset_path(name: str) -> Path:
    """Return the path of a file of the robot (URDF, MJCF, MJCF scene), or of a map for recordings.

    Raises:
        QuadrupedError: if there is no such asset.
    """
    if name not in (*ASSETS, *MAPS):
        raise QuadrupedError(f"asset_path: unknown asset {name!r}; valid names are {', '.join([*ASSETS, *MAPS])}")
    return _asset_directory() / ("maps" if name in MAPS else "mini_quadruped") / name
