"""Makes the policy that the package ships: a trained run's, with a card that says how it was made and how it walks."""

import argparse
import math
import shlex
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.measures import TILTED, counted_samples, measure
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.evaluation.verdict import verdict
from quadruped_env.policies import Controller, Policy, PolicyController, load_policy
from quadruped_env.policies.files import finished_directory, shipped_directory
from quadruped_env.report.pages.page import without_nan
from quadruped_env.training.run_directory import PROGRESS_FILE
from quadruped_env.utils.files import write_whole
from quadruped_env.utils.progress import Progress, part_of
from quadruped_env.utils.rotations import up_in_body

ACCEPTANCE_COMMANDS: Final = tuple((round(0.1 * i, 1), 0.0) for i in range(6))
"""Standing, and forwards up to 0.5 m/s."""
ACCEPTANCE_EPISODES: Final = 50
MAX_FALL_RATE: Final = 0.02
ACCEPTANCE_FRICTION: Final = (0.6, 1.0)
MAX_VELOCITY_ERROR: Final = 0.10
DISTURBED_COMMANDS: Final = ((0.3, 0.0), (0.5, 0.0), (-0.2, 0.0), (0.0, 0.5), (0.3, 0.5))
"""Forwards, backwards, turning in place and on a curve, in m/s and rad/s."""
DISTURBED_EPISODES: Final = 200
_SUMMARY: Final = (
    "fall_rate",
    "forward_velocity_error",
    "yaw_rate_error",
    "electrical_cost_of_transport",
    "mechanical_cost_of_transport",
)


def acceptance(policy: Policy, progress: Progress | None = None) -> dict[str, Any]:
    """Acceptance test of standing and walking forwards: falls, and the RMS error of 1 s means of velocity, m/s.

    Every policy stands and walks on level ground with friction from 0.6 to 1.0, whatever it was trained for.
    `accepted` is true for at most 2 % falls in episodes of 20 s and an error of at most 0.10 m/s at every command.
    """
    plain = policy.config.on_terrain("flat").randomized("none")
    rollout = roll_out(
        PolicyController(policy),
        ACCEPTANCE_COMMANDS,
        range(FIRST_SEED, FIRST_SEED + ACCEPTANCE_EPISODES),
        config=replace(plain, randomization=plain.randomization.replace(friction=ACCEPTANCE_FRICTION)),
        progress=progress,
    )
    errors = measure(rollout)["forward_velocity_error"].reshape(len(ACCEPTANCE_COMMANDS), ACCEPTANCE_EPISODES)
    by_command = np.sqrt(np.nanmean(errors**2, axis=1))
    falls = float(rollout.fallen.mean())
    return {
        "episodes": len(rollout.fallen),
        "fall_rate": falls,
        "forward_velocity_error": {
            f"{v:g} m/s": round(float(e), 4) for (v, _), e in zip(ACCEPTANCE_COMMANDS, by_command, strict=True)
        },
        "accepted": bool(falls <= MAX_FALL_RATE and (by_command <= MAX_VELOCITY_ERROR).all()),
    }


def disturbed(
    policy: Policy,
    episodes: int = DISTURBED_EPISODES,
    progress: Progress | None = None,
    controller: Controller | None = None,
) -> dict[str, Any]:
    """Falls in episodes of 20 s with the preset `hard`, which has a push of 0.75 m/s every 3 s.

    The share of time tilted by more than 0.3 rad tells a robot that walks on after a push from one that sits down.

    Args:
        policy: the policy.
        episodes: number of episodes of each of `DISTURBED_COMMANDS`.
        progress: called with the fraction done.
        controller: what acts in the policy's task; None: the policy.
    """
    rollout = roll_out(
        controller or PolicyController(policy),
        DISTURBED_COMMANDS,
        range(FIRST_SEED, FIRST_SEED + episodes),
        config=policy.config.on_terrain("flat").randomized("hard"),
        progress=progress,
    )
    by_command = rollout.fallen.reshape(len(DISTURBED_COMMANDS), episodes).mean(axis=1)
    tilted = up_in_body(rollout.orientation)[..., 2] < math.cos(TILTED)
    return {
        "preset": "hard",
        "episodes": len(rollout.fallen),
        "fall_rate": float(rollout.fallen.mean()),
        "fall_rate_by_command": {
            f"{v:g} m/s, {w:g} rad/s": round(float(share), 4)
            for (v, w), share in zip(DISTURBED_COMMANDS, by_command, strict=True)
        },
        "tilted_share": round(float(tilted[counted_samples(rollout)].mean()), 4),
    }


def without_output(command: str) -> str:
    """A command without the options `-o` and `--output`: a directory of this machine means nothing on another one."""
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("-o", "--output")
    return shlex.join(parser.parse_known_args(shlex.split(command))[1])


def without_suite(card: dict[str, Any]) -> dict[str, Any]:
    """Return a card as it is before the suite has run, in JSON's values."""
    return without_nan({name: value for name, value in card.items() if name != "suite"})


def note_suite(name: str, result: Mapping[str, Any]) -> None:
    """Put the suite's results on the card of a shipped policy: the main measures, and what they mean in words."""
    policy = load_policy(name)
    row = {field: value for field, value in reference_row(result).items() if field not in ("name", "conditions")}
    suite = {
        **row,
        "zero_action": result["zero_action"]["score"],
    }
    files = policy.with_card({**policy.card, "suite": suite}).files()
    write_whole({shipped_directory(name) / file: content for file, content in files.items()})


def ship(run: Path, name: str, progress: Progress | None = None) -> tuple[Path, dict[str, Any]]:
    """Copy a run's policy and learning curve into the package under a name, with its metrics on its card.

    Returns:
        Where it lies, and the card.
    """
    run = finished_directory(run)
    policy = load_policy(run)
    comparison = compare(policy, progress=part_of(progress, 0.0, 0.4))
    metrics = {
        motion: {m: round(comparison.estimate("policy", m, motion).mean, 4) for m in _SUMMARY}
        for motion in comparison.motions
    }
    card = {
        **policy.card,
        "command": without_output(policy.card["command"]),
        "metrics": {motion: {m: v for m, v in values.items() if np.isfinite(v)} for motion, values in metrics.items()},
        "acceptance": acceptance(policy, part_of(progress, 0.4, 0.6)),
        "disturbed": disturbed(policy, progress=part_of(progress, 0.6, 1.0)),
        "verdict": verdict(comparison).text(),
    }
    directory, curve = shipped_directory(name), run / PROGRESS_FILE
    files = policy.with_card(card).files()
    if curve.is_file():
        files = {PROGRESS_FILE: curve.read_bytes(), **files}
    write_whole({directory / file: content for file, content in files.items()})
    if not curve.is_file():
        # The curve of the policy that was here before is not this one's.
        (directory / PROGRESS_FILE).unlink(missing_ok=True)
    return directory, card


def reference_row(result: Mapping[str, Any]) -> dict[str, Any]:
    """Return the part of a controller's results that ships: what identifies them, the score, and the main measures."""
    return {
        **{field: result[field] for field in ("suite", "seed", "conditions", "name", "score")},
        **{field: result["commands"][field] for field in ("met", "met_closely")},
        "envelope": result["commands"]["envelope"],
        "falls_per_hour": {name: law["falls_per_hour"] for name, law in result["joystick"]["laws"].items()},
        "terrain": {kind: entry["highest_level"] for kind, entry in result["terrain"]["kinds"].items()},
    }
