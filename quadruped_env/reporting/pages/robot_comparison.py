"""The comparison of policies for different robots: each in its own robot's env and units, with a report of its own."""

import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final

from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.metrics import METRICS
from quadruped_env.evaluation.verdict import listed, verdict
from quadruped_env.reporting.pages import page
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.utils.files import write_json
from quadruped_env.utils.text_table import Table

NOTE: Final = (
    "Each policy ran with its own robot, under commands in its robot's units (docs/robots.md). "
    "Better: the intervals do not overlap when errors and speeds are divided by the robot's size."
)
_FACTS: Final[Mapping[str, Callable[[Robot], str]]] = {
    "robot": lambda robot: robot.name,
    "mass": lambda robot: f"{robot.total_mass:.3g} kg",
    "height of the stance": lambda robot: f"{robot.stance_height:.3g} m",
    "footprint": lambda robot: f"{robot.footprint:.3g} m",
    "legs, joints": lambda robot: f"{robot.num_legs}, {robot.num_joints}",
    "torque limit": lambda robot: f"{robot.effort_limit.max():g} N m",
    "joint speed limit": lambda robot: f"{robot.velocity_limit.max():g} rad/s",
}


def by_robot(policies: Mapping[str, EvaluatedPolicy]) -> list[dict[str, EvaluatedPolicy]]:
    """The policies in groups of one robot, in their order."""
    groups: dict[Robot, dict[str, EvaluatedPolicy]] = {}
    for name, evaluated in policies.items():
        groups.setdefault(evaluated.policy.config.robot, {})[name] = evaluated
    return list(groups.values())


def robot_tables(comparisons: Mapping[str, Comparison]) -> list[Table]:
    """Tables of the differences of the robots, and of the results; `comparisons` has that of each policy."""
    robots = {name: comparison.robot for name, comparison in comparisons.items()}
    facts = [(title, *(fact(robot) for robot in robots.values())) for title, fact in _FACTS.items()]
    differences = [row for row in facts if len(set(row[1:])) > 1]
    differences.append(("model, SHA-256", *(robot.sha256[:12] for robot in robots.values())))
    commands = {
        name: ", ".join(f"{comparison.commands[i][0]:g}" for i in comparison.conditions("forwards"))
        for name, comparison in comparisons.items()
    }
    differences.append(("commands forwards, m/s", *commands.values()))
    rows = []
    for title, metric, motion in page.SUMMARY:
        if all(comparison.conditions(motion) for comparison in comparisons.values()):
            estimates = {n: comparison.estimate(n, metric, motion) for n, comparison in comparisons.items()}
            cells = [_cell(metric, estimate) for estimate in estimates.values()]
            unit = f" ({METRICS[metric].unit})" if METRICS[metric].unit else ""
            rows.append((f"{title}{unit}", *cells, _better(metric, estimates, robots)))
    return [
        Table("The robots differ", ("", *robots), differences),
        Table("Results", ("", *robots, "better"), rows, NOTE),
    ]


def _cell(metric: str, estimate: Estimate) -> str:
    mean, low, high = (METRICS[metric].show(value) for value in (estimate.mean, estimate.low, estimate.high))
    return mean if low == "-" else f"{mean} [{low}, {high}]"


def _better(metric: str, estimates: Mapping[str, Estimate], robots: Mapping[str, Robot]) -> str:
    """Names of the policies that are not behind the best one, or a dash; less is better in each metric of the table."""
    scales = {name: scale_of(METRICS[metric].unit or "1", robot) for name, robot in robots.items()}
    lows = {name: estimate.low / scales[name] for name, estimate in estimates.items()}
    highs = {name: estimate.high / scales[name] for name, estimate in estimates.items()}
    if any(math.isnan(low) for low in lows.values()):
        return "-"
    best = [name for name, low in lows.items() if low <= min(highs.values())]
    return "no clear difference" if len(best) == len(lows) else listed(best)


def write_index_numbers(output: Path, comparisons: Mapping[str, Comparison], command_line: str) -> dict[str, Any]:
    """Write the numbers of all robots, and return their document."""
    document = {
        **page.provenance(command_line),
        "seeds": list(next(iter(comparisons.values())).seeds),
        "robots": {name: {**c.robot.identity, **c.seen_as(name).to_dict()} for name, c in comparisons.items()},
    }
    write_json(output / page.METRICS_FILE, document)
    return document


def write_index(
    output: Path, comparisons: Mapping[str, Comparison], reports: Mapping[str, Path], document: dict[str, Any]
) -> Path:
    """Write the page that holds the tables, and leads to the reports of the robots."""
    context = {
        "names": list(comparisons),
        "tables": robot_tables(comparisons),
        "verdicts": {name: verdict(comparison.seen_as(name)) for name, comparison in comparisons.items()},
        "reports": {name: report.relative_to(output).as_posix() for name, report in reports.items()},
    }
    return page.write_report_page(output, "robots.html", document, context)
