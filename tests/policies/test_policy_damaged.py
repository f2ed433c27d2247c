"""Damaged policies: refused with the file, the field and the fix, and never loaded with other numbers."""

import errno
import json
import os
from functools import partial
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest
from policies import make_policy
from safetensors.numpy import load_file, save
from tasks import OBSERVATION_WIDTH

from quadruped_env import QuadrupedError
from quadruped_env.policies import load_policy
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE


def edit_card(directory, **changes):
    """Change fields of the saved card; a field of None is removed. A changed config gets its new hash."""
    document = json.loads((directory / CARD_FILE).read_text()) | changes
    if "config" in changes:
        document["config_sha256"] = sha256(json.dumps(changes["config"], sort_keys=True).encode()).hexdigest()
    document = {key: value for key, value in document.items() if value is not None}
    (directory / CARD_FILE).write_text(json.dumps(document))


def put_tensors(directory, content):
    """Replace the saved tensors by bytes whose hash is in the card."""
    (directory / TENSORS_FILE).write_bytes(content)
    edit_card(directory, weights_sha256=sha256(content).hexdigest())


def edit_tensors(directory, **changes):
    """Change saved tensors; a tensor of None is removed."""
    tensors = load_file(directory / TENSORS_FILE) | changes
    put_tensors(directory, save({key: value for key, value in tensors.items() if value is not None}))


def swap_tensors(directory):
    make_policy(seed=1).save(directory / "other")
    (directory / "other" / TENSORS_FILE).replace(directory / TENSORS_FILE)


def change_setting(directory):
    text = (directory / CARD_FILE).read_text()
    (directory / CARD_FILE).write_text(text.replace('"decimation": 5', '"decimation": 7'))


RESIDUAL = {"action": {"mode": "residual"}}
FILES = [
    (lambda d: (d / CARD_FILE).unlink(), r"policy.json: missing, so the run is incomplete.*finished run"),
    (lambda d: (d / TENSORS_FILE).unlink(), r"policy.safetensors: missing.*checkpoints"),
    (lambda d: (d / CARD_FILE).write_text('{"format'), r"policy.json: not valid JSON.*train again"),
    (lambda d: (d / CARD_FILE).write_bytes(b"\xff\xfe\x00\x80"), r"policy.json: not valid JSON"),
    (lambda d: (d / CARD_FILE).write_text("[]"), r"policy.json: format_version is None"),
    (change_setting, r"policy.json: its SHA-256 differs from config_sha256 in policy.json"),
    (
        lambda d: (d / TENSORS_FILE).write_bytes(b""),
        r"its SHA-256 differs from weights_sha256.*train again",
    ),
    (swap_tensors, r"policy.safetensors: its SHA-256 differs from .* or of another policy"),
    (lambda d: put_tensors(d, b"hello " * 9), r"policy.safetensors: not a safetensors.*train again"),
]
CARDS = [
    *(
        ({name: None}, f"policy.json: field '{name}' is missing.*train again")
        for name in ("weights_sha256", "config_sha256", "activation", "config", "card", "layers")
    ),
    ({"format_version": None}, r"policy.json: format_version is None"),
    ({"format_version": 99}, r"format_version is 99, and this version of the package reads 1; train again"),
    ({"activation": "step"}, r"policy.json: activation 'step' is not one of tanh"),
    ({"activation": ["elu"]}, r"policy.json: activation"),
    ({"card": "flat"}, r"policy.json: card must be a table of facts; found 'flat'"),
    ({"layers": "three"}, r"policy.json: layers must be .*found 'three'"),
    ({"layers": 0}, r"policy.json: layers must be .*found 0"),
    ({"layers": 2}, r"policy.safetensors: the last layer has 12 outputs; expected 8"),
    ({"layers": 4}, r"policy.safetensors: layer3.weight must have shape \(8, "),
    ({"observation_layout": []}, r"policy.json: observation_layout differs"),
    ({"config": RESIDUAL, "scripted_gait": {"largest_yaw_rate": 0.5}}, r"scripted_gait differs from this.*train again"),
    ({"config": RESIDUAL, "scripted_gait": None}, r"policy.json: scripted_gait differs"),
    ({"config": {"decimation": 0}}, r"policy.json: .*decimation must be a whole number from 1 to 1000; found 0"),
    ({"config": {"tempo": 1}, "scripted_gait": None}, r"policy.json: config: unknown field 'tempo'"),
    (
        {"config": {"reward": {"weights": {"tempo": 1}}}, "scripted_gait": None},
        r"policy.json: config.reward.weights: unknown field 'tempo'",
    ),
    ({"config": [1]}, r"policy.json: config: expected a mapping"),
]
TENSORS = [
    (
        {"layer1.weight": np.full((16, 12), np.nan, np.float32)},
        r"layer1 holds NaN or .* the training diverged",
    ),
    ({"layer2.bias": np.full(8, np.inf, np.float32)}, r"layer2 holds NaN or infinity"),
    ({"layer1.weight": None}, r"layer1.weight must have shape"),
    ({"layer1.bias": None}, r"layer1.weight must have .*bias"),
    (
        {"layer0.weight": np.zeros((3, 16), np.float32)},
        rf"layer0.weight must have shape \({OBSERVATION_WIDTH}, outputs\).*found \(3, 16\)",
    ),
    ({"layer0.bias": np.zeros((16, 1), np.float32)}, r"layer0"),
    ({"layer0.bias": np.zeros((), np.float32)}, r"layer0"),
    ({"layer0.weight": np.zeros((OBSERVATION_WIDTH, 16), np.int64)}, r"layer0.*int64"),
]
DAMAGES = [
    *FILES,
    *((partial(edit_card, **changes), message) for changes, message in CARDS),
    *((partial(edit_tensors, **changes), f"policy.safetensors: {message}") for changes, message in TENSORS),
]


@pytest.mark.parametrize(("damage", "message"), DAMAGES)
def test_damaged_run_is_refused_with_the_file_the_field_and_the_fix(run_directory, damage, message):
    damage(run_directory)
    with pytest.raises(QuadrupedError, match=message) as caught:
        load_policy(run_directory)
    assert str(run_directory) in str(caught.value)


@pytest.mark.parametrize("name", [TENSORS_FILE, CARD_FILE])
def test_a_damaged_policy_never_loads_with_other_weights_or_settings(run_directory, name):
    path, policy = run_directory / name, make_policy()
    data, rng = path.read_bytes(), np.random.default_rng(0)
    for _ in range(100):
        damaged = bytearray(data)
        for at in rng.integers(0, len(data), rng.integers(1, 4)):
            damaged[at] ^= 1 << int(rng.integers(0, 8))
        path.write_bytes(damaged)
        try:
            loaded = load_policy(run_directory)
        except QuadrupedError:
            continue
        assert loaded.config == policy.config
        assert loaded.activation == policy.activation
        for one, other in zip(loaded.weights + loaded.biases, policy.weights + policy.biases, strict=True):
            np.testing.assert_array_equal(one, other)


def test_weights_on_a_disk_that_fails_are_refused(run_directory, monkeypatch):
    opened = Path.open

    def fail(path, *arguments):
        if path.name == TENSORS_FILE:
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        return opened(path, *arguments)

    monkeypatch.setattr(Path, "open", fail)
    with pytest.raises(QuadrupedError, match=r"policy\.safetensors: cannot be read \(Input/output error\)"):
        load_policy(run_directory)


def test_weights_that_are_a_device_are_refused(run_directory):
    weights = run_directory / TENSORS_FILE
    weights.unlink()
    weights.symlink_to(os.devnull)
    with pytest.raises(QuadrupedError, match="name the directory of a finished run"):
        load_policy(run_directory)


def test_directory_of_runs_names_one_of_them(tmp_path):
    (tmp_path / "runs" / "one").mkdir(parents=True)
    (tmp_path / "runs" / "one" / CARD_FILE).write_text("{}")
    with pytest.raises(QuadrupedError, match=r"runs: is not a run, and holds runs; name one, such as .*runs/one$"):
        load_policy(tmp_path / "runs")
