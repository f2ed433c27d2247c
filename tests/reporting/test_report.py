import base64
import dataclasses
import itertools
import json
import math
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace
from xml.etree import ElementTree

import numpy as np
import pytest
from paths import ROOT
from tasks import ACTION_WIDTH, OBSERVATION_WIDTH

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env.evaluation import failures, subject
from quadruped_env.evaluation.comparison import (
    COMMANDS,
    CONTROLLERS,
    MOTIONS,
    Comparison,
    compare,
    compare_policies,
    motion_of,
)
from quadruped_env.evaluation.metrics import METRICS
from quadruped_env.evaluation.subject import find_subject
from quadruped_env.evaluation.verdict import reached_share, verdict
from quadruped_env.policies import Policy
from quadruped_env.reporting import plots, results
from quadruped_env.reporting.pages import evaluation_report, pictures, run_comparison
from quadruped_env.reporting.pages.evaluation_report import write_report
from quadruped_env.reporting.pages.page import summary_table
from quadruped_env.task import ActionConfig, CommandConfig, TaskConfig

TINY = ((0.2, 0.0), (0.4, 0.0), (0.0, 0.0), (-0.2, 0.0), (0.0, 0.5))


def random_policy(mode, **config):
    rng = np.random.default_rng(0)
    widths = (OBSERVATION_WIDTH, 16, ACTION_WIDTH)
    weights = tuple(
        (0.3 * rng.normal(size=shape) / math.sqrt(shape[0])).astype(np.float32) for shape in itertools.pairwise(widths)
    )
    biases = tuple(np.zeros(width, np.float32) for width in widths[1:])
    card = {"command": "python train/ppo.py", "seed": 0, "best return": math.nan}
    return Policy(weights, biases, "tanh", TaskConfig(action=ActionConfig(mode=mode), **config), card)


@pytest.fixture(scope="module")
def run_directory(tmp_path_factory):
    directory = tmp_path_factory.mktemp("runs") / "20260101-000000-ppo"
    random_policy("residual").save(directory)
    curve = "timesteps,seconds,return,fall_rate,forward_velocity_error\n1000,1,nan,1.0,0.3\n2000,2,5.5,0.5,0.2\n3000,3"
    (directory / "progress.csv").write_text(curve)
    return directory


@pytest.fixture(scope="module")
def comparison():
    return compare(random_policy("residual"), num_seeds=2, seconds=3.0, commands=TINY)


@pytest.fixture(scope="module")
def written(run_directory, comparison):
    found = find_subject(str(run_directory))
    page, numbers, missing = write_report(found, comparison, "python evaluate/policy.py runs/<name>", with_video=False)
    assert not missing
    return page.read_text(), numbers.read_text()


SECTIONS = (
    "Following the command",
    "Velocity over time",
    "Gait: which feet are on the ground",
    "Cost of transport over speed",
    "Torque and speed against the motors' limits",
    "Joints over time",
    "Foot clearance and slip",
    "Reward terms",
    "Learning curve",
)


class Page(HTMLParser):
    """Collects the addresses, headings, tables and open tags of a page."""

    VOID = frozenset(("meta", "img", "br", "link"))

    def __init__(self, text):
        super().__init__()
        self.addresses, self.text, self.open, self.tags, self.policy = [], [], [], [], ""
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.addresses += [value for name, value in attrs if name in {"src", "href", "srcset", "action", "data"}]
        if dict(attrs).get("http-equiv") == "Content-Security-Policy":
            self.policy = dict(attrs)["content"]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data)


def test_report_holds_the_verdict_first_then_the_table_and_every_metric(written, comparison):
    page = Page(written[0])
    text = " ".join(" ".join(page.text).replace("\N{NO-BREAK SPACE}", " ").split())
    assert not page.open
    judged = verdict(comparison)
    places = [text.index(judged.headline), *(text.index(words[1:]) for _, words in judged.findings)]
    places += [
        text.index("In numbers"),
        text.index("Forwards: velocity error"),
        text.index("What was compared"),
        text.index("See it walk"),
        *map(text.index, SECTIONS),
        text.index("The worst episodes"),
        text.index("Every metric"),
        text.index("How this was made"),
    ]
    assert places == sorted(places)
    for name in CONTROLLERS.values():
        assert name in text
    for metric in METRICS.values():
        assert metric.label in text
        assert metric.meaning in text
    assert "python evaluate/policy.py runs/<name>" in text
    assert "20260101-000000-ppo" in text
    assert re.search(r"Seeds 1000000 to 1000001", text)
    assert "No video: it was switched off." in text
    assert '"physics_timestep"' in text


def test_report_needs_no_other_file(written):
    html = written[0]
    page = Page(html)
    assert page.addresses
    assert all(address.startswith("data:") for address in page.addresses)
    assert not {"script", "link"} & set(page.tags)
    assert page.policy.startswith("default-src 'none';")
    assert "http" not in page.policy
    # The replay in 3D is a page of its own, within the quotes of an attribute.
    without_replay = re.sub(r'srcdoc="[^"]*"', "", html)
    assert "@import" not in without_replay
    assert "url(" not in without_replay
    assert "http://" not in without_replay
    for address in page.addresses:
        svg = ElementTree.fromstring(base64.b64decode(address.partition("base64,")[2]))  # noqa: S314
        links = [value for e in svg.iter() for name, value in e.attrib.items() if name.endswith("href")]
        assert all(link.startswith(("#", "data:")) for link in links)
    assert len(html) < 4_000_000


def test_report_names_no_directory_of_the_machine(written, run_directory):
    html, numbers = written
    for document in (re.sub(r"base64,[^\"]*", "", html), numbers):
        assert str(run_directory.parent) not in document
        assert str(Path.home()) not in document


def test_metrics_are_strict_json_with_a_value_for_every_metric(written):
    def refuse(constant):
        raise AssertionError(f"{constant} is not JSON")

    document = json.loads(written[1], parse_constant=refuse)
    assert set(document["controllers"]) == set(CONTROLLERS)
    assert document["policy"]["card"]["best return"] is None
    assert document["seeds"] == [1_000_000, 1_000_001]
    for entry in document["controllers"].values():
        assert set(entry["all"]) == set(METRICS)
        assert set(entry["by_motion"]) == set(MOTIONS)
        assert len(entry["by_command"]) == len(document["commands"]) == len(TINY)
        for estimate in entry["all"].values():
            assert estimate["mean"] is None or estimate["low"] <= estimate["mean"] <= estimate["high"]
    assert document["controllers"]["zero"]["all"]["cost_of_transport"]["mean"] is None
    assert TaskConfig.from_dict(document["config"]).action.mode == "residual"


@pytest.fixture
def without_figures(monkeypatch):
    """Figures take most of a report's time."""
    monkeypatch.setattr(evaluation_report, "_figures", lambda *_: [])


def test_without_opengl_the_report_is_made_and_names_the_package(
    run_directory, comparison, tmp_path, monkeypatch, without_figures
):
    def broken(*args):
        raise AttributeError("no context")

    monkeypatch.setattr("mujoco.Renderer", broken)
    page, _, missing = write_report(find_subject(str(run_directory), tmp_path / "out"), comparison, "")
    html = page.read_text()
    assert len(missing) == 1
    assert missing[0].startswith("No video: no OpenGL")
    assert "No video: no OpenGL" in html
    assert "srcdoc=" in html
    assert "libegl1" in html
    assert "<video" not in html


def test_without_viser_the_report_is_made_and_names_the_extra(
    run_directory, comparison, tmp_path, monkeypatch, without_figures
):
    monkeypatch.setitem(sys.modules, "viser", None)
    page, _, missing = write_report(find_subject(str(run_directory), tmp_path), comparison, "", with_video=False)
    assert missing == ["No 3D replay: The 3D replay needs the 'viewer' extra: pip install 'mini-quadruped[viewer]'"]
    assert "<iframe" not in page.read_text()
    assert "script-src" not in page.read_text()


def test_table_has_a_row_for_every_motion(comparison):
    lines = summary_table(comparison).splitlines()
    assert [line.split(":")[0].split()[0] for line in lines[1:6]] == ["Falls", *(m.capitalize() for m in MOTIONS)]


# The verdict, on invented numbers.


def invented(velocity, fallen=(), yaw_rate=None, commands=COMMANDS, tuned_error=0.05):
    """A comparison whose policy reaches a share of every velocity and falls under the commands with these indices."""
    seeds = 3
    command = np.array(commands)
    empty = {name: np.full((len(commands), seeds), np.nan) for name in METRICS}

    def controller(share, turn, falls=(), error=None):
        reached = command * [share, turn]
        values = {name: value.copy() for name, value in empty.items()}
        values["forward_velocity"][:] = reached[:, :1]
        values["yaw_rate"][:] = reached[:, 1:]
        values["forward_velocity_error"][:] = np.abs(reached - command)[:, :1] if error is None else error
        values["yaw_rate_error"][:] = np.abs(reached - command)[:, 1:] if error is None else error
        values["distance"][:] = 20.0 * reached[:, :1]
        values["fall_rate"][:] = 0.0
        values["peak_torque"][:] = 6.0
        for i in falls:
            for name, value in values.items():
                value[i] = 1.0 if name == "fall_rate" else np.nan
        return values

    values = {
        "policy": controller(velocity, velocity if yaw_rate is None else yaw_rate, fallen),
        "tuned": controller(0.9, 0.9, error=tuned_error),
        "article": controller(0.0, 0.0),
        "zero": controller(0.0, 0.0),
    }
    return Comparison(tuple(commands), (1, 2, 3), 20.0, TaskConfig(), {}, values)


@pytest.mark.parametrize(
    ("numbers", "level", "headline"),
    [
        ({"velocity": 1.0}, "good", "at least as well as the tuned gait"),
        ({"velocity": 0.95, "tuned_error": 0.0}, "fair", "less accurate than the tuned gait forwards, backwards and"),
        ({"velocity": 1.0, "yaw_rate": 0.2}, "fair", "turns at 20 % of the commanded rate"),
        ({"velocity": 1.0, "fallen": [1, 3]}, "fair", "falls in 18 % of the episodes"),
        ({"velocity": 0.6}, "fair", "forward velocity error of 0.12 m/s"),
        ({"velocity": 0.4}, "poor", "Hardly: it reaches 40 %"),
        ({"velocity": 0.0}, "poor", "does not walk."),
        ({"velocity": -1.0, "fallen": [0, 6]}, "poor", "does not walk, and it falls."),
        ({"velocity": 1.0, "fallen": range(len(COMMANDS))}, "poor", "falls before"),
        ({"velocity": 1.0, "commands": [(0.0, 0.0)]}, "fair", "walking was not tested"),
    ],
)
def test_headline(numbers, level, headline):
    judged = verdict(invented(**numbers))
    assert judged.level == level
    assert headline in judged.headline
    assert "nan" not in judged.text().lower().split()


def test_findings_say_how_far_it_gets_and_where_it_falls():
    findings = dict(verdict(invented(0.9, fallen=[1])).findings)
    assert "travels 9.0 m in 20 s" in findings["Forwards"]
    assert findings["Falls"].startswith("3 in 33 episodes of 20 s, 9.1 % (95 % interval ")
    assert findings["Falls"].endswith("3 forwards.")
    assert "-0.18 m/s of the commanded -0.20 m/s" in findings["Backwards"]
    assert "reaches 90 % of the commanded yaw rate, the tuned gait 90 %" in findings["Turning"]
    assert "6.0 of 10 N m" in findings["Effort"]
    assert "more accurate forwards (0.032 against 0.050 m/s), standing" in findings["Tuned gait"]
    assert "more accurate forwards" in findings["Article's gait"]


def test_motions_that_were_not_commanded_are_not_judged():
    topics = [topic for topic, _ in verdict(invented(0.9, commands=[(0.3, 0.0)])).findings]
    assert topics == ["Falls", "Forwards", "Effort", "Tuned gait", "Article's gait"]


def test_reached_share_in_the_wrong_direction_is_negative():
    assert reached_share(invented(0.8), "policy", "backwards") == pytest.approx(0.8)
    assert reached_share(invented(-0.5), "policy", "backwards") == pytest.approx(-0.5)
    assert math.isnan(reached_share(invented(0.8, fallen=[6]), "policy", "backwards"))


def test_commands_are_classified_by_motion():
    assert [motion_of(c) for c in ((0.1, 0.0), (0.0, 0.0), (-0.1, 0.0), (0.0, 0.5), (0.3, -0.5))] == [
        "forwards", "standing", "backwards", "turning", "turning",
    ]  # fmt: skip


# The comparison.


def test_pairs_share_their_starts_and_differences_are_of_pairs(comparison):
    starts = [rollout.orientation[0] for rollout in comparison.rollouts.values()]
    for start in starts[1:]:
        np.testing.assert_allclose(start, starts[0], atol=0.1)
    by_hand = (comparison.values["policy"]["distance"] - comparison.values["zero"]["distance"]).mean()
    assert comparison.difference("distance", "policy", "zero").mean == pytest.approx(by_hand)


def test_policy_can_be_compared_on_commands_beyond_its_training():
    narrow = random_policy("position", command=CommandConfig(forward_velocity=(0.0, 0.1), yaw_rate=(0.0, 0.0)))
    done = compare(narrow, num_seeds=1, seconds=2.0, commands=[(0.5, -0.5)])
    assert done.config.command.forward_velocity == (0.0, 0.5)
    assert done.config.command.yaw_rate == (-0.5, 0.0)


@pytest.mark.parametrize("seconds", [1.0, math.nan, math.inf, -3.0])
def test_episodes_too_short_to_measure_are_refused(seconds):
    with pytest.raises(QuadrupedError, match=r"seconds: expected 2 to 600; found"):
        compare(random_policy("position"), 1, seconds)


def test_no_seed_is_refused():
    with pytest.raises(QuadrupedError, match="seeds: expected 1 or more; found -3"):
        compare(random_policy("position"), -3)


def test_shown_episode_is_the_first_without_a_fall():
    valid = np.ones((10, 6), dtype=bool)
    valid[4:, 0] = False
    valid[3:, 3:] = False
    valid[5, 4] = valid[4, 4] = valid[3, 4] = True
    rollout = SimpleNamespace(valid=valid)
    numbers = Comparison(((0.1, 0.0), (0.2, 0.0)), (0, 1, 2), 1.0, TaskConfig(), {"policy": rollout}, {})
    assert numbers.episode(0) == 1
    assert numbers.episode(1) == 4


# The learning curve.


def test_learning_curve_reads_what_a_killed_run_left(run_directory):
    curve = plots.read_progress(run_directory / "progress.csv")
    np.testing.assert_equal(curve["timesteps"], [1000.0, 2000.0, 3000.0])
    np.testing.assert_equal(curve["return"], [math.nan, 5.5, math.nan])


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "timesteps.*an empty file"),
        (b"steps,return\n1,2\n", "timesteps.*found steps, return"),
        (b"timesteps,return\n1,high\n", "'high'.*remove the file"),
        (b"timesteps\n\xff\xfe\n", "remove the file"),
    ],
)
def test_a_damaged_learning_curve_is_named(tmp_path, content, message):
    path = tmp_path / "progress.csv"
    path.write_bytes(content)
    with pytest.raises(QuadrupedError, match=message) as caught:
        plots.read_progress(path)
    assert str(path) in str(caught.value)


def test_learning_curves_of_several_runs_are_drawn_in_one_figure(run_directory):
    curve = plots.read_progress(run_directory / "progress.csv")
    svg = plots.learning_curve({"one": curve, "other": {**curve, "return": curve["return"] + 1.0}})
    assert svg.count("<svg ") == 1
    assert svg.count('id="legend_') == 1


# The worst episodes.


def with_falls(comparison, **falls):
    """The comparison, in which the policy falls in the given envs (r3 is the fourth) after the given samples."""
    policy = comparison.rollouts["policy"]
    valid = policy.valid.copy()
    for row, samples in falls.items():
        valid[samples:, int(row[1:])] = False
    fallen = dataclasses.replace(policy, valid=valid)
    return dataclasses.replace(comparison, rollouts={**comparison.rollouts, "policy": fallen})


def test_falls_are_the_worst_and_the_earliest_first(comparison):
    found = failures.worst_episodes(with_falls(comparison, r1=100, r4=50, r5=80))
    assert [failure.row for failure in found[:2]] == [4, 1]
    assert [failure.command for failure in found[:2]] == [TINY[2], TINY[0]]
    assert found[0].fell_at == pytest.approx(51 * 0.02)
    assert found[0].story.startswith("It fell at 1.0 s")
    assert found[2].fell_at is None


def test_without_falls_the_worst_has_the_largest_error(comparison):
    errors = comparison.values["policy"]
    tolerated = np.maximum(errors["forward_velocity_error"] / 0.1, errors["yaw_rate_error"] / 0.2)
    worst = failures.worst_episodes(with_falls(comparison))
    assert not any(math.isinf(failure.badness) for failure in worst)
    assert worst[0].badness == pytest.approx(np.nanmax(tolerated))
    assert worst[0].row == int(np.nanargmax(tolerated))
    assert "It stayed on its feet. Largest error: mean " in worst[0].story
    assert len({failure.command for failure in worst}) == len(worst) == failures.SHOWN


@pytest.mark.parametrize(
    ("axis", "angle", "words"),
    [
        ("x", -1.0, "over its left side, at 57° of tilt"),
        ("x", 1.0, "over its right side"),
        ("y", 1.0, "forwards, over its nose"),
        ("y", -1.0, "backwards, over its tail"),
        ("y", 0.1, "its trunk hit the ground while nearly level (6° of tilt)"),
    ],
)
def test_story_names_the_direction_of_a_fall(comparison, axis, angle, words):
    fell = with_falls(comparison, r0=50)
    policy = fell.rollouts["policy"]
    orientation = policy.orientation.copy()
    orientation[50, 0] = [math.cos(angle / 2), *(math.sin(angle / 2) * (axis == name) for name in "xyz")]
    rollouts = {**fell.rollouts, "policy": dataclasses.replace(policy, orientation=orientation)}
    assert words in failures.worst_episodes(dataclasses.replace(fell, rollouts=rollouts))[0].story


# Several runs.


def test_runs_are_ranked_by_paired_differences(comparison):
    rng = np.random.default_rng(0)
    values = {name: {m: v.copy() for m, v in metrics.items()} for name, metrics in comparison.values.items()}
    values["good"], values["level"], values["bad"] = (
        {m: v.copy() for m, v in values["tuned"].items()} for _ in range(3)
    )
    for metric in ("forward_velocity_error", "yaw_rate_error", "fall_rate"):
        values["good"][metric][:] = 0.0
        values["level"][metric][:] = rng.uniform(0.0, 0.004, values["level"][metric].shape)
        values["bad"][metric][:] = 1.0
    values["level"]["fall_rate"][:] = 0.0
    several = dataclasses.replace(comparison, values=values)
    names = ["bad", "good", "level"]
    assert run_comparison.best_at(several, names, "forwards") == ["good", "level"]
    words = run_comparison.headline(several, names)
    assert words.startswith(
        "Good and level are most accurate forwards, standing, backwards and turning; bad falls more often."
    )
    assert run_comparison.headline(several, ["good", "level"]).startswith("All are equally accurate forwards")


def test_runs_are_compared_on_one_page(run_directory, tmp_path):
    second = tmp_path / "second"
    random_policy("position").save(second)
    subjects = run_comparison.find_subjects([str(run_directory), str(second)], tmp_path / "out")
    policies = {name: found.policy for name, found in subjects.items()}
    compared = compare_policies(policies, 1, 2.0, TINY)
    assert list(compared.values) == ["20260101-000000-ppo", "second", "tuned", "article", "zero"]
    page, numbers, _ = run_comparison.write_comparison(subjects, compared, tmp_path / "out", "", with_video=False)
    text = " ".join(Page(page.read_text()).text)
    for name in subjects:
        assert name in text
    assert "script-src" not in page.read_text()
    assert set(json.loads(numbers.read_text())["policies"]) == set(subjects)
    alone = compare(random_policy("position"), 1, 2.0, TINY)
    np.testing.assert_array_equal(alone.values["policy"]["distance"], compared.values["second"]["distance"])
    assert verdict(compared.seen_as("second")) == verdict(alone)


def test_runs_that_cannot_be_compared_are_named(run_directory, tmp_path):
    with pytest.raises(QuadrupedError, match="at least two runs"):
        run_comparison.find_subjects(["flat"], tmp_path)
    with pytest.raises(QuadrupedError, match="'flat' is named before"):
        run_comparison.find_subjects(["flat", "flat"], tmp_path)
    with pytest.raises(QuadrupedError, match="'tuned' is the name of a scripted controller"):
        compare_policies({"tuned": random_policy("position")}, 1, 2.0)


# Finding the policy, and the program.


def test_default_is_the_latest_run_then_the_shipped_policy(run_directory, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    asked = []
    monkeypatch.setattr(subject, "load_policy", lambda name, *_: asked.append(name) or random_policy("position"))
    assert find_subject(None).output == Path("results/flat")
    assert asked == ["flat"]
    Path("runs").mkdir()
    Path("runs/latest").symlink_to(run_directory)
    found = find_subject(None)
    assert (found.name, found.output) == ("20260101-000000-ppo", Path("runs/latest/evaluation"))
    assert find_subject("flat", Path("there")).output == Path("there")


def test_a_checkpoint_is_named_with_its_run(run_directory):
    random_policy("position").save(run_directory / "checkpoints" / "step-1000")
    assert find_subject(str(run_directory / "checkpoints" / "step-1000")).name == (
        "20260101-000000-ppo/checkpoints/step-1000"
    )


def test_a_missing_library_names_its_extra(tmp_path, monkeypatch):
    monkeypatch.setattr(results.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(MissingExtraError, match=r"mini-quadruped\[report\]"):
        results.prepare_output(tmp_path)


def test_an_output_that_cannot_be_made_is_named(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(QuadrupedError, match=r"file.*cannot be created.*choose another directory"):
        results.prepare_output(tmp_path / "file" / "out")


def program(*arguments, cwd):
    return subprocess.run(
        [sys.executable, ROOT / "evaluate" / "policy.py", *map(str, arguments)],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
    )


def test_program_names_what_is_wrong_with_a_run(run_directory, tmp_path):
    damaged = tmp_path / "damaged"
    random_policy("position").save(damaged)
    (damaged / "policy.json").write_text("{")
    result = program(damaged, cwd=tmp_path)
    assert result.returncode == 2
    assert len(result.stderr.splitlines()) == 1
    assert f"{damaged / 'policy.json'}: not valid JSON" in result.stderr
    assert "train again" in result.stderr


@pytest.mark.slow
def test_program_evaluates_a_run(run_directory, tmp_path):
    result = program(
        run_directory, "--seeds", 1, "--seconds", 2, "--no-video", "--output", tmp_path / "out", cwd=tmp_path
    )
    assert result.returncode == 0, result.stderr
    assert "Forwards: velocity error (m/s)" in result.stdout
    assert str(tmp_path / "out" / "report.html") in result.stdout
    assert (tmp_path / "out" / "report.html").is_file()
    assert json.loads((tmp_path / "out" / "metrics.json").read_text())["command_line"] == (
        "python evaluate/policy.py runs/20260101-000000-ppo --seeds 1 --seconds 2"
    )


@pytest.mark.slow
def test_report_with_a_video_is_small(run_directory, comparison, tmp_path, monkeypatch):
    monkeypatch.setattr(pictures, "CLIP_SECONDS", 0.4)
    told = []
    page, _, _ = write_report(find_subject(str(run_directory), tmp_path), comparison, "", progress=told.append)
    html = page.read_text()
    if "No video" in html:
        pytest.skip("no OpenGL")
    assert 'src="data:video/mp4;base64,' in html
    assert len(html) < 5_000_000
    assert told == sorted(told)
    assert told[-1] == 1.0
