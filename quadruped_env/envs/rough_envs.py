"""The environments on rough terrain."""

from types import MappingProxyType
from typing import Any, Final

from quadruped_env.envs.single import MiniQuadrupedEnv
from quadruped_env.envs.vector import MiniQuadrupedVectorEnv

ROUGH_CONFIG: Final[dict[str, Any]] = {"terrain": {"name": "tiles", "curriculum": True}}
"""Changes to the default config of `MiniQuadrupedRough-v0`."""


class MiniQuadrupedRoughEnv(MiniQuadrupedEnv):
    """`MiniQuadrupedEnv` on tiles of seven kinds of terrain at ten levels, with a curriculum.

    The seed of an env gives the kind of its tiles and its first level, which the curriculum changes from episode to
    episode (docs/terrain.md). A reset with a seed begins again. `info` has also `terrain_kind`, the index of the kind,
    and `terrain_level`. The default config has the changes of `ROUGH_CONFIG`; the argument `config` may change them
    again, or name another terrain. All else is as in `MiniQuadrupedEnv`.
    """

    default_config = MappingProxyType(ROUGH_CONFIG)


class MiniQuadrupedRoughVectorEnv(MiniQuadrupedVectorEnv):
    """N copies of `MiniQuadrupedRoughEnv`; see `MiniQuadrupedVectorEnv`."""

    default_config = MappingProxyType(ROUGH_CONFIG)
