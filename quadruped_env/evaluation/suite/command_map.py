"""The map of achieved over commanded velocities on the whole rectangle of commands, with its dead zones."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.confidence import mean_of, number, proportion
from quadruped_env.evaluation.suite.measured_controller import MeasuredController, mean_velocities
from quadruped_env.evaluation.suite.suite_definition import CommandMap
from quadruped_env.utils.progress import Progress

Floats = NDArray[np.float64]


def run(part: CommandMap, measured: MeasuredController, progress: Progress | None = None) -> dict[str, Any]:
    """The map and its summary, as plain values. Arrays have the shape (forward velocities V, yaw rates W)."""
    rollout = measured.run(part.commands, part.seeds, part.seconds, progress)
    shape = len(part.forward_velocity), len(part.yaw_rate), part.num_seeds
    achieved = mean_velocities(rollout).reshape(*shape, 2)
    fallen = rollout.fallen.reshape(shape)
    return {
        "forward_velocity": list(part.forward_velocity),
        "yaw_rate": list(part.yaw_rate),
        "fall_share": fallen.mean(axis=-1).tolist(),
        **summary(part, achieved, fallen),
    }


def summary(part: CommandMap, achieved: Floats, fallen: NDArray[np.bool_]) -> dict[str, Any]:
    """Map, errors, share of met commands and dead zones of S episodes per command.

    `achieved` are the mean velocities of each episode (V, W, S, 2), NaN if unknown; `fallen` is True for episodes that
    fell (V, W, S).
    """
    error = achieved - np.array(part.commands).reshape(len(part.forward_velocity), len(part.yaw_rate), 1, 2)
    # A comparison with NaN is false: an episode without a mean velocity does not meet its command.
    met = (np.abs(error) <= part.tolerance).all(axis=-1) & ~fallen
    result: dict[str, Any] = {"met": proportion(met).to_dict(), "falls": proportion(fallen).to_dict()}
    for column, name in enumerate(("forward_velocity", "yaw_rate")):
        signed = np.array([[mean_of(episodes) for episodes in line] for line in error[..., column]], dtype=np.float64)
        known = np.abs(signed[np.isfinite(signed)])
        result[f"{name}_error"] = {
            "signed": [[number(value) for value in line] for line in signed.tolist()],
            "mean": number(float(known.mean())) if known.size else None,
            "largest": number(float(known.max())) if known.size else None,
        }
    means = np.array([[mean_of(episodes) for episodes in line] for line in achieved], dtype=np.float64)
    return {**result, "dead_zone": dead_zones(part, means)}


def dead_zones(part: CommandMap, achieved: Floats) -> dict[str, float | None]:
    """Dead zone of each direction: forwards and backwards in m/s, left and right in rad/s.

    The largest command on the half axis, with the other velocity 0, of which less than `dead_share` is reached; 0 if
    there is none, None if the map has no command on the half axis. NaN among the mean velocities (V, W, 2) counts as
    not reached.
    """
    forward, turning = np.array(part.forward_velocity), np.array(part.yaw_rate)
    zones: dict[str, float | None] = {}
    for name, sign, size, reached in _half_axes(forward, turning, achieved[..., 0], achieved[..., 1]):
        dead = size[~(sign * reached >= part.dead_share * size)]
        zones[name] = float(dead.max(initial=0.0)) if len(size) else None
    return zones


def _half_axes(
    forward: Floats, turning: Floats, of_forward: NDArray[Any], of_turning: NDArray[Any]
) -> Iterator[tuple[str, float, Floats, NDArray[Any]]]:
    """Name and sign of each direction, sizes of its commands with the other velocity 0, and the values (V, W) there.

    Sizes and values are empty if the map has no command on the half axis.
    """
    for names, commands, on_axis in (
        (("forwards", "backwards"), forward, of_forward[:, turning == 0.0]),
        (("left", "right"), turning, of_turning[forward == 0.0].T),
    ):
        for name, sign in zip(names, (1.0, -1.0), strict=True):
            side = sign * commands > 0.0 if on_axis.shape[1] else np.zeros(len(commands), dtype=np.bool_)
            yield name, sign, sign * commands[side], on_axis[side, :1].ravel()


def envelope(result: Mapping[str, Any], tolerance: Sequence[float]) -> dict[str, float | None]:
    """Largest command of each direction, with the other velocity 0, up to which every one is met, for `run`'s result.

    Forwards and backwards in m/s, left and right in rad/s: 0 if not even the smallest command is met, None if the map
    has none. The tolerance is in m/s and rad/s.
    """
    forward, turning = np.array(result["forward_velocity"]), np.array(result["yaw_rate"])
    met = np.array(result["fall_share"]) == 0.0
    for name, largest in zip(("forward_velocity_error", "yaw_rate_error"), tolerance, strict=True):
        # As in `summary`, an unknown velocity does not meet its command.
        met &= np.abs(np.array(result[name]["signed"], dtype=np.float64)) <= largest
    found: dict[str, float | None] = {}
    for name, _, size, kept in _half_axes(forward, turning, met, met):
        missed = size[~kept].min(initial=np.inf)
        found[name] = float(size[size < missed].max(initial=0.0)) if len(size) else None
    return found
