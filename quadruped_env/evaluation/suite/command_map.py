"""The map of achieved over commanded velocities on the whole rectangle of commands, and the envelope."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.evaluation.confidence import mean_of, number, proportion
from quadruped_env.evaluation.measures import counted_samples, mean_velocities, meets, stands_still
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import CommandMap
from quadruped_env.utils.progress import Progress

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]


def run(part: CommandMap, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """The map, its summary and the envelope, as plain values; one entry per command."""
    drawn, on_axes = list(part.drawn), [command for axis in part.axes.values() for command in axis]
    rollout = measured.run([*drawn, *on_axes], part.seeds, part.seconds, progress)
    shape = len(drawn) + len(on_axes), part.num_seeds
    achieved = mean_velocities(rollout).reshape(*shape, 2)
    fallen = rollout.fallen.reshape(shape)
    still = stands_still(rollout, counted_samples(rollout)).reshape(shape)
    commands = np.array([*drawn, *on_axes])
    kept = meets(achieved, commands[:, None], still, fallen, part.tolerance)
    count = len(drawn)
    stand = np.array([not any(command) for command in drawn])
    return {
        "commands": [list(command) for command in drawn],
        "fall_share": fallen[:count].mean(axis=-1).tolist(),
        **summary(drawn, achieved[:count], fallen[:count], kept[:count]),
        "moving": proportion(kept[:count][~stand]).to_dict(),
        "standing": proportion(kept[:count][stand]).to_dict(),
        "envelope": envelope(part, kept[count:]),
    }


def summary(commands: ArrayLike, achieved: Floats, fallen: Mask, kept: Mask) -> dict[str, Any]:
    """Errors and shares of K commands, from mean velocities (K, S, 2), falls and what `meets` found (K, S)."""
    error = achieved - np.asarray(commands, dtype=np.float64)[:, None]
    result: dict[str, Any] = {"met": proportion(kept).to_dict(), "falls": proportion(fallen).to_dict()}
    for column, name in enumerate(("forward_velocity", "yaw_rate")):
        signed = np.array([mean_of(episodes) for episodes in error[..., column]], dtype=np.float64)
        known = np.abs(signed[np.isfinite(signed)])
        result[f"{name}_error"] = {
            "signed": [number(value) for value in signed.tolist()],
            "mean": number(float(known.mean())) if known.size else None,
            "largest": number(float(known.max())) if known.size else None,
        }
    return result


def envelope(part: CommandMap, kept: Mask) -> dict[str, float]:
    """Largest command of each direction alone up to which every episode meets its command; 0 if none does.

    Forwards and backwards in m/s, left and right in rad/s. `kept` is True for episodes that do (commands of all axes,
    S).
    """
    found, place = {}, 0
    for name, axis in part.axes.items():
        all_met = kept[place : place + len(axis)].all(axis=-1)
        reached = int(np.argmin(np.append(all_met, False)))
        found[name] = float(np.abs(axis[reached - 1]).max()) if reached else 0.0
        place += len(axis)
    return found
