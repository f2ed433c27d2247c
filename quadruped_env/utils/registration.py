"""Ids of the environments for `gymnasium.make`, registered without an import of Gymnasium.

A robot's controller imports this package and needs no Gymnasium: it starts in two thirds of the time without.
"""

import importlib
import sys
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any, Final

ENV_ID: Final = "MiniQuadruped-v0"
ROUGH_ENV_ID: Final = "MiniQuadrupedRough-v0"
MAX_EPISODE_STEPS: Final = 1000
"""Number of control steps in `EPISODE_SECONDS` at 50 Hz."""


def register_envs() -> None:
    """Register the environments with Gymnasium: now if it is imported already, otherwise as soon as it is."""
    if "gymnasium" in sys.modules:
        # It waits for another thread that is still importing it.
        _register(importlib.import_module("gymnasium"))
    else:
        sys.meta_path.insert(0, _GymnasiumFinder())


def _register(gymnasium: Any) -> None:
    for env_id, single, vector in (
        (ENV_ID, "single:MiniQuadrupedEnv", "vector:MiniQuadrupedVectorEnv"),
        (ROUGH_ENV_ID, "single:MiniQuadrupedRoughEnv", "vector:MiniQuadrupedRoughVectorEnv"),
    ):
        if env_id not in gymnasium.registry:
            gymnasium.register(
                id=env_id,
                entry_point=f"quadruped_env.envs.{single}",
                vector_entry_point=f"quadruped_env.envs.{vector}",
                max_episode_steps=MAX_EPISODE_STEPS,
            )


class _GymnasiumFinder:
    """Finds Gymnasium as Python's other finders do, and lets its import end with the registration."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        if name != "gymnasium":
            return None
        finders = [finder for finder in sys.meta_path if finder is not self]
        spec = next((spec for finder in finders if (spec := finder.find_spec(name, path, target))), None)
        if spec is not None and spec.loader is not None:
            execute = spec.loader.exec_module

            def execute_and_register(module: ModuleType) -> None:
                execute(module)
                _register(module)

            spec.loader.exec_module = execute_and_register  # type: ignore[method-assign]
        return spec
