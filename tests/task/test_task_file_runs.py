"""A run and the user's file that made it: without the file, with another version of it, and with the run's copy."""

import argparse
import hashlib
import json
import shutil

import pytest

pytest.importorskip("stable_baselines3")

from trainings import SMALL, progress

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.cli import train as cli
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.kept_task_file import kept_file
from quadruped_env.control.live_controller import LiveController
from quadruped_env.control.policy import CARD_FILE
from quadruped_env.control.policy_files import CHECKPOINTS, load_terms, read_policy
from quadruped_env.control.task_file import KEPT_FILE, changed_definitions
from quadruped_env.live.nodes import controller
from quadruped_env.policies import load_policy
from quadruped_env.task import TaskConfig, load_task_file
from quadruped_env.training import TrainConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE
from quadruped_env.training.train import train
from quadruped_env.viewer import open_show

REWARDS = """
from pathlib import Path

from quadruped_env.task import reward, termination

with (Path(__file__).parent / "log").open("a") as log:
    log.write("executed\\n")


@reward(weight=-0.5, unit="rad^2")
def hip_usage(context, free: float = 0.1):
    \"\"\"Squared distance of the hips from the stance, beyond a free range.\"\"\"
    return ((abs(context.joint_offset[:, 0::2]) - free).clip(0.0) ** 2).sum(axis=1)


@termination
def too_low(context):
    \"\"\"The base is lower than 0.1 m.\"\"\"
    return context.base_height < 0.1
"""
OBSERVATION = """
from quadruped_env.task import observation, privileged

GAIN = 1.0


def strain(values):
    return values * GAIN


@observation(unit="N m", mirror="joints", scale=0.1, bound=2.0)
def joint_torque(readings, control):
    return strain(readings.joint_torque)


@privileged(unit="N", mirror="feet", scale=0.05, bound=2.0)
def foot_force(state):
    return state.context.readings.foot_force
"""


def trained(file, runs, resume=None, **changes):
    values = {**SMALL, "timesteps": 64, **changes}
    parent = None if resume is None else Parent.load(resume, load_task_file(file))
    config = TrainConfig(**values) if parent is None else parent.resumed({"timesteps": 64})
    return train(config, runs, "train", parent, file)[0]


@pytest.fixture(scope="module")
def rewarded(tmp_path_factory):
    """A run whose file defines a reward and a termination; its weights have been changed by the config, too."""
    folder = tmp_path_factory.mktemp("rewarded")
    (folder / "my_task.py").write_text(REWARDS)
    task = {"reward": {"weights": {"upright": -3.0}}}
    return trained(folder / "my_task.py", folder / "runs", task=task, checkpoint_seconds=1e-6)


@pytest.fixture(scope="module")
def observed(tmp_path_factory):
    """A run whose file defines an observation and a privileged reading."""
    folder = tmp_path_factory.mktemp("observed")
    (folder / "my_task.py").write_text(OBSERVATION)
    return trained(folder / "my_task.py", folder / "runs", asymmetric_critic=True)


def edited(folder, text, *changes):
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    file = folder / "my_task.py"
    file.write_text(text)
    return file


def test_run_and_checkpoints_keep_the_file_as_it_was(rewarded):
    folders = [rewarded, *(rewarded / CHECKPOINTS).iterdir()]
    assert len(folders) > 1
    for folder in folders:
        assert (folder / KEPT_FILE).read_text() == REWARDS
    recorded = json.loads((rewarded / CONFIG_FILE).read_text())["task"]["task_file"]
    assert recorded["sha256"] == hashlib.sha256(REWARDS.encode()).hexdigest()


def test_policy_without_the_file_of_its_reward_walks_and_nothing_is_executed(rewarded):
    logs = [folder / "log" for folder in (rewarded, rewarded.parent.parent)]
    before = [log.exists() and log.read_text() for log in logs]
    message = (
        r"without my_task.py, which is not executed automatically: reward hip_usage left out; "
        r"termination too_low left out. --trust-task"
    )
    with pytest.warns(QuadrupedWarning, match=message):
        policy = load_policy(rewarded)
    assert [log.exists() and log.read_text() for log in logs] == before
    env = policy.make_env()
    observation, _ = env.reset(seed=0)
    _, _, _, _, info = env.step(policy.predict(observation))
    assert "reward_hip_usage" not in info
    assert policy.config.reward.weights["upright"] == -3.0
    LiveController(PolicyController(read_policy(rewarded)))


def test_policy_with_the_copy_that_the_run_keeps_has_its_whole_task(rewarded):
    policy = load_policy(rewarded, trust_task=True)
    assert policy.config.definition.file.name == "my_task.py"
    assert policy.config == load_policy(rewarded, rewarded.parent.parent / "my_task.py").config
    assert policy.config.reward.weights["hip_usage"] == -0.5
    assert load_policy("flat", trust_task=True).config == load_policy("flat").config


def test_copy_that_was_changed_is_not_executed(rewarded, tmp_path):
    copy = shutil.copytree(rewarded, tmp_path / "run")
    (copy / KEPT_FILE).write_text(REWARDS + "raise SystemExit\n")
    with pytest.raises(QuadrupedError, match=r"task.py: its SHA-256 is .*was made with 'my_task.py'"):
        load_policy(copy, trust_task=True)
    (copy / KEPT_FILE).unlink()
    with pytest.raises(QuadrupedError, match=r"task.py: missing, .*copy of 'my_task.py' .*--task FILE"):
        load_policy(copy, trust_task=True)


@pytest.mark.parametrize(
    ("changes", "difference", "weights"),
    [
        ((("weight=-0.5", "weight=-2.0"),), r"reward.weights.hip_usage -2.0 \(the run: -0.5\)", {"hip_usage": -2.0}),
        ((("** 2", "** 4"),), r"other code in hip_usage", {"hip_usage": -0.5}),
        ((("def hip_usage", "def hips"),), r"reward hip_usage left out; reward hips added", {"hips": -0.5}),
        ((("free: float = 0.1", "free: float = 0.2"),), r"reward.free 0.2 \(the run: 0.1\)", {"hip_usage": -0.5}),
    ],
)
def test_another_version_of_the_file_is_used_and_its_differences_are_said(
    rewarded, tmp_path, changes, difference, weights
):
    file = edited(tmp_path, REWARDS, *changes)
    with pytest.warns(QuadrupedWarning, match=rf"the task of my_task.py differs from the run's: .*{difference}"):
        policy = load_policy(rewarded, file)
    found = policy.config.reward.weights
    assert {name: found.get(name) for name in weights} == weights
    assert found["upright"] == -3.0, "what the config of the run changed stays"
    policy.make_env().reset(seed=0)


def test_weight_that_the_config_of_the_run_changed_stays_with_another_version(tmp_path):
    definition = load_task_file(edited(tmp_path, REWARDS))
    changes = {"reward": {"weights": {"hip_usage": -7.0}}}
    document = json.loads(json.dumps(TaskConfig.from_dict(changes, definition).to_dict()))
    other = load_task_file(edited(tmp_path, REWARDS, ("weight=-0.5", "weight=-2.0")))
    assert TaskConfig.from_dict(document, other).reward.weights["hip_usage"] == -7.0
    del document["task_file"]["defaults"]
    assert TaskConfig.from_dict(document, other).reward.weights["hip_usage"] == -2.0, "a run of an earlier version"


def test_policy_that_observes_what_the_file_defines_needs_it(observed):
    message = (
        r"policy.json: this policy has the observation joint_torque from 'my_task.py', .*--task FILE.*--trust-task"
    )
    with pytest.raises(QuadrupedError, match=message):
        load_policy(observed)
    with pytest.raises(QuadrupedError, match=message):
        read_policy(observed)
    assert load_policy(observed, trust_task=True).fields[-1].name == "joint_torque"
    terms = load_terms(*kept_file(observed))
    assert read_policy(observed, terms).fields[-1].name == "joint_torque"


def test_observation_that_replaces_a_built_in_one_of_the_same_layout_needs_the_file(tmp_path):
    text = (
        "from quadruped_env.task import observation\n\n\n"
        '@observation(unit="1", mirror=(-1.0, -1.0))\ndef gait_clock(readings, control):\n    return -control.clock\n'
    )
    run = trained(edited(tmp_path, text), tmp_path / "runs")
    with pytest.raises(QuadrupedError, match=r"this policy has the observation gait_clock from 'my_task.py'"):
        read_policy(run)


def test_viewer_of_a_trusted_run_has_its_robot_and_executes_the_files_of_no_other_runs(tmp_path, monkeypatch):
    pytest.importorskip("mjviser")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robot.py").write_text(
        "from quadruped_env.robot import QuadrupedDesign\n\nROBOT = QuadrupedDesign(name='long', leg_length=0.2)\n"
    )
    other = trained(edited(tmp_path, REWARDS), tmp_path / "runs", name="other")
    trained(tmp_path / "robot.py", tmp_path / "runs", name="mine")
    show = open_show(["runs/latest", "trot"], port=0, trust_task=True)
    try:
        assert {view.now.robot.name for view in show.controller.view().robots} == {"long"}
        with pytest.warns(QuadrupedWarning, match="not executed"), pytest.raises(QuadrupedError, match="'long'"):
            show.controller.set_source(0, f"run {other.name}")
    finally:
        show.close()
    assert not (other / "log").exists()


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ((("scale=0.1", "scale=0.2"),), r"observation_layout differs"),
        ((("GAIN = 1.0", "GAIN = 2.0"),), r"computes the observation joint_torque differently"),
        ((('mirror="joints"', "mirror=(1.0,) * 8"),), r"computes the observation joint_torque differently"),
    ],
)
def test_version_with_which_the_policy_would_read_other_values_is_refused(observed, tmp_path, changes, message):
    file = edited(tmp_path, OBSERVATION, *changes)
    with pytest.raises(QuadrupedError, match=message):
        load_policy(observed, file)
    with pytest.raises(QuadrupedError, match=message):
        read_policy(observed, load_terms(file))


def test_version_with_the_same_observation_is_used(observed, tmp_path):
    reward = (
        "\nfrom quadruped_env.task import reward\n@reward(1.0)\ndef mine(context):\n    return context.moving * 1.0\n"
    )
    file = edited(tmp_path, OBSERVATION + reward, ("scale=0.1, bound", "scale=0.1,\n    bound"))
    with pytest.warns(QuadrupedWarning, match="reward mine added"):
        assert load_policy(observed, file).fields[-1].name == "joint_torque"


def test_training_goes_on_with_another_reward_and_says_so(rewarded, tmp_path):
    file = edited(tmp_path, REWARDS, ("weight=-0.5", "weight=-2.0"), ("def hip_usage", "def hips"))
    parent = Parent.load(rewarded, load_task_file(file))
    assert "reward hip_usage left out; reward hips added" in parent.task_changes
    run = trained(file, tmp_path / "runs", rewarded)
    document = json.loads((run / CONFIG_FILE).read_text())
    assert document["task"]["reward"]["weights"]["hips"] == -2.0
    assert document["resumed_from"]["task_changes"] == parent.task_changes
    assert (run / KEPT_FILE).read_text() == file.read_text()
    rows = progress(run)
    assert [rows[0]["reward_hips"], rows[-1]["reward_hip_usage"]] == ["", ""]
    assert float(rows[0]["reward_hip_usage"]) <= 0.0
    assert float(rows[-1]["reward_hips"]) <= 0.0


def test_program_resumes_with_the_copy_of_the_run(rewarded, tmp_path, capsys):
    parser = argparse.ArgumentParser()
    cli.add_arguments(parser)
    task = '{"reward": {"weights": {"hip_usage": -1}}}'
    options = ["-o", str(tmp_path), "--resume", str(rewarded), "--trust-task", "--timesteps", "32", "--task", task]
    assert cli.run(parser.parse_args(options), argparse.Namespace(line="train")) == 0
    assert (
        "note: the reward differs from the run's: reward.weights.hip_usage -1.0 (the run: -0.5)"
        in capsys.readouterr().out
    )
    run = (tmp_path / "latest").resolve()
    assert load_policy(run, trust_task=True).config.reward.weights["hip_usage"] == -1.0


def test_live_controller_takes_the_copy_of_the_run_for_its_observations(observed):
    def terms(*options):
        parser = argparse.ArgumentParser()
        controller.add_arguments(parser)
        return controller._terms(parser.parse_args([str(observed), *options]))

    assert [entry.name for entry in terms("--trust-task").observations][-1] == "joint_torque"
    assert terms().file is None
    with pytest.raises(QuadrupedError, match=r"--trust-task: found next to --task my_task.py"):
        terms("--trust-task", "--task", "my_task.py")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ((("def foot_force", "def force"),), r"another privileged reading foot_force, force than the run"),
    ],
)
def test_training_does_not_go_on_with_another_network(observed, tmp_path, changes, message):
    with pytest.raises(QuadrupedError, match=message):
        Parent.load(observed, load_task_file(edited(tmp_path, OBSERVATION, *changes)))


def test_training_does_not_go_on_without_the_file(rewarded):
    with pytest.raises(QuadrupedError, match=r"config.json: this task has terms from 'my_task.py', .*--trust-task"):
        Parent.load(rewarded)


def test_a_run_of_an_earlier_version_needs_its_file(rewarded, tmp_path):
    copy = shutil.copytree(rewarded, tmp_path / "run")
    document = json.loads((copy / CARD_FILE).read_text())
    del document["config"]["task_file"]["terms"]
    content = json.dumps(document["config"], sort_keys=True).encode()
    document["config_sha256"] = hashlib.sha256(content).hexdigest()
    (copy / CARD_FILE).write_text(json.dumps(document))
    with pytest.raises(QuadrupedError, match=r"trained by an earlier version with terms from 'my_task.py'"):
        load_policy(copy)
    assert load_policy(copy, trust_task=True).config.reward.weights["hip_usage"] == -0.5


def test_definitions_that_differ_are_found_without_comments_docstrings_and_weights():
    other = REWARDS.replace("-0.5", "-9").replace("The base is lower", "It is lower").replace("0.1\n", "0.1  # m\n")
    assert changed_definitions(REWARDS.encode(), other.encode()) == ()
    assert changed_definitions(REWARDS.encode(), (REWARDS + "LIMIT = 3\n").encode()) == ("LIMIT",)
    assert changed_definitions(b"def f(:", REWARDS.encode()) is None


@pytest.mark.parametrize(
    ("old", "new", "changed"),
    [
        ("A = 1", "A = 2", ("A", "user", "way")),
        ("A *= 2", "A *= 3", ("A", "user", "way")),
        ("T.append(3)", "T.append(4)", ("T", "way")),
        ("    B = 5", "    B = 6", ("B", "other")),
        ("import sin, cos", "import sin, tan", ("cos", "tan")),
        ("import sin", "import sinh as sin", ("sin", "B", "other")),
    ],
)
def test_definitions_that_use_one_that_differs_differ(old, new, changed):
    text = (
        "from math import sin, cos\nA = 1\nA *= 2\nT = []\nT.append(3)\nif sin:\n    B = 5\n"
        "def user(x): return x * A\ndef way(x): return user(T[0])\ndef other(x): return sin(B)\n"
    )
    found = changed_definitions(text.encode(), text.replace(old, new, 1).encode())
    assert found == changed


def test_version_that_cannot_be_compared_is_refused_where_it_decides_numbers(observed, tmp_path):
    copy = shutil.copytree(observed, tmp_path / "run")
    (copy / KEPT_FILE).unlink()
    with pytest.raises(QuadrupedError, match=r"may compute the observation joint_torque differently"):
        load_policy(copy, edited(tmp_path, OBSERVATION + "LIMIT = 3\n"))


@pytest.mark.parametrize(
    ("decorator", "weight"),
    [("@reward({})", "'heavy'"), ("@reward({})", "True"), ("@reward_group(mine={}, other=1.0)", "float('nan')")],
)
def test_weight_that_is_no_finite_number_is_refused_by_the_name_of_its_term(decorator, weight, tmp_path):
    text = (
        f"from quadruped_env.task import reward, reward_group\n\n\n{decorator.format(weight)}\ndef mine(c):\n    ...\n"
    )
    with pytest.raises(QuadrupedError, match=r"my_task.py, line 4: .*reward mine: weight must be a number from.*found"):
        load_task_file(edited(tmp_path, text))


def test_json_file_in_place_of_a_python_file_is_named_as_such(tmp_path):
    file = tmp_path / "changes.json"
    file.write_text('{"reward": {"only_positive": true}}')
    with pytest.raises(QuadrupedError, match=r"changes.json: is a JSON file, and a Python file of terms is expected"):
        load_policy("flat", task_file=file)
