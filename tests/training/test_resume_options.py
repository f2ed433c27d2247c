"""Options of the task next to `--resume`: those that the resumed training would not obey are refused by their names."""

import argparse
import hashlib
import json
import shutil

import pytest

from quadruped_env import QuadrupedError
from quadruped_env.cli import train as cli
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.task import TaskConfig
from quadruped_env.training.run_directory import CONFIG_FILE


def asked_by(tmp_path, *arguments):
    """Run the program in this process."""
    parser = argparse.ArgumentParser()
    cli.add_arguments(parser)
    cli.run(parser.parse_args(["-o", str(tmp_path / "runs"), *arguments]), argparse.Namespace(line="train"))


def stop(*arguments, **others):
    """In place of a training."""
    raise QuadrupedError("stopped")


@pytest.fixture
def hard_run(run, tmp_path):
    """A run with the preset `hard`, without its payload, on steps of level 4."""
    directory = shutil.copytree(run, tmp_path / "hard")
    changes = {
        "randomization": {"preset": "hard", "payload": None},
        "terrain": {"name": "steps", "level": 4},
        "action": {"mode": "residual"},
    }
    task = json.loads(json.dumps(TaskConfig.from_dict(changes).to_dict()))
    for file, section in ((CONFIG_FILE, "task"), (CARD_FILE, "config")):
        document = json.loads((directory / file).read_text())
        document[section] = task
        document.pop("config_sha256", None)
        if section == "config":
            document["config_sha256"] = hashlib.sha256(json.dumps(task, sort_keys=True).encode()).hexdigest()
        (directory / file).write_text(json.dumps(document))
    return directory


@pytest.mark.parametrize(
    ("options", "message"),
    [
        # A preset without values of its own is no less a request than one with values.
        (("--randomization", "none"), r"--randomization: friction: found None; hard has \[0\.3, 1\.2\]"),
        (("--randomization", "moderate"), r"--randomization: friction: found \[0\.5, 1\.1\]; hard has \[0\.3, 1\.2\]"),
        # The whole preset, which the run did not have.
        (("--randomization", "hard"), r"--randomization: payload: found \[-0\.5, 1\.0\]; hard has None"),
        (("--task", '{"randomization": "none"}'), r"--task: randomization\.friction: found None; hard has"),
        (("--task", '{"randomization": {"preset": "moderate"}}'), r"--task: randomization\.friction: found \[0\.5"),
        (("--terrain", "stairs", "--level", "4"), r"--terrain: name: found 'stairs'; hard has 'steps'"),
        (("--terrain", "steps"), r"--terrain: level: found None; hard has 4"),
        (("--terrain", "steps", "--level", "5"), r"--terrain: level: found 5; hard has 4"),
    ],
)
def test_option_of_the_task_that_a_resumed_training_would_not_obey_is_refused_by_its_name(
    hard_run, tmp_path, options, message
):
    with pytest.raises(QuadrupedError, match=rf"{message}.*leave the option out, or start a new training"):
        asked_by(tmp_path, "--resume", str(hard_run), *options)


def test_options_of_the_task_that_the_run_has_are_accepted(hard_run, tmp_path, monkeypatch):
    from quadruped_env.training import train as training

    monkeypatch.setattr(training, "train", stop)
    options = ("--randomization", "hard", "--task", '{"randomization": {"payload": null}}', "--terrain", "steps")
    with pytest.raises(QuadrupedError, match="stopped"):
        asked_by(tmp_path, "--resume", str(hard_run), *options, "--level", "4")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--trust-task",), r"--trust-task: found without --resume; .*--task FILE"),
        (("--trust-task", "--resume", "RUN", "--task", "FILE.py"), r"--trust-task: found next to --task .*FILE.py"),
    ],
)
def test_trust_task_is_refused_without_a_run_and_next_to_a_file(run, tmp_path, options, message):
    (tmp_path / "FILE.py").write_text("from quadruped_env.task import Command; height = Command('h', 'm', (0, 1))")
    places = {"RUN": str(run), "FILE.py": str(tmp_path / "FILE.py")}
    with pytest.raises(QuadrupedError, match=message):
        asked_by(tmp_path, *(places.get(option, option) for option in options))


def test_file_of_terms_that_the_run_does_not_have_is_refused(run, tmp_path):
    file = tmp_path / "my_terms.py"
    file.write_text(
        "from quadruped_env.task import reward\n\n\n@reward(weight=1.0)\ndef still(context):\n"
        "    return -abs(context.velocity[:, 0])\n"
    )
    with pytest.raises(
        QuadrupedError, match=r"--task: found my_terms.py; \S+-first was trained without a file, .*leave"
    ):
        asked_by(tmp_path, "--resume", str(run), "--task", str(file))
