"""Damaged policies: refused with the file, the field and the fix, and never loaded with other numbers."""

import errno
import json
import os
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

POSITION = {"action": {"mode": "position"}}


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
    """Change saved tensors, `__` in their names standing for a dot; a tensor of None is removed."""
    tensors = load_file(directory / TENSORS_FILE) | {key.replace("__", "."): value for key, value in changes.items()}
    put_tensors(directory, save({key: value for key, value in tensors.items() if value is not None}))


def damage(path, keep=100):
    path.write_bytes(path.read_bytes()[:keep])


def other_policy(directory):
    make_policy(seed=1).save(directory / "other")
    (directory / "other" / TENSORS_FILE).replace(directory / TENSORS_FILE)


def change_setting(directory, old, new):
    text = (directory / CARD_FILE).read_text()
    assert text.count(old) == 1
    (directory / CARD_FILE).write_text(text.replace(old, new))


NARROW = np.zeros((3, 16), dtype=np.float32)
DAMAGES = {
    "no card": (lambda d: (d / CARD_FILE).unlink(), r"policy.json: missing, so the run is incomplete.*finished run"),
    "no tensors": (lambda d: (d / TENSORS_FILE).unlink(), r"policy.safetensors: missing.*checkpoints"),
    "cut card": (lambda d: damage(d / CARD_FILE), r"policy.json: not valid JSON.*train again"),
    "binary card": (lambda d: (d / CARD_FILE).write_bytes(b"\xff\xfe\x00\x80"), r"policy.json: not valid JSON"),
    "empty card": (lambda d: (d / CARD_FILE).write_text(""), r"policy.json: not valid JSON"),
    "card is a list": (lambda d: (d / CARD_FILE).write_text("[]"), r"policy.json: format_version is None"),
    "cut tensors": (
        lambda d: damage(d / TENSORS_FILE),
        r"policy.safetensors: its SHA-256 differs from weights_sha256 in policy.json; the file is damaged.*train again",
    ),
    "empty tensors": (lambda d: damage(d / TENSORS_FILE, 0), r"policy.safetensors: its SHA-256 differs"),
    "another policy's tensors": (other_policy, r"policy.safetensors: its SHA-256 differs from .* or of another policy"),
    "text tensors": (lambda d: put_tensors(d, b"hello " * 9), r"policy.safetensors: not a safetensors.*train again"),
    "no hash": (lambda d: edit_card(d, weights_sha256=None), r"policy.json: field 'weights_sha256' is missing"),
    "no hash of the config": (lambda d: edit_card(d, config_sha256=None), r"policy.json: field 'config_sha256' is mis"),
    "other setting": (
        lambda d: change_setting(d, '"decimation": 5', '"decimation": 7'),
        r"policy.json: its SHA-256 differs from config_sha256 in policy.json",
    ),
    "no version": (lambda d: edit_card(d, format_version=None), r"policy.json: format_version is None"),
    "other version": (
        lambda d: edit_card(d, format_version=99),
        r"policy.json: format_version is 99, and this version of the package reads 1; train again",
    ),
    "no activation": (lambda d: edit_card(d, activation=None), r"policy.json: field 'activation' is missing"),
    "no config": (lambda d: edit_card(d, config=None), r"policy.json: field 'config' is missing.*train again"),
    "no card field": (lambda d: edit_card(d, card=None), r"policy.json: field 'card' is missing"),
    "no layers": (lambda d: edit_card(d, layers=None), r"policy.json: field 'layers' is missing"),
    "unknown activation": (
        lambda d: edit_card(d, activation="step"),
        r"policy.json: activation 'step' is not one of tanh",
    ),
    "activation a list": (lambda d: edit_card(d, activation=["elu"]), r"policy.json: activation"),
    "layers a word": (lambda d: edit_card(d, layers="three"), r"policy.json: layers must be .*found 'three'"),
    "card a word": (lambda d: edit_card(d, card="flat"), r"policy.json: card must be a table of facts; found 'flat'"),
    "layers zero": (lambda d: edit_card(d, layers=0), r"policy.json: layers must be .*found 0"),
    "layers too few": (
        lambda d: edit_card(d, layers=2),
        r"policy.safetensors: the last layer has 12 outputs; expected 8",
    ),
    "layers too many": (lambda d: edit_card(d, layers=4), r"policy.safetensors: layer3.weight must have shape \(8, "),
    "other layout": (lambda d: edit_card(d, observation_layout=[]), r"policy.json: observation_layout differs"),
    "other gait": (
        lambda d: edit_card(d, config={"action": {"mode": "residual"}}, scripted_gait={"largest_yaw_rate": 0.5}),
        r"policy.json: scripted_gait differs from this version's.*train again",
    ),
    "residual without its gait": (
        lambda d: edit_card(d, config={"action": {"mode": "residual"}}, scripted_gait=None),
        r"policy.json: scripted_gait differs",
    ),
    "bad config": (
        lambda d: edit_card(d, config={"decimation": 0}),
        r"policy.json: .*decimation must be a whole number from 1 to 1000; found 0",
    ),
    "config of another version": (
        lambda d: edit_card(d, config=POSITION | {"tempo": 1}, scripted_gait=None),
        r"policy.json: config: unknown field 'tempo'",
    ),
    "term of another version": (
        lambda d: edit_card(d, config=POSITION | {"reward": {"weights": {"tempo": 1}}}, scripted_gait=None),
        r"policy.json: config.reward.weights: unknown field 'tempo'",
    ),
    "config a list": (lambda d: edit_card(d, config=[1]), r"policy.json: config: expected a mapping"),
    "NaN": (
        lambda d: edit_tensors(d, layer1__weight=np.full((16, 12), np.nan, np.float32)),
        r"policy.safetensors: layer1 holds NaN or infinity, so that joint targets become NaN; the training diverged",
    ),
    "infinite bias": (
        lambda d: edit_tensors(d, layer2__bias=np.full(8, np.inf, np.float32)),
        r"policy.safetensors: layer2 holds NaN or infinity",
    ),
    "no weight": (lambda d: edit_tensors(d, layer1__weight=None), r"policy.safetensors: layer1.weight must have shape"),
    "no bias": (lambda d: edit_tensors(d, layer1__bias=None), r"policy.safetensors: layer1.weight must have .*bias"),
    "narrow": (
        lambda d: edit_tensors(d, layer0__weight=NARROW),
        rf"policy.safetensors: layer0.weight must have shape \({OBSERVATION_WIDTH}, outputs\).*found \(3, 16\)",
    ),
    "bias of two axes": (
        lambda d: edit_tensors(d, layer0__bias=np.zeros((16, 1), np.float32)),
        r"policy.safetensors: layer0",
    ),
    "bias a scalar": (lambda d: edit_tensors(d, layer0__bias=np.zeros((), np.float32)), r"layer0"),
    "words": (
        lambda d: edit_tensors(d, layer0__weight=np.zeros((OBSERVATION_WIDTH, 16), np.int64)),
        r"policy.safetensors: layer0.*int64",
    ),
}


@pytest.mark.parametrize("name", DAMAGES)
def test_damaged_run_is_refused_with_the_file_the_field_and_the_fix(run_directory, name):
    break_it, message = DAMAGES[name]
    break_it(run_directory)
    with pytest.raises(QuadrupedError, match=message) as caught:
        load_policy(run_directory)
    assert str(run_directory) in str(caught.value)


@pytest.mark.parametrize("name", [TENSORS_FILE, CARD_FILE])
def test_a_damaged_policy_never_loads_with_other_weights_or_settings(run_directory, name):
    path, policy = run_directory / name, make_policy()
    data, rng = path.read_bytes(), np.random.default_rng(0)
    for _ in range(300):
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
    read = Path.read_bytes

    def fail(path):
        if path.name == TENSORS_FILE:
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        return read(path)

    monkeypatch.setattr(Path, "read_bytes", fail)
    with pytest.raises(QuadrupedError, match=r"policy\.safetensors: cannot be read \(Input/output error\)"):
        load_policy(run_directory)


def test_weights_that_are_a_device_are_refused(run_directory):
    weights = run_directory / TENSORS_FILE
    weights.unlink()
    weights.symlink_to(os.devnull)
    with pytest.raises(QuadrupedError, match="name the directory of a finished run"):
        load_policy(run_directory)


def test_directory_of_runs_in_place_of_a_run_names_one(tmp_path):
    (tmp_path / "runs" / "one").mkdir(parents=True)
    (tmp_path / "runs" / "one" / CARD_FILE).write_text("{}")
    with pytest.raises(QuadrupedError, match=r"runs: is not a run, and holds runs; name one, such as .*runs/one$"):
        load_policy(tmp_path / "runs")
