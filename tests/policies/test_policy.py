"""Trained policies: saved and loaded as data, without pickle or torch, with the numbers of torch."""

import dataclasses
import errno
import json
import os
import pickletools
import subprocess
import sys

import numpy as np
import pytest
from policies import TASK, make_policy, observations
from tasks import ACTION_WIDTH, FRAME_WIDTH, OBSERVATION_WIDTH

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.policies import load_policy
from quadruped_env.policies.files import CHECKPOINTS, SHIPPED
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE

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


def test_card_describes_the_policy(run_directory):
    document = json.loads((run_directory / CARD_FILE).read_text())
    assert document["action_mode"] == "residual"
    assert document["control_rate_hz"] == pytest.approx(1.0 / TASK.control_timestep)
    assert document["config"] == json.loads(json.dumps(TASK.to_dict()))
    assert sum(field["width"] for field in document["observation_layout"]) == FRAME_WIDTH


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
from quadruped_env.policies import Policy, load_policy
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


@pytest.mark.parametrize("count", [16, 17, 41, 152])
def test_actions_of_many_envs_are_those_of_few(count):
    """Wide layers are computed by blocks of rows."""
    policy, seen = make_policy(hidden=(128, 128)), observations((count,))
    few = [policy.predict(seen[i : i + 5]) for i in range(0, count, 5)]
    np.testing.assert_allclose(policy.predict(seen), np.concatenate(few), rtol=0, atol=1e-5)


def test_actions_stay_within_one():
    policy = make_policy()
    actions = policy.predict(50.0 * observations((100,)))
    assert actions.min() == -1.0
    assert actions.max() == 1.0


@pytest.mark.parametrize("shape", [(OBSERVATION_WIDTH + 1,), (5, OBSERVATION_WIDTH - 1), (OBSERVATION_WIDTH, 1), ()])
def test_an_observation_of_another_width_is_refused(shape):
    with pytest.raises(
        QuadrupedError, match=rf"policy: expected observations of shape \(\.\.\., {OBSERVATION_WIDTH}\)"
    ):
        make_policy().predict(np.zeros(shape))


# --- failed saves and unknown policies ---


@pytest.mark.parametrize("field", ["weights", "biases"])
def test_a_policy_with_weights_that_are_not_finite_is_not_saved(tmp_path, field):
    policy = make_policy()
    getattr(policy, field)[1][-1] = np.nan
    with pytest.raises(QuadrupedError, match=r"layer1 holds NaN or infinity, so that .*lower"):
        policy.save(tmp_path / "run")
    assert not (tmp_path / "run").exists()


def test_bound_of_the_actions_counts_the_larger_side_of_an_activation_function():
    """selu(-0.1) is -0.167, and selu(0.1) is 0.105."""
    policy = make_policy("selu", hidden=(10,))
    weights = np.zeros_like(policy.weights[0]), np.full((10, 8), 1e37 / 0.13, np.float32)
    biases = np.full(10, 0.1, np.float32), np.zeros(8, np.float32)
    with pytest.raises(QuadrupedError, match=r"here: layer1 can exceed float32"):
        dataclasses.replace(policy, weights=weights, biases=biases).check_is_data("here")


def test_files_of_a_policy_have_the_same_permissions(tmp_path):
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
        QuadrupedError,
        match=rf"'hilly' is neither a directory nor a shipped policy \({', '.join(SHIPPED)}\); train one",
    ):
        load_policy("hilly")
    with pytest.raises(QuadrupedError, match=r"neither a directory"):
        load_policy(tmp_path / "nothing")
    (tmp_path / "file").write_text("x")
    with pytest.raises(QuadrupedError, match=r"neither a directory"):
        load_policy(tmp_path / "file")
