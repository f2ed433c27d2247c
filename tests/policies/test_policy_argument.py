"""Files and names that are given as a policy and are something else: every program names them with the fix."""

import zipfile

import pytest
from policies import make_policy

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.policies import load_policy
from quadruped_env.policies.by_name import find_controller

PROGRAMS = (
    ("evaluate",),
    ("view",),
    ("compare", "flat"),
    ("train", "--resume"),
    ("live", "controller"),
)


def zipped(path, *names):
    with zipfile.ZipFile(path, "w") as archive:
        for name in names:
            archive.writestr(name, "")


def write_all(folder):
    """Files and folders that are no policies."""
    zipped(folder / "sb3.zip", "data", "policy.pth", "_stable_baselines3_version")
    zipped(folder / "model_100.pt", "model_100/data.pkl", "model_100/data/0")
    for name, content in {
        "walk.onnx": b"\x08\x07",
        "vecnormalize.pkl": b"\x80\x04.",
        "dog.urdf": b'<?xml version="1.0"?><robot name="dog"/>',
        "walk.mcap": b"\x89MCAP0\r\n",
    }.items():
        (folder / name).write_bytes(content)
    make_policy().save(folder / "run")
    zipped(folder / "run" / "sb3_model.zip", "data", "policy.pth")


KINDS = [
    ("sb3.zip", r"sb3.zip: this is a model of Stable-Baselines3; '.*import-policy \S*sb3.zip' makes a policy of it"),
    ("run/sb3_model.zip", r"a file of a policy's folder; name the folder, \S*run$"),
    ("run/policy.json", r"a file of a policy's folder; name the folder, \S*run$"),
    ("model_100.pt", r"a pickle, which is not opened; .* is code \(docs/training.md#a-policy-that-is-code\)"),
    ("walk.onnx", r"this is an ONNX graph; .*import-policy \S*walk.onnx'"),
    (
        "vecnormalize.pkl",
        r"a pickle, which is not opened; .*import-policy MODEL.zip --vecnormalize \S*\.pkl'",
    ),
    ("dog.urdf", r"dog.urdf: this is a URDF, not a Python file; '\S*mini-quadruped robot FILE' reads it"),
]


@pytest.mark.parametrize(("name", "message"), KINDS)
def test_file_that_is_no_policy_is_named_with_its_fix(name, message, tmp_path):
    write_all(tmp_path)
    for load in (load_policy, lambda path: find_controller(str(path))):
        with pytest.raises(QuadrupedError, match=message):
            load(tmp_path / name)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("trot", r"'trot': this is a scripted gait, which has no weights; '.*baseline --preset trot' measures it"),
        ("someone/walker", r"'someone/walker': there is no such folder; a policy of the hub is hf://someone/walker"),
        ("https://huggingface.co/someone/walker", r"a policy of the hub is hf://someone/walker"),
        ("walk.mcap", r"walk.mcap: this looks like a recording; '.*replay walk.mcap' plays it"),
        ("tests/nothing", r"'tests/nothing' is neither a directory nor a shipped policy"),
    ],
)
def test_name_that_is_no_policy_is_named_with_its_fix(name, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_all(tmp_path)
    (tmp_path / "tests").mkdir()
    with pytest.raises(QuadrupedError, match=message):
        load_policy(name)


def test_viewer_and_controller_take_gaits_and_recordings(tmp_path):
    write_all(tmp_path)
    assert find_controller("trot").name == "gait trot"
    assert find_controller(str(tmp_path / "walk.mcap")).name == "recording walk.mcap"


@pytest.mark.parametrize("program", PROGRAMS, ids=" ".join)
def test_every_program_says_what_a_zip_of_stable_baselines3_is(program, tmp_path, monkeypatch, capsys, domain_id):
    monkeypatch.chdir(tmp_path)
    write_all(tmp_path)
    assert main([*program, "sb3.zip"]) == 2
    assert "import-policy sb3.zip' makes a policy of it" in capsys.readouterr().err
