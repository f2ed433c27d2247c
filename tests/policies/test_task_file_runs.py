"""A run and the user's file that made it: without the file, with another version of it, and with the run's copy."""

import argparse
import errno
import hashlib
import json
import shutil
from pathlib import Path

import pytest
from policies import save_policy

pytest.importorskip("stable_baselines3")

from trainings import SMALL, progress

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.cli import train as cli
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.live_controller import LiveController
from quadruped_env.control.task_file import KEPT_FILE, load_terms
from quadruped_env.live.nodes import controller
from quadruped_env.policies import load_policy
from quadruped_env.policies.files import CHECKPOINTS, kept_file, read_policy
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import load_task_file
from quadruped_env.training import TrainConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_FILE
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


@observation(unit="N m", mirror="joints", scale=0.1, bound=2.0)
def joint_torque(readings, control):
    return readings.joint_torque


@privileged(unit="N", mirror="feet", scale=0.05, bound=2.0)
def foot_force(state):
    return state.context.readings.foot_force
"""
VERSION = (
    r"my_task.py is not the version of the training, which the run keeps as task.py: the code of the terms is your"
)


def trained(file, runs, resume=None, **changes):
    values = {**SMALL, "timesteps": 64, **changes}
    parent = None if resume is None else Parent.load(resume, load_task_file(file))
    config = TrainConfig(**values) if parent is None else parent.resumed({"timesteps": 64})
    return train(config, runs, "train", parent, file)[0]


def edited(folder, text, *changes):
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    folder.mkdir(exist_ok=True)
    file = folder / "my_task.py"
    file.write_text(text)
    return file


@pytest.fixture(scope="module")
def rewarded(tmp_path_factory):
    """A run whose file defines a reward and a termination; its weights have been changed by the config, too."""
    folder = tmp_path_factory.mktemp("rewarded")
    task = {"reward": {"weights": {"upright": -3.0}}}
    return trained(edited(folder, REWARDS), folder / "runs", task=task, checkpoint_seconds=1e-6)


@pytest.fixture(scope="module")
def observed(tmp_path_factory):
    """A run whose file defines an observation and a privileged reading."""
    folder = tmp_path_factory.mktemp("observed")
    return trained(edited(folder, OBSERVATION), folder / "runs", asymmetric_critic=True)


def test_run_and_checkpoints_keep_the_file_as_it_was(rewarded):
    folders = [rewarded, *(rewarded / CHECKPOINTS).iterdir()]
    assert len(folders) > 1
    for folder in folders:
        assert (folder / KEPT_FILE).read_text() == REWARDS
    recorded = json.loads((rewarded / CONFIG_FILE).read_text())["task"]["task_file"]
    assert recorded["sha256"] == hashlib.sha256(REWARDS.encode()).hexdigest()


MODEL_FROM_FILE = """
import dataclasses
from pathlib import Path
from quadruped_env.robot import MINI_QUADRUPED

ROBOT = dataclasses.replace(MINI_QUADRUPED, name="dog", mjcf=Path(__file__).with_name("dog.xml"))
"""


def test_run_and_checkpoints_keep_the_model_that_the_file_reads(tmp_path):
    folder = tmp_path / "mine"
    model = edited(folder, MODEL_FROM_FILE).with_name("dog.xml")
    model.write_text(MINI_QUADRUPED.mjcf.replace("<worldbody>", '<include file="parts/custom.xml"/><worldbody>', 1))
    model.with_name("parts").mkdir()
    (folder / "parts" / "custom.xml").write_text("<mujocoinclude><custom/></mujocoinclude>")
    run = trained(folder / "my_task.py", tmp_path / "runs", checkpoint_seconds=1e-6)
    robot = load_policy(run, folder / "my_task.py").robot
    checkpoint = next((run / CHECKPOINTS).iterdir())
    for name, once in (("dog.xml", True), ("parts/custom.xml", True), (PROGRESS_FILE, False)):
        assert (checkpoint / name).samefile(run / name) is once, "large meshes take their space once per run"
    shutil.rmtree(folder)
    for kept in (run, *(run / CHECKPOINTS).iterdir()):
        assert load_policy(kept, trust_task=True).robot == robot
    again = trained(run / KEPT_FILE, tmp_path / "again", run)
    shutil.rmtree(run)
    assert load_policy(again, trust_task=True).robot.name == "dog"


def test_checkpoints_keep_the_file_where_the_file_system_has_no_links(tmp_path, monkeypatch):
    def refused(path, target):
        raise OSError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(Path, "hardlink_to", refused)
    run = trained(edited(tmp_path, REWARDS), tmp_path / "runs", checkpoint_seconds=1e-6)
    assert {(folder / KEPT_FILE).read_text() for folder in (run / CHECKPOINTS).iterdir()} == {REWARDS}


def test_policy_without_the_file_of_its_reward_walks_and_nothing_is_executed(rewarded):
    logs = [folder / "log" for folder in (rewarded, rewarded.parent.parent)]
    before = [log.exists() and log.read_text() for log in logs]
    message = (
        r"without my_task.py, which is not executed automatically: without its rewards hip_usage; "
        r"terminations too_low. --trust-task"
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
    ("change", "weights", "free"),
    [
        (("weight=-0.5", "weight=-2.0"), {"hip_usage": -0.5}, 0.1),
        (("** 2", "** 4"), {"hip_usage": -0.5}, 0.1),
        (("free: float = 0.1", "free: float = 0.2"), {"hip_usage": -0.5}, 0.1),
        (("def hip_usage(context, free: float = 0.1", "def hips(context, free: float = 0.2"), {"hips": -0.5}, 0.1),
        (("free: float = 0.1", "low: float = 0.1, free: float = 0.2"), {"hip_usage": -0.5}, 0.1),
    ],
)
def test_numbers_of_the_run_count_with_another_version_of_its_file(rewarded, tmp_path, change, weights, free):
    with pytest.warns(QuadrupedWarning, match=VERSION):
        policy = load_policy(rewarded, edited(tmp_path, REWARDS, change))
    found = policy.config.reward
    assert {name: found.weights.to_dict().get(name) for name in ("hip_usage", "hips")} == {
        "hip_usage": None,
        "hips": None,
        **weights,
    }
    assert (found.free, found.weights["upright"]) == (free, -3.0)
    policy.make_env().reset(seed=0)


def test_policy_that_observes_what_the_file_defines_needs_it(observed):
    message = (
        r"policy.json: this policy has the observation joint_torque from 'my_task.py', .*--task FILE.*--trust-task"
    )
    for load in (load_policy, read_policy):
        with pytest.raises(QuadrupedError, match=message):
            load(observed)
    assert load_policy(observed, trust_task=True).fields[-1].name == "joint_torque"
    assert read_policy(observed, load_terms(*kept_file(observed))).fields[-1].name == "joint_torque"


def test_observation_that_replaces_a_built_in_one_of_the_same_layout_needs_the_file(tmp_path):
    text = (
        "from quadruped_env.task import observation\n\n\n"
        '@observation(unit="1", mirror=(-1.0, -1.0))\ndef gait_clock(readings, control):\n    return -control.clock\n'
    )
    run = save_policy(tmp_path / "run", edited(tmp_path, text))
    with pytest.raises(QuadrupedError, match=r"this policy has the observation gait_clock from 'my_task.py'"):
        read_policy(run)


def test_policy_of_a_terrain_of_the_file_needs_it_in_its_env_but_not_on_a_robot(tmp_path):
    text = (
        "from quadruped_env.task import terrain\n\n\n"
        "@terrain\ndef ridges(grid, height: float = 0.02):\n    return height * grid.fade\n"
    )
    run = save_policy(tmp_path / "run", edited(tmp_path, text), {"terrain": {"name": "ridges"}})
    with pytest.raises(QuadrupedError, match=r"this task has the terrain 'ridges' from 'my_task.py'"):
        load_policy(run)
    assert load_policy(run, trust_task=True).config.terrain.name == "ridges"
    read_policy(run)


def test_viewer_of_a_trusted_run_has_its_robot_and_executes_the_files_of_no_other_runs(tmp_path, monkeypatch):
    pytest.importorskip("mjviser")
    monkeypatch.chdir(tmp_path)
    robot = "from quadruped_env.robot import QuadrupedDesign\n\nROBOT = QuadrupedDesign(name='long', leg_length=0.2)\n"
    (tmp_path / "runs").mkdir()
    file = edited(tmp_path / "files", REWARDS)
    other = save_policy(tmp_path / "runs" / "other", file)
    (tmp_path / "runs" / "other" / "log").unlink(missing_ok=True)
    mine = save_policy(tmp_path / "runs" / "mine", edited(tmp_path, robot))
    (mine / CONFIG_FILE).write_text("{}")
    show = open_show([str(mine), "trot"], port=0, trust_task=True)
    try:
        assert {view.now.robot.name for view in show.controller.view().robots} == {"long"}
        with pytest.warns(QuadrupedWarning, match="not executed"), pytest.raises(QuadrupedError, match="'long'"):
            show.controller.set_source(0, f"run {other.name}")
    finally:
        show.close()
    assert not (other / "log").exists()


def test_another_layout_of_the_observations_is_refused_and_another_version_with_the_same_is_used(observed, tmp_path):
    file = edited(tmp_path, OBSERVATION, ("scale=0.1", "scale=0.2"))
    for load in (load_policy, lambda run, file: read_policy(run, load_terms(file))):
        with pytest.raises(QuadrupedError, match=r"observation_layout differs"):
            load(observed, file)
    file = edited(tmp_path, OBSERVATION, ("return readings.joint_torque", "return 2.0 * readings.joint_torque"))
    with pytest.warns(QuadrupedWarning, match=VERSION):
        assert load_policy(observed, file).fields[-1].name == "joint_torque"


def test_training_goes_on_with_another_reward_and_says_so(rewarded, tmp_path):
    file = edited(tmp_path, REWARDS, ("weight=-0.5", "weight=-2.0"), ("def hip_usage", "def hips"))
    parent = Parent.load(rewarded, load_task_file(file))
    assert "my_task.py is not the version of the training" in parent.task_changes
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


def test_training_does_not_go_on_with_another_critic_or_without_the_file(observed, rewarded, tmp_path):
    with pytest.raises(QuadrupedError, match=r"another privileged reading foot_force, force than the run"):
        Parent.load(observed, load_task_file(edited(tmp_path, OBSERVATION, ("def foot_force", "def force"))))
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
