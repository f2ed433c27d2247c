"""The suite's results in words: envelope, gait and robustness."""

from collections.abc import Mapping
from typing import Any, Final

from quadruped_env.evaluation.comparison import words
from quadruped_env.evaluation.suite.command_map import envelope

CLEAN_CLEARANCE: Final = 0.008
"""Clearance of the lowest foot from which the verdict calls a gait clean, m."""
CLEAN_TOUCHDOWNS: Final = 1.3
"""Touchdowns per stride up to which the verdict calls a gait clean."""
STURDY: Final = (0.7, 0.9, 0.02)
"""Least push that half of the robots survive in any direction, m/s, least share of episodes that hold their command
with one disturbance, and largest share of falls with all disturbances, of a robust policy."""
_SIDES: Final = {
    0: "forwards",
    45: "to the front left",
    90: "to the left",
    135: "to the rear left",
    180: "backwards",
    225: "to the rear right",
    270: "to the right",
    315: "to the front right",
}


def suite_findings(result: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Pairs of topic and sentence."""
    return [
        ("Envelope", _envelope(result)),
        ("Gait", _gait(result["gait"])),
        ("Robustness", _robustness(result)),
        ("Terrain", _terrain(result)),
        ("Score", _score(result)),
    ]


def direction_in_words(degrees: float) -> str:
    """Direction of a push in words."""
    return _SIDES.get(round(degrees), f"at {degrees:g} degrees")


def _envelope(result: Mapping[str, Any]) -> str:
    commands = result["commands"]
    largest = envelope(commands, result["definition"]["commands"]["tolerance"])
    in_place = [size for side in ("left", "right") if (size := largest[side]) is not None]
    sizes = {
        "m/s forwards": largest["forwards"],
        "m/s backwards": largest["backwards"],
        "rad/s in place": min(in_place, default=None),
    }
    share = f"it meets {100.0 * commands['met']['mean']:.0f} % of all commands"
    met = [f"{size:g} {way}" for way, size in sizes.items() if size]
    missed = [way.split(" ", 1)[1] for way, size in sizes.items() if size == 0.0]
    return (
        share
        + (f"; of those in one direction alone, all up to {', '.join(met)}" if met else "")
        + (f"; it misses the smallest one {' and '.join(missed)}" if missed else "")
        + "."
    )


def _gait(gait: Mapping[str, Any]) -> str:
    steps = [entry for entry in gait["commands"] if None not in entry["touchdowns_per_stride"] + entry["clearance"]]
    missing = len(gait["commands"]) - len(steps)
    if not steps:
        return "it does not step at any command."
    low = min(steps, key=lambda entry: min(entry["clearance"]))
    worst = max(steps, key=lambda entry: max(entry["touchdowns_per_stride"]))
    fast = max(steps, key=lambda entry: entry["speed_limit_share"])
    clearance, touchdowns = min(low["clearance"]), max(worst["touchdowns_per_stride"])
    clean = clearance >= CLEAN_CLEARANCE and touchdowns <= CLEAN_TOUCHDOWNS and not missing
    text = (
        f"{'clean' if clean else 'not clean'}: the lowest foot clears the ground by {1000.0 * clearance:.0f} mm "
        f"({words(low['command'])}), and a foot touches down up to {touchdowns:.1f} times per stride "
        f"({words(worst['command'])})"
    )
    if fast["speed_limit_share"] >= 0.01:
        text += f"; some joint is at its speed limit {100.0 * fast['speed_limit_share']:.0f} % of the time"
        text += f" ({words(fast['command'])})"
    return f"{text}{f'; it does not step at {missing} of the commands' if missing else ''}."


def _robustness(result: Mapping[str, Any]) -> str:
    pushes, disturbances = result["pushes"], result["disturbances"]
    halves = list(zip(pushes["directions"], pushes["half_survival"], strict=True))
    direction, half = min(halves, key=lambda pair: pair[1]["mean"])
    together = result["definition"]["disturbances"]["together"]["name"]
    alone = [entry["held"]["mean"] for name, entry in disturbances.items() if name not in ("nominal", together)]
    held, falls = sum(alone) / len(alone), disturbances[together]["falls"]["mean"]
    least, most_held, most_falls = STURDY
    robust = half["mean"] >= least and held >= most_held and falls <= most_falls
    recovered = [release["recovered"]["mean"] for release in result["recovery"].values()]
    over = "over " if half["censored"] else ""
    return (
        f"{'robust' if robust else 'not robust'}: half of the robots survive a push of {over}{half['mean']:.2f} m/s "
        f"{direction_in_words(direction)}, the weakest direction; it holds its command in {100.0 * held:.0f} % of the "
        f"episodes with one disturbance, and in {100.0 * disturbances[together]['held']['mean']:.0f} % with all of "
        f"`{together}`, where it falls in {100.0 * falls:.0f} %; it recovers from "
        f"{100.0 * sum(recovered) / len(recovered):.0f} % of drops and falls."
    )


def _terrain(result: Mapping[str, Any]) -> str:
    levels = result["definition"]["terrain"]["levels"]
    kinds = ", ".join(f"{kind} {entry['highest_level']}" for kind, entry in result["terrain"].items())
    return f"highest level passed, of {levels}: {kinds}."


def _score(result: Mapping[str, Any]) -> str:
    suite = result["suite"]
    quick = " (quick, not comparable)" if suite["quick"] else ""
    return f"{result['score']['total']:.3f} of 1 in {suite['name']} {suite['version']}{quick}."
