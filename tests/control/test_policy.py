"""Trained policies: saved and loaded as data, without pickle or torch, with torch's numbers, and checked."""

import dataclasses
import errno
import itertools
import json
import os
import pickletools
import subprocess
import sys
from hashlib import sha256

import numpy as np
import pytest
from gymnasium import make, make_vec
from safetensors.numpy import load_file, save
from tasks import ACTION_WIDTH, OBSERVATION_WIDTH

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.control.policy import ACTIVATIONS, CARD_FILE, CHECKPOINTS, SHIPPED, TENSORS_FILE
from quadruped_env.envs import ENV_ID
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.policies import Policy, PolicyController, load_policy
from quadruped_env.task import TaskConfig

TASK = TaskConfig.from_dict({"action": {"mode": "residual"}, "decimation": 5})


def make_policy(activation="elu", hidden=(16, 12), seed=0):
    rng = np.random.default_rng(seed)
    widths = (OBSERVATION_WIDTH, *hidden, ACTION_WIDTH)
    return Policy(
        weights=tuple(
            rng.standard_normal((a, b)).astype(np.float32) / np.float32(a**0.5) for a, b in itertools.pairwise(widths)
        ),
        biases=tuple(0.1 * rng.standard_normal(b).astype(np.float32) for b in widths[1:]),
        activation=activation,
        config=TASK,
        card={"command": "python train/ppo.py", "seed": 3, "metrics": {"return": 1.5}},
    )


def observations(shape=(), seed=0):
    return np.random.default_rng(seed).uniform(-1, 1, (*shape, OBSERVATION_WIDTH)).astype(np.float32)


@pytest.fixture
def run_directory(tmp_path):
    """The directory of a saved policy."""
    make_policy().save(tmp_path / "run")
    return tmp_path / "run"


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


# --- saving and loading ---


def test_a_policy_comes_back_as_it_was_saved(run_directory):
    policy, loaded = make_policy(), load_policy(run_directory)
    for one, other in zip((*loaded.weights, *loaded.biases), (*policy.weights, *policy.biases), strict=True):
        assert one.dtype == np.float32
        np.testing.assert_array_equal(one, other)
    assert loaded.config == policy.config == TASK
    assert loaded.card == policy.card
    assert loaded.activation == policy.activation
    assert loaded.action_mode == "residual"
    np.testing.assert_array_equal(loaded.predict(observations((5,))), policy.predict(observations((5,))))
    assert load_policy(str(run_directory)).card == policy.card


def test_saving_twice_gives_the_same_bytes(run_directory, tmp_path):
    load_policy(run_directory).save(tmp_path / "again")
    for name in (CARD_FILE, TENSORS_FILE):
        assert (tmp_path / "again" / name).read_bytes() == (run_directory / name).read_bytes()


def test_card_describes_the_policy(run_directory):
    document = json.loads((run_directory / CARD_FILE).read_text())
    assert document["action_mode"] == "residual"
    assert document["control_rate_hz"] == pytest.approx(1.0 / TASK.control_timestep)
    assert document["config"] == json.loads(json.dumps(TASK.to_dict()))
    assert sum(field["width"] for field in document["observation_layout"]) == OBSERVATION_WIDTH


def test_a_policys_files_hold_no_pickle(run_directory):
    assert sorted(path.name for path in run_directory.iterdir()) == [CARD_FILE, TENSORS_FILE]
    json.loads((run_directory / CARD_FILE).read_text())
    tensors = (run_directory / TENSORS_FILE).read_bytes()
    header = json.loads(tensors[8 : 8 + int.from_bytes(tensors[:8], "little")])
    assert all(entry["dtype"] == "F32" for name, entry in header.items() if name != "__metadata__")
    assert tensors[:2] != b"PK", "not a zip, in which torch stores a pickle"
    with pytest.raises(ValueError, match=r"."):
        list(pickletools.genops(tensors))


def test_a_policy_is_loaded_and_run_without_torch_and_stable_baselines3(run_directory, tmp_path):
    np.save(tmp_path / "observations.npy", observations((4,)))
    code = """
import sys
for name in ("torch", "stable_baselines3", "pickle5", "tensorboard"):
    sys.modules[name] = None
import numpy as np
from quadruped_env.policies import load_policy
policy = load_policy(sys.argv[1])
np.save(sys.argv[3], policy.predict(np.load(sys.argv[2])))
"""
    arguments = [str(path) for path in (run_directory, tmp_path / "observations.npy", tmp_path / "actions.npy")]
    subprocess.run([sys.executable, "-c", code, *arguments], check=True)
    np.testing.assert_array_equal(np.load(tmp_path / "actions.npy"), make_policy().predict(observations((4,))))


# --- predicting ---


@pytest.mark.parametrize("shape", [(), (1,), (7,), (3, 2), (0,)])
def test_actions_have_the_leading_shape_of_the_observations(shape):
    policy = make_policy()
    actions = policy.predict(observations(shape))
    assert actions.shape == (*shape, ACTION_WIDTH)
    assert actions.dtype == np.float32
    for index in np.ndindex(*shape):
        np.testing.assert_allclose(actions[index], policy.predict(observations(shape)[index]), atol=1e-6)


def test_actions_stay_within_one():
    policy = make_policy()
    actions = policy.predict(50.0 * observations((100,)))
    assert actions.min() == -1.0
    assert actions.max() == 1.0


def test_predict_accepts_any_kind_of_number_and_does_not_change_it():
    policy, observation = make_policy(), observations((2,))
    kept = observation.copy()
    np.testing.assert_array_equal(policy.predict(observation.tolist()), policy.predict(observation))
    np.testing.assert_array_equal(policy.predict(observation.astype(np.float64)), policy.predict(observation))
    np.testing.assert_array_equal(observation, kept)


@pytest.mark.parametrize("shape", [(OBSERVATION_WIDTH + 1,), (5, OBSERVATION_WIDTH - 1), (OBSERVATION_WIDTH, 1), ()])
def test_an_observation_of_another_width_is_refused(shape):
    with pytest.raises(
        QuadrupedError, match=rf"policy: expected observations of shape \(\.\.\., {OBSERVATION_WIDTH}\)"
    ):
        make_policy().predict(np.zeros(shape))


@pytest.mark.parametrize("symmetric", [True, False])
@pytest.mark.parametrize("activation", ACTIVATIONS)
def test_an_exported_policy_predicts_what_stable_baselines3_does(activation, symmetric, tmp_path):
    import torch

    from quadruped_env.envs import make_sb3_vec_env
    from quadruped_env.training import TrainConfig
    from quadruped_env.training.ppo import export_policy, make_model

    torch.manual_seed(0)
    config = TrainConfig(
        activation=activation, symmetric=symmetric, num_envs=4, n_steps=16, batch_size=64, hidden=(32, 24, 16)
    )
    env = make_sb3_vec_env(4, seed=0, config=TASK)
    model = make_model(config, env)
    with torch.no_grad():
        # At initialization, the last layer is almost zero and the biases are zero.
        for parameter in model.policy.parameters():
            parameter.add_(0.3 * torch.randn_like(parameter))
    export_policy(model, TASK, activation, {"seed": 0}).save(tmp_path)
    policy = load_policy(tmp_path)
    sides = 2 if symmetric else 1
    assert [weight.shape[1] for weight in policy.weights] == [32 * sides, 24 * sides, 16 * sides, ACTION_WIDTH]
    assert policy.activation == activation
    observation = np.concatenate([env.reset(), 3.0 * observations((200,))])
    expected, _ = model.predict(observation, deterministic=True)
    np.testing.assert_allclose(policy.predict(observation), expected, atol=1e-5)
    inside = abs(expected) < 1.0
    assert inside.any(axis=1).mean() > 0.5, "most actions must not be clipped"


# --- bad directories ---


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
        lambda d: edit_card(d, activation="gelu"),
        r"policy.json: activation 'gelu' is not one of tanh",
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
        lambda d: edit_card(d, config={"action": {"mode": "residual"}}, scripted_gait={"half_track": 0.5}),
        r"policy.json: scripted_gait differs from this version's.*train again",
    ),
    "residual without its gait": (
        lambda d: edit_card(d, config={"action": {"mode": "residual"}}, scripted_gait=None),
        r"policy.json: scripted_gait differs",
    ),
    "bad config": (
        lambda d: edit_card(d, config={"decimation": 0}),
        r"policy.json: .*decimation must be 1 or more; found 0",
    ),
    "config of another version": (
        lambda d: edit_card(d, config=POSITION | {"tempo": 1}, scripted_gait=None),
        r"policy.json: config: unknown field 'tempo'",
    ),
    "config a list": (lambda d: edit_card(d, config=[1]), r"policy.json: config: expected a mapping"),
    "NaN": (
        lambda d: edit_tensors(d, layer1__weight=np.full((16, 12), np.nan, np.float32)),
        r"policy.safetensors: layer1 holds NaN or infinity; the training diverged",
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
    "bias a scalar": (
        lambda d: edit_tensors(d, layer0__bias=np.zeros((), np.float32)),
        r"layer0",
    ),
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


@pytest.mark.parametrize("field", ["weights", "biases"])
def test_a_policy_with_weights_that_are_not_finite_is_not_saved(tmp_path, field):
    policy = make_policy()
    getattr(policy, field)[1][-1] = np.nan
    with pytest.raises(QuadrupedError, match=r"layer1 holds NaN or infinity, so it is not saved.*lower"):
        policy.save(tmp_path / "run")
    assert not (tmp_path / "run").exists()


def test_the_files_of_a_policy_have_the_same_rights(tmp_path):
    make_policy().save(tmp_path)
    (tmp_path / "neighbour").touch()
    assert len({path.stat().st_mode for path in tmp_path.iterdir()}) == 1


def test_save_on_a_full_disk_keeps_the_old_policy(run_directory, monkeypatch):
    def fsync(descriptor):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", fsync)
    with pytest.raises(QuadrupedError, match=r"cannot be written \(No space left on device\); make room"):
        make_policy(seed=1).save(run_directory)
    np.testing.assert_array_equal(load_policy(run_directory).weights[0], make_policy().weights[0])


def test_killed_run_loads_its_last_checkpoint_with_a_warning(tmp_path):
    for seed, name in enumerate(["00060s", "99980s", "100000s"]):
        make_policy(seed=seed).save(tmp_path / "run" / CHECKPOINTS / name)
    (tmp_path / "run" / CHECKPOINTS / "100020s").mkdir()
    with pytest.warns(QuadrupedWarning, match=r"run: the training was killed .*: checkpoints/100000s$"):
        policy = load_policy(tmp_path / "run")
    np.testing.assert_array_equal(policy.weights[0], make_policy(seed=2).weights[0])
    make_policy(seed=5).save(tmp_path / "run")
    np.testing.assert_array_equal(load_policy(tmp_path / "run").weights[0], make_policy(seed=5).weights[0])


def test_an_unknown_policy_names_the_shipped_ones_and_how_to_train(tmp_path):
    with pytest.raises(
        QuadrupedError, match=r"'hilly' is neither a directory nor a shipped policy \(flat\); train one"
    ):
        load_policy("hilly")
    with pytest.raises(QuadrupedError, match=r"neither a directory"):
        load_policy(tmp_path / "nothing")
    (tmp_path / "file").write_text("x")
    with pytest.raises(QuadrupedError, match=r"neither a directory"):
        load_policy(tmp_path / "file")


def test_a_policy_does_not_change():
    with pytest.raises(dataclasses.FrozenInstanceError):
        make_policy().activation = "relu"


# --- the shipped policies ---


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_policy_follows_its_velocity_commands(name):
    policy = load_policy(name)
    assert {"command", "seed", "versions", "git_commit"} <= set(policy.card)
    env = make_vec(ENV_ID, num_envs=16, action_mode=policy.action_mode, config=policy.config)
    for command in ((0.4, 0.0), (-0.2, 0.0), (0.0, 0.0), (0.2, 0.5)):
        observation, _ = env.reset(seed=0, options={"command": command})
        velocities = []
        for _ in range(150):
            observation, _, terminated, _, info = env.step(policy.predict(observation))
            assert not terminated.any(), command
            velocities.append([info["base_linear_velocity"][:, 0], info["base_angular_velocity"][:, 2]])
        forward, turning = np.mean(velocities[50:], axis=(0, 2))
        assert forward == pytest.approx(command[0], abs=0.15)
        assert turning == pytest.approx(command[1], abs=0.3)


# --- the environment of a policy ---


def test_make_env_makes_the_task_that_the_policy_was_trained_for():
    policy = make_policy()
    env = policy.make_env(render_mode="rgb_array", max_episode_steps=7)
    assert env.unwrapped.task.config == TASK
    assert env.unwrapped.dt == pytest.approx(0.025)
    assert env.render_mode == "rgb_array"
    assert env.spec.max_episode_steps == 7
    assert make(env.spec).unwrapped.task.config == TASK
    policy.check_env(env)
    env.close()


def test_make_vec_env_makes_num_envs_envs_of_the_policys_task():
    policy = make_policy()
    env = policy.make_vec_env(3, max_episode_steps=7)
    assert env.num_envs == 3
    assert env.unwrapped.task.config == TASK
    policy.check_env(env)
    env.close()


@pytest.mark.parametrize("name", ["action_mode", "config"])
def test_make_env_with_another_task_is_refused(name):
    for call in (make_policy().make_env, lambda **kwargs: make_policy().make_vec_env(2, **kwargs)):
        with pytest.raises(QuadrupedError, match=f"policy.make_env: {name} is given by the policy"):
            call(**{name: None})


@pytest.mark.parametrize(
    ("config", "message"),
    [
        ({}, "action.mode 'residual', and this environment has 'position'"),
        ({"action": {"mode": "residual"}}, r"control_timestep 0\.025, and this environment has 0\.02"),
        ({"action": {"mode": "residual", "residual_scale": 0.2}, "decimation": 5}, r"residual_scale 0\.4, .* has 0\.2"),
        (
            {"action": {"mode": "residual"}, "decimation": 5, "clock_frequency": 3.0},
            r"clock_frequency 2\.2, .* has 3\.0",
        ),
    ],
)
def test_task_with_another_meaning_of_actions_is_refused(config, message):
    policy = make_policy()
    env = make(ENV_ID, config=config)
    with pytest.raises(QuadrupedError, match=f"{message}; make its own with policy.make_env"):
        policy.check_env(env)
    controller = PolicyController(policy)
    controller.action_mode = env.unwrapped.task.config.action.mode
    with pytest.raises(QuadrupedError, match=message):
        roll_out(controller, [(0.3, 0.0)], [0], 1.0, env.unwrapped.task.config)
    env.close()


def test_task_that_differs_without_changing_actions_is_accepted():
    values = TASK.to_dict() | {"randomization": {"payload": (0.0, 1.0)}, "motor": {"delay": 0.01}}
    make_policy().check_task(TaskConfig.from_dict(values))


def test_check_env_of_another_environment_is_refused():
    env = make("CartPole-v1")
    with pytest.raises(
        QuadrupedError, match=r"is not an environment of this package; make one with policy.make_env\(\)"
    ):
        make_policy().check_env(env)
    env.close()
