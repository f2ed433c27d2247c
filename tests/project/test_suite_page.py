"""The page of the suite states the numbers of its definition."""

from paths import ROOT

from quadruped_env.evaluation.suite.suite import COMPONENTS
from quadruped_env.evaluation.suite.suite_definition import full_suite
from quadruped_env.utils.seeds import EVALUATION_SEEDS

TEXT = " ".join((ROOT / "docs" / "suite.md").read_text().split())


def test_page_states_commands_episodes_and_times():
    s = full_suite()
    tests = s.disturbances
    for words in (
        f"The seeds are {s.commands.first_seed:,} and up.",
        f"any seed from {EVALUATION_SEEDS.start:,} to {EVALUATION_SEEDS.stop - 1:,} is an error",
        f"{len(s.commands.commands)} commands, {s.commands.num_seeds} episodes of {s.commands.seconds:g} s each",
        f"{s.commands.tolerance[0]:g} m/s and {s.commands.tolerance[1]:g} rad/s",
        f"{len(s.gait.commands)} commands: ",
        f"{s.gait.num_seeds} episodes of {s.gait.seconds:g} s each",
        f"of a foot in the air of {s.gait.shortest_swing:g} s or more",
        f"over {100 * s.gait.speed_share:g} % of its velocity limit",
        f"{s.transients.num_seeds} episodes each: {s.transients.before:g} s with the first command, then "
        f"{s.transients.after:g} s with the second",
        f"the larger of {s.transients.band:g} \\|*D*\\| and {s.transients.narrowest[0]:g} m/s "
        f"({s.transients.narrowest[1]:g} rad/s)",
        f"The robot walks at {s.pushes.command[0]:g} m/s. After {s.pushes.before:g} s a velocity of "
        f"{s.pushes.sizes[0]:g}, {s.pushes.sizes[1]:g}, ... {s.pushes.sizes[-1]:.1f} m/s",
        f"in one of {len(s.pushes.directions)} directions",
        f"the episode goes on for {s.pushes.after:g} s. {s.pushes.num_seeds} episodes each",
        f"{tests.num_seeds} episodes of {tests.seconds:g} s per command; {tests.together_seeds} of "
        f"{tests.together_seconds:g} s with all together",
        f"{tests.tolerance[0]:g} m/s and {tests.tolerance[1]:g} rad/s",
        f"at levels 1 to {s.terrain.levels}",
        f"more than {0.5 * s.terrain.tile:g} m from the middle along x or y within {s.terrain.seconds:g} s",
        f"{s.terrain.num_seeds} crossings per kind and level. A level is passed with {100 * s.terrain.pass_share:g} %",
        f"lies for {s.recovery.limp_seconds:g} s",
        f"{s.recovery.num_seeds} robots per release",
        f"within {s.recovery.seconds:g} s begin a time of {s.recovery.walk_seconds:g} s",
    ):
        assert words in TEXT, words


def test_page_names_every_change_kind_release_and_component():
    s = full_suite()
    for change in s.transients.changes:
        velocities = [
            f"{v:g} m/s, {w:g} rad/s" if change.first[1] or change.then[1] else f"{v:g} m/s"
            for v, w in (change.first, change.then)
        ]
        assert f"| {change.name.replace('_', ' ')} | {velocities[0]} | {velocities[1]} |" in TEXT
    assert f"{', '.join(s.terrain.kinds[:-1])} and {s.terrain.kinds[-1]}" in TEXT
    for release in s.recovery.releases:
        name = release.name.replace("_", " ").replace("drop 30cm", "30 cm").replace("drop 10cm", "drop 10 cm")
        assert name in TEXT
        assert f"{release.height:g} m" in TEXT
    for component in COMPONENTS:
        assert f"| {component} |" in TEXT
    for name in ("clearance", "touchdowns per stride", "slip", "duty factor", "stride frequency", "change of torque"):
        assert f"| {name}" in TEXT
