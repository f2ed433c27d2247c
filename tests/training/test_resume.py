"""Resumed runs: settings, steps, schedules and curve are the parent's; settings that cannot change are refused."""

import io
import json
import re
import shutil
import subprocess
import traceback
import zipfile
from dataclasses import replace

import numpy as np
import pytest
import torch
from trainings import ENDLESS, STEPS, assert_complete, command, learn, progress, running, tensorboard, train
from waiting import wait_until

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.cli.main import main
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.policies import Policy, load_policy
from quadruped_env.policies.files import CHECKPOINTS
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_COLUMNS, PROGRESS_FILE, RESUME_FILE


@pytest.fixture
def copy(run, tmp_path):
    """A copy of that run, to be damaged."""
    return shutil.copytree(run, tmp_path / "run")


@pytest.fixture
def killed(run, tmp_path):
    """The directory of a run that was killed: its second and last checkpoint has half the budget left."""
    directory = tmp_path / "killed"
    for name, share in (("00001s", 0.75), ("00002s", 0.5)):
        checkpoint = shutil.copytree(run, directory / CHECKPOINTS / name)
        edit(checkpoint / CARD_FILE, "card", timesteps=round((1 - share) * 8 * STEPS), budget_left=share)
    for name in (CONFIG_FILE, PROGRESS_FILE):
        shutil.copy(run / name, directory / name)
    return directory


def edit(path, section, **changes):
    """Change fields of a section of a JSON file; a field of None is removed."""
    document = json.loads(path.read_text())
    section = document[section]
    section.update(changes)
    for name, value in changes.items():
        if value is None:
            del section[name]
    path.write_text(json.dumps(document))


# --- settings ---


@pytest.mark.parametrize(
    ("asked", "field"),
    [
        ({"hidden": (32, 32)}, "hidden"),
        ({"learning_rate": 5e-4, "timesteps": 99}, "learning_rate"),
        ({"name": "second"}, "name"),
        ({"symmetric": True}, "symmetric"),  # as the run has it
        ({"task": {"decimation": 7, "reward": {}}}, r"task\.decimation"),
        ({"task": {"randomization": "none"}}, r"task\.randomization"),
    ],
)
def test_setting_that_a_resumed_training_keeps_is_refused(run, asked, field):
    message = rf"^training.{field}: \S+-first keeps its own: .* its budget .*and its reward .*; leave it out"
    with pytest.raises(QuadrupedError, match=message):
        Parent.load(run).resumed(asked)


def test_program_names_the_option_that_a_resumed_training_keeps(run, tmp_path, capsys):
    for options, named in (
        (("--hidden", "8"), "--hidden: "),
        (("--terrain", "stairs"), "--task.terrain: "),
        (("--randomization", "hard"), "--task.randomization: "),
    ):
        assert main(["train", "-o", str(tmp_path / "runs"), "--resume", str(run), *options]) == 2
        assert f"error: {named}{run.name} keeps its own" in capsys.readouterr().err
    assert not (tmp_path / "runs").exists()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--trust-task",), r"--trust-task: found without --resume; .*--task FILE"),
        (("--trust-task", "--resume", "RUN", "--task", "FILE.py"), r"--trust-task: found next to --task .*FILE.py"),
        (
            ("--resume", "RUN", "--task", "FILE.py"),
            r"FILE.py: \S+-first was trained without a task file",
        ),
    ],
)
def test_file_of_terms_that_the_run_does_not_have_is_refused(run, tmp_path, options, message, capsys):
    (tmp_path / "FILE.py").write_text("from quadruped_env.task import Command; height = Command('h', 'm', (0, 1))")
    places = {"RUN": str(run), "FILE.py": str(tmp_path / "FILE.py")}
    assert main(["train", "-o", str(tmp_path / "runs"), *(places.get(option, option) for option in options)]) == 2
    assert re.search(message, capsys.readouterr().err)


def test_training_goes_on_with_another_reward_and_says_so(run, tmp_path):
    parent = Parent.load(run)
    config = parent.resumed({"task": {"reward": {"weights": {"upright": -9.0}}}, "timesteps": STEPS})
    weights = parent.config.task["reward"]["weights"]
    assert config.task == {**parent.config.task, "reward": config.task["reward"]}
    assert config.task["reward"]["weights"] == {**weights, "upright": -9.0}
    changes = f"the reward differs from the run's: reward.weights.upright -9.0 (the run: {weights['upright']})"
    assert parent.reward_changes(config) == changes
    assert parent.reward_changes(parent.resumed({})) == ""
    resumed = learn(tmp_path, config, parent)
    assert load_policy(resumed).config.reward.weights["upright"] == -9.0


def test_budget_is_the_rest_of_the_run_or_as_much_again_or_the_given_one(run, killed):
    whole = Parent.load(run)
    assert whole.budget_left == 0.0
    assert whole.resumed({}) == whole.config
    with pytest.warns(QuadrupedWarning):
        half = Parent.load(killed)
    assert half.resumed({}) == replace(half.config, timesteps=4 * STEPS)
    assert half.resumed({"timesteps": 99}).timesteps == 99
    assert half.resumed({"seconds": 3.0}).seconds == 3.0
    edit(half.directory / CONFIG_FILE, "training", seconds=60.0)
    edit(half.directory / CARD_FILE, "card", seconds=45.0)
    timed = Parent.load(half.directory)
    assert timed.resumed({}).seconds == 15.0
    assert timed.resumed({"timesteps": 99}).seconds is None


# --- state ---


def test_resumed_training_continues_steps_and_curve_and_names_its_parent(killed, tmp_path):
    checkpoint = killed / CHECKPOINTS / "00002s"
    parent = Parent.load(checkpoint)
    directory = learn(tmp_path / "runs", parent.resumed({}), parent)
    policy = assert_complete(directory)
    assert policy.card["timesteps"] == 8 * STEPS
    assert policy.card["budget_left"] == 0.0
    assert policy.card["seconds"] >= parent.seconds
    expected = {"run": "killed/checkpoints/00002s", "timesteps": 4 * STEPS, "seconds": parent.seconds}
    for facts in (policy.card["resumed_from"], json.loads((directory / CONFIG_FILE).read_text())["resumed_from"]):
        assert facts == {**expected, "budget_left": 0.5}
    rows = progress(directory)
    assert rows[: len(parent.curve)] == list(parent.curve)
    # A row per second, and one at the end.
    logged = [int(row["timesteps"]) for row in rows[len(parent.curve) :]]
    assert logged == sorted(set(logged))
    assert logged[0] > 4 * STEPS
    assert logged[-1] == 8 * STEPS
    assert float(rows[-1]["seconds"]) >= parent.seconds


def test_the_curve_of_a_run_ends_where_its_checkpoint_was_taken(copy):
    # The columns of earlier versions.
    lines = [
        ",".join(PROGRESS_COLUMNS),
        "100,1,1,0,0.1,0.1",
        f"{8 * STEPS},2,1,0,0.1,0.1",
        f"{9 * STEPS},3,1,0,0.1,0.1",
        "1e9,4",
    ]
    (copy / PROGRESS_FILE).write_text("\n".join(lines))
    assert [row["timesteps"] for row in Parent.load(copy).curve] == ["100", str(8 * STEPS)]


def test_network_and_optimizer_are_those_of_the_run(run):
    from quadruped_env.envs import make_sb3_vec_env
    from quadruped_env.training.sb3_models import go_on_from, make_model

    parent = Parent.load(run)
    env = make_sb3_vec_env(4, seed=0, action_mode="residual", config=parent.config.task, privileged=True)
    model = make_model(parent.config, env)
    go_on_from(model, parent)
    exported = Policy.from_sb3(model, {})
    for one, other in zip(exported.weights, load_policy(run).weights, strict=True):
        np.testing.assert_array_equal(one, other)
    assert model.policy.optimizer.state_dict()["state"], "Adam's moments"
    env.close()


# --- runs that were killed ---


def test_killed_run_is_resumed_and_evaluated_from_its_last_checkpoint_with_a_warning(killed):
    with pytest.warns(QuadrupedWarning, match=r"killed: the training was killed .*: checkpoints/00002s$"):
        assert Parent.load(killed).name == "killed/checkpoints/00002s"
    with pytest.warns(QuadrupedWarning, match=r"last checkpoint is used"):
        evaluated = find_policy(str(killed))
    assert evaluated.name == "killed/checkpoints/00002s"
    assert evaluated.output == killed / "evaluation"
    assert evaluated.progress_file == killed.resolve() / CHECKPOINTS / "00002s" / PROGRESS_FILE
    assert evaluated.policy.card["timesteps"] == 4 * STEPS


@pytest.mark.slow
def test_killed_training_continues_from_its_last_checkpoint(tmp_path):
    with running(tmp_path, *ENDLESS, "--checkpoint-seconds", "0.5") as process:
        checkpoints = (tmp_path / "latest").resolve() / CHECKPOINTS
        wait_until(lambda: len(list(checkpoints.glob(f"*/{CARD_FILE}"))) >= 2, "two checkpoints", alive=process)
    # It was killed: the run has no policy of its own, only its checkpoints do, and each of them is whole.
    every = sorted(path for path in checkpoints.iterdir() if not path.name.startswith("."))
    steps = [load_policy(path).card["timesteps"] for path in every]
    assert steps == sorted(set(steps))
    assert tensorboard(checkpoints.parent)
    arguments = command(tmp_path, "--resume", tmp_path / "latest", "--timesteps", 2048)
    done = subprocess.run(arguments, capture_output=True, text=True, check=True)
    assert "mini-quadruped train: warning: " in done.stderr
    assert f"its last checkpoint is used: {CHECKPOINTS}/{every[-1].name}" in done.stderr
    assert f"{CHECKPOINTS}/{every[-1].name} at {steps[-1]:,} steps, for 2,048 steps" in done.stdout
    assert assert_complete((tmp_path / "latest").resolve()).card["timesteps"] >= steps[-1] + 2048
    resumed = train(tmp_path / "first", "--timesteps", 2048, "--resume", every[0])
    assert_complete(resumed)


# --- damaged runs ---


@pytest.mark.parametrize("name", [CONFIG_FILE, PROGRESS_FILE, CARD_FILE, TENSORS_FILE, RESUME_FILE])
def test_an_incomplete_run_is_not_resumed(copy, name):
    Parent.load(copy)
    (copy / name).unlink()
    missing = rf"{copy / name} is missing.*checkpoints/, or start a new training"
    with pytest.raises(QuadrupedError, match=missing):
        Parent.load(copy)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", r"config.json: not valid JSON.*start a new training"),
        ('{"training": [], "task": {}}', r"config.json: training: expected a table; found \[\]"),
        ('{"training": {}}', r"config.json: task is missing"),
    ],
)
def test_a_damaged_config_is_not_resumed(copy, text, message):
    (copy / CONFIG_FILE).write_text(text)
    with pytest.raises(QuadrupedError, match=message):
        Parent.load(copy)


@pytest.mark.parametrize(
    ("file", "section", "changes", "message"),
    [
        (CONFIG_FILE, "training", {"gamma": None}, r"field 'training.gamma' is missing; start a new training"),
        (CONFIG_FILE, "training", {"tempo": 1}, r"field 'training.tempo' is unknown; start a new training"),
        (CONFIG_FILE, "training", {"hidden": [8.5]}, r"training.hidden must be up to 16 whole numbers"),
        (CONFIG_FILE, "training", {"hidden": 8}, r"training.hidden must be up to 16 whole numbers"),
        (
            CONFIG_FILE,
            "training",
            {"gamma": 2.0},
            r"config.json: training.gamma must .*found 2.0; start a new training",
        ),
        (CONFIG_FILE, "training", {"device": "cuda"}, r"training.device: found 'cuda', .* its policy works"),
        (CONFIG_FILE, "training", {"algo": "mine.py:MyPPO"}, r"training.algo must be one of ppo, .*PPO'; start"),
        (CONFIG_FILE, "task", {"tempo": 1}, r"config.json: config: unknown field 'tempo'.*start a new training"),
        (CARD_FILE, "card", {"timesteps": None}, r"policy.json: card: timesteps is missing"),
        (CARD_FILE, "card", {"timesteps": 1.5}, r"card: timesteps: expected a whole number; found 1.5"),
        (CARD_FILE, "card", {"seconds": "9" * 99}, r"card: seconds: expected a finite number; found '9{40}\.\.\.';"),
    ],
)
def test_a_run_with_a_damaged_field_is_not_resumed(copy, file, section, changes, message):
    edit(copy / file, section, **changes)
    with pytest.raises(QuadrupedError, match=message):
        Parent.load(copy)


@pytest.mark.parametrize("text", ["a,b\n1,2\n", f"{','.join(PROGRESS_COLUMNS)}\nmany,1,1,0,0.1,0.1\n"])
def test_a_run_with_a_damaged_curve_is_not_resumed(copy, text):
    (copy / PROGRESS_FILE).write_text(text)
    with pytest.raises(QuadrupedError, match=r"progress.csv: not a learning curve \(.*\); start a new training"):
        Parent.load(copy)


def test_run_of_an_earlier_version_is_resumed(copy):
    edit(copy / CONFIG_FILE, "training", ranks=2, device="cpu", policy="")
    assert Parent.load(copy).config.hidden == (8,)


class Unpickled:
    """An object that runs a function when it is unpickled."""

    def __reduce__(self):
        return exec, ("raise AssertionError('unpickled')",)


def rewrite(path, change, compression=zipfile.ZIP_STORED):
    """Change the state of the network in a run's file."""
    with zipfile.ZipFile(path) as archive:
        contents = {name: archive.read(name) for name in archive.namelist()}
    state = torch.load(io.BytesIO(contents["policy.pth"]))
    change(state)
    torch.save(state, file := io.BytesIO())
    with zipfile.ZipFile(path, "w", compression) as archive:
        for name, content in {**contents, "policy.pth": file.getvalue()}.items():
            archive.writestr(name, content)


def set_nan(state):
    """Make one weight NaN."""
    next(iter(state.values())).view(-1)[0] = np.nan


@pytest.mark.parametrize(
    ("damage", "reason"),
    [
        (lambda path: path.write_bytes(b"PK nothing"), "BadZipFile"),
        (lambda path: path.write_bytes(path.read_bytes()[:5000]), "BadZipFile"),
        (lambda path: rewrite(path, lambda state: state.update(a=Unpickled())), "UnpicklingError"),
        (lambda path: rewrite(path, lambda state: state.popitem()), "RuntimeError"),
        (lambda path: rewrite(path, lambda state: None, zipfile.ZIP_DEFLATED), "compressed"),
        (lambda path: rewrite(path, set_nan), "policy.log_std holds NaN or infinity"),
    ],
)
def test_a_run_whose_network_is_damaged_is_not_resumed(copy, tmp_path, damage, reason):
    damage(copy / RESUME_FILE)
    parent = Parent.load(copy)
    pattern = rf"{copy}/{RESUME_FILE}: cannot be resumed \({reason}\); resume another .*, or start a new training"
    with pytest.raises(QuadrupedError, match=pattern) as caught:
        learn(tmp_path / "runs", parent.resumed({}), parent)
    assert "weights_only" not in "".join(traceback.format_exception(caught.value))
    assert not (tmp_path / "runs").exists()
