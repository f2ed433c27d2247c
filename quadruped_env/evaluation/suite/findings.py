"""The suite's results in words: envelope, changing commands, gait and robustness."""

from collections.abc import Mapping
from typing import Any, Final

from quadruped_env.evaluation.comparison import words

CLEAN_CLEARANCE: Final = 0.008
"""Clearance of the lowest foot from which the verdict calls a gait clean, m."""
CLEAN_BOUNCES: Final = 0.1
"""Bounces per stride up to which the verdict calls a gait clean."""
STURDY: Final = (0.7, 0.8, 0.02)
"""Least share of pushes after which a robust policy does what was asked, least share of episodes that keep their speed
with one disturbance, and largest share of falls with all disturbances."""
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
        ("Joystick", _joystick(result)),
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
    largest = commands["envelope"]
    sizes = {
        "m/s forwards": largest["forwards"],
        "m/s backwards": largest["backwards"],
        "rad/s in place": min(largest["left"], largest["right"]),
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


def _joystick(result: Mapping[str, Any]) -> str:
    return f"{'; '.join(f'{name} {_falls(law)}' for name, law in result['joystick'].items())}."


def _falls(law: Mapping[str, Any]) -> str:
    rate = law["falls_per_hour"]
    if rate["mean"] is None:
        return "it falls at once"
    return (
        f"{rate['mean']:.1f} falls per hour of changing commands (95 % interval {rate['low']:.1f} to "
        f"{rate['high']:.1f}), {100.0 * law['windows_met']['mean']:.0f} % of the time close to the command"
    )


def _gait(gait: Mapping[str, Any]) -> str:
    steps = [entry for entry in gait["commands"] if None not in entry["landing_speed"] + entry["clearance"]]
    missing = len(gait["commands"]) - len(steps)
    if not steps:
        return "it does not step at any command."
    low = min(steps, key=lambda entry: min(entry["clearance"]))
    worst = max(steps, key=lambda entry: max(entry["bounces_per_stride"]))
    hard = max(steps, key=lambda entry: max(entry["landing_speed"]))
    fast = max(steps, key=lambda entry: entry["speed_limit_share"])
    clearance, bounces = min(low["clearance"]), max(worst["bounces_per_stride"])
    clean = clearance >= CLEAN_CLEARANCE and bounces <= CLEAN_BOUNCES and not missing
    text = (
        f"{'clean' if clean else 'not clean'}: the lowest foot clears the ground by {1000.0 * clearance:.0f} mm "
        f"({words(low['command'])}), a foot bounces up to {bounces:.1f} times per stride ({words(worst['command'])}), "
        f"and lands at up to {max(hard['landing_speed']):.2f} m/s ({words(hard['command'])})"
    )
    if fast["speed_limit_share"] >= 0.01:
        text += f"; some joint is at its speed limit {100.0 * fast['speed_limit_share']:.0f} % of the time"
        text += f" ({words(fast['command'])})"
    return f"{text}{f'; it does not step at {missing} of the commands' if missing else ''}."


def _robustness(result: Mapping[str, Any]) -> str:
    pushes, regulation = result["pushes"], result["regulation"]
    horizontal, part = pushes["horizontal"], result["definition"]["regulation"]
    halves = list(zip(horizontal["directions"], horizontal["half_survival"], strict=True))
    direction, half = min(halves, key=lambda pair: pair[1]["mean"])
    together = regulation[part["together"]["name"]]
    alone = [regulation[factor["name"]]["kept"]["mean"] for factor in part["factors"]]
    obeyed, kept, falls = pushes["obeyed"]["mean"], sum(alone) / len(alone), together["falls"]["mean"]
    least_obeyed, least_kept, most_falls = STURDY
    robust = obeyed >= least_obeyed and kept >= least_kept and falls <= most_falls
    over = "over " if half["censored"] else ""
    return (
        f"{'robust' if robust else 'not robust'}: it does what was asked after {100.0 * obeyed:.0f} % of the pushes; "
        f"half of the robots survive one of {over}{half['mean']:.2f} m/s {direction_in_words(direction)}, the weakest "
        f"direction; it keeps its speed in {100.0 * kept:.0f} % of the episodes with one disturbance, and falls in "
        f"{100.0 * falls:.0f} % with all of `{part['together']['name']}`."
    )


def _terrain(result: Mapping[str, Any]) -> str:
    levels = result["definition"]["terrain"]["levels"]
    kinds = ", ".join(f"{kind} {entry['highest_level']}" for kind, entry in result["terrain"].items())
    return f"highest level passed, of {levels}: {kinds}."


def _score(result: Mapping[str, Any]) -> str:
    suite = result["suite"]
    quick = " (quick, not comparable)" if suite["quick"] else ""
    zero = result.get("zero_action")
    against = f"; its zero action {zero['score']['total']:.3f}" if zero else ""
    return f"{result['score']['total']:.3f} of 1 in {suite['name']} {suite['version']}{quick}{against}."
