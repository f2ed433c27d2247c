"""A sweep whose files are damaged goes on; the damaged trials begin again, and nothing is lost."""

import json

import pytest
from sweep_files import read_sweep, resume, write_sweep

from quadruped_env import QuadrupedError
from quadruped_env.sweep.sweep_records import SweepFolder

DAMAGE = {
    "score as a text": ("result.json", lambda text: text.replace('"total": 0.5', '"total": "x"')),
    "score is a text": ("result.json", lambda text: json.dumps({**json.loads(text), "score": "x"})),
    "cut off": ("result.json", lambda text: text[:50]),
    "another state": ("result.json", lambda text: text.replace("finished", "lost")),
    "run elsewhere": ("result.json", lambda text: text.replace('"run"', '"../run"').replace('"../run":', '"run":')),
    "seed of 300 digits": ("trial.json", lambda text: text.replace('"seed": 4', f'"seed": {10**300}')),
    "values beyond the space": ("trial.json", lambda text: text.replace('weights.foot_slip"', 'weights.slip"')),
    "code elsewhere": ("trial.json", lambda text: text.replace('"algo": "ppo"', '"algo": "/elsewhere.py:Mine"')),
    "settings cut off": ("trial.json", lambda text: text[:50]),
    "no settings": ("trial.json", lambda text: None),
    "scores": ("scores.csv", lambda text: text.replace("256", "x")),
    "infinite rung": ("scores.csv", lambda text: text.replace("\n1,", "\ninf,")),
    "suite": ("run/evaluation/suite.json", lambda text: text[:50]),
    "no suite": ("run/evaluation/suite.json", lambda text: None),
}


@pytest.mark.parametrize("what", DAMAGE)
def test_damaged_trial_is_put_aside_and_begins_again(tmp_path, what):
    folder = write_sweep(tmp_path)
    name, damage = DAMAGE[what]
    file = folder.trial(1).path / name
    text = damage(before := file.read_text())
    assert text != before
    file.unlink() if text is None else file.write_text(text)
    with pytest.raises(QuadrupedError, match=r"trials/0001/.*resume the sweep|0001/run/evaluation/suite.json: "):
        read_sweep(folder.path)
    kept = {path.name: path.read_bytes() for path in folder.trial(1).path.iterdir() if path.is_file()}
    said = resume(folder.path)
    aside = folder.path / "trials" / "0001.damaged"
    assert said[0].startswith(f"trial 1 begins again, and its files are in {aside}: {folder.path}/trials/0001/")
    assert {path.name: path.read_bytes() for path in aside.iterdir() if path.is_file()} == kept
    folder.trial(1).check()
    assert [folder.trial(number).result() is None for number in range(4)] == [False, True, False, True]
    assert json.loads((folder.path / "results.json").read_text())["states"] == {"begun": 1, "finished": 2}
    # The trial has the values of the other seeds of its setting.
    assert folder.trial(1).settings()["values"] == folder.trial(0).settings()["values"]
    assert not any("begins again" in line for line in resume(folder.path))


@pytest.mark.parametrize("what", ["a link", "no directory"])
def test_trial_whose_folder_is_no_directory_is_put_aside(tmp_path, what):
    folder = write_sweep(tmp_path / "sweeps")
    path, elsewhere = folder.trial(1).path, tmp_path / "elsewhere"
    path.rename(elsewhere)
    if what == "a link":
        path.symlink_to(elsewhere)
        (elsewhere / "result.json").unlink()  # so that the trial would be trained again
    else:
        path.write_text("")
    kept = sorted(elsewhere.rglob("*"))
    assert f"{path}: is {what}; " in resume(folder.path)[0]
    assert not path.is_symlink()
    assert path.is_dir()
    assert sorted(elsewhere.rglob("*")) == kept


def test_trial_that_is_damaged_again_keeps_the_files_of_both_times(tmp_path):
    folder = write_sweep(tmp_path)
    for _ in range(2):
        (folder.trial(1).path / "trial.json").write_text("{")
        resume(folder.path)
    assert sorted(path.name for path in (folder.path / "trials").glob("0001*")) == [
        "0001", "0001-2.damaged", "0001.damaged",
    ]  # fmt: skip


def test_sound_sweep_is_read_as_it_is(tmp_path):
    folder = write_sweep(tmp_path)
    read_sweep(folder.path)
    assert SweepFolder.open(folder.path) == folder
    assert len(list((folder.path / "trials").iterdir())) == 4


def test_sweep_of_a_version_with_other_settings_keeps_its_trials_and_says_so_once(tmp_path):
    folder = write_sweep(tmp_path)
    for file in (folder.path / "sweep.json", *folder.path.glob("trials/*/trial.json")):
        document = json.loads(file.read_text())
        document["training"]["polish_of_old"] = 3  # a setting that went
        document["training"].pop("device", None)  # a setting that came
        file.write_text(json.dumps(document))
    said = resume(folder.path)
    assert said[0] == "note: settings that this version does not have are left out: polish_of_old"
    assert sum("polish_of_old" in line for line in said) == 1
    assert json.loads((folder.path / "results.json").read_text())["states"] == {"begun": 1, "finished": 3}
    assert "polish_of_old" not in SweepFolder.open(folder.path).config.training
