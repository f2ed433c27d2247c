"""NumPy's functions on torch tensors against NumPy, and a whole task on tensors against the same task on arrays."""

import dataclasses
import gc
import math

import numpy as np
import pytest

torch = pytest.importorskip("torch", reason="torch is not installed: pip install -e '.[gpu]'")

from torch_driver import TorchDriver  # noqa: E402

from quadruped_env import QuadrupedError  # noqa: E402
from quadruped_env.robot import MINI_QUADRUPED  # noqa: E402
from quadruped_env.scale.gpu import torch_arrays  # noqa: E402
from quadruped_env.scale.gpu.torch_arrays import TensorArray, UnsupportedError  # noqa: E402
from quadruped_env.simulation import BatchSimulation  # noqa: E402
from quadruped_env.task import BUILT_IN, Task, TaskConfig, load_task_file, preset_values  # noqa: E402
from quadruped_env.task.randomization.draws import Draws, Purposes  # noqa: E402
from quadruped_env.utils.arrays import frozen  # noqa: E402

LIKE = TensorArray(torch.zeros(1))
RNG = np.random.default_rng(0)
X, Y = RNG.uniform(0.1, 2.0, (2, 5, 3)) * RNG.choice([-1.0, 1.0], (2, 5, 3))
MASK = X > 0.0
COUNTS = RNG.integers(-9, 9, (5, 3))
WORDS = RNG.integers(0, 2**64, (5, 3), dtype=np.uint64)
INDEX = np.array([4, 0, 2])


def on(array):
    return np.asarray(array, like=LIKE) if isinstance(array, np.ndarray) else array


def assert_same(function, *arrays, exact=False):
    """A function gives the same type and values for arrays of both kinds, also if only one argument is a tensor."""
    expected = function(*arrays)
    mixed = [(on(arrays[0]), *arrays[1:]), (*arrays[:-1], on(arrays[-1]))] if len(arrays) > 1 else []
    for inputs in (tuple(map(on, arrays)), *mixed):
        found = function(*inputs)
        values = found.numpy() if isinstance(found, TensorArray) else found
        if isinstance(expected, np.ndarray):
            assert isinstance(found, TensorArray)
            assert found.dtype == expected.dtype
            assert found.shape == expected.shape
        np.testing.assert_allclose(values, expected, rtol=0.0 if exact else 1e-14, atol=0.0 if exact else 1e-14)


UNARY = ["negative", "absolute", "sign", "exp", "sin", "cos", "tanh", "floor", "ceil", "rint", "isfinite", "square"]
BINARY = ["add", "subtract", "multiply", "divide", "remainder", "arctan2", "hypot", "copysign", "maximum", "minimum"]
COMPARISONS = ["less", "less_equal", "greater", "greater_equal", "equal", "not_equal", "fmax", "fmin", "vecdot"]


def test_ufuncs_as_numpy():
    for name in UNARY:
        assert_same(getattr(np, name), X)
    for name in BINARY + COMPARISONS:
        assert_same(getattr(np, name), X, Y)
    for name in ("sqrt", "log", "log1p"):
        assert_same(getattr(np, name), np.abs(X))


@pytest.mark.parametrize(
    "function",
    [
        lambda x: 2.0 * x,
        lambda x: x / 3,
        lambda x: np.array(0.5) - x,
        lambda x: np.float64(0.5) + x,
        lambda x: -x % math.tau,
        lambda x: x**2,
        lambda x: np.add.reduce(x, -1),
        lambda x: np.add.reduce(x, axis=0),
        lambda x: np.maximum.reduce(x, -1),
        lambda x: x.sum(axis=1, keepdims=True),
        lambda x: x.max(axis=1, keepdims=True),
        lambda x: x.mean(axis=0),
        lambda x: x.T,
        lambda x: x.transpose(1, 0),
        lambda x: x.reshape(3, 5),
        lambda x: x.reshape(-1, 1),
        lambda x: x[:, None, 1:],
        lambda x: x[INDEX],
        lambda x: x[INDEX[:, None], np.array([0, 2])],
        lambda x: x[MASK],
        lambda x: x.astype(np.float32),
        lambda x: np.swapaxes(x, 0, 1),
        lambda x: np.stack([x, 2.0 * x], axis=-1),
        lambda x: np.concatenate([x, x], axis=1),
        lambda x: np.clip(x, -0.5, 0.5),
        lambda x: np.where(x > 0.0, x, 0.0),
        lambda x: np.where(x > 0.0, 1.0, 0.0),
        lambda x: np.zeros_like(x, shape=(len(x), 2)),
        np.ones_like,
        lambda x: np.full_like(x[:, 0], 2.6),
        lambda x: np.interp(x[:, 0], (-1.0, 0.0, 0.5), (3.0, 1.0, 2.0)),
        lambda x: np.cross(x, np.array([0.0, 0.0, 1.0])),
        lambda x: np.take_along_axis(np.arange(12.0).reshape(4, 3), (x[:, :1] > 0.0).astype(np.int64) + 1, axis=0),
        lambda x: np.arange(4, like=x),
        lambda x: np.zeros((2, 3), np.bool_, like=x),
        lambda x: np.asarray([[1, 2]], np.float64, like=x),
        lambda x: np.einsum("ij,kj->ik", x, np.eye(3)),
        lambda x: np.broadcast_to(x[None], (2, 5, 3)),
        lambda x: np.flatnonzero(x > 0.0),
        lambda x: np.count_nonzero(x > 0.0),
        lambda x: np.argwhere(x > 1.5),
        lambda x: np.any(x > 0.0, axis=-1),
        lambda x: np.split(x[:, :2], 2, axis=1)[1],
        np.shape,
    ],
)
def test_function_of_array_as_numpy(function):
    assert_same(function, X)


@pytest.mark.parametrize(
    "function",
    [
        lambda n: n * 0.02,
        lambda n: np.maximum(n - 1, 0) * 0.02,
        lambda n: n / 2,
        lambda n: n % 4,
        lambda n: (n - 1) % 4,
        lambda n: n >= 0.5,
        lambda n: n.astype(np.float64),
    ],
)
def test_function_of_whole_numbers_as_numpy(function):
    """Torch's own rules would compute some of these in float32."""
    assert_same(function, COUNTS, exact=True)


@pytest.mark.parametrize(
    "function",
    [
        lambda w: w + np.uint64(2**63 + 5),
        lambda w: w * np.uint64(0x9E3779B97F4A7C15),
        lambda w: w >> np.uint64(30),
        lambda w: (w >> np.uint64(11)).astype(np.float64),
        lambda w: w ^ WORDS[::-1],
    ],
)
def test_unsigned_arithmetic_has_numpys_bits(function):
    expected, found = function(WORDS), function(on(WORDS))
    assert found.dtype == expected.dtype
    np.testing.assert_array_equal(found.numpy(), expected)


def test_out_and_where_write_in_place():
    for views in ((X.copy(), Y.copy()), (on(X), on(Y))):
        x, y = views
        np.sin(x[:, 0], y[:, 1])
        np.multiply(x, y, out=x)
        np.copyto(x[:, 2], 7.0, where=y[:, 0] > 0.0)
        np.divide(x, y, out=y, where=y > 0.0)
        x += y
        x[INDEX] += 1.0
        x[MASK] = 0.0
        x[:, 1] = MASK[:, 0]
        if isinstance(x, np.ndarray):
            expected = x, y
    np.testing.assert_allclose((x.numpy(), y.numpy()), expected, rtol=1e-14)


def test_take_clips_indices():
    found, expected = np.zeros((4, 3), like=LIKE), np.zeros((4, 3))
    indices = np.array([0, 2, 9, 4])
    on(X).take(on(indices), 0, found, "clip")
    X.take(indices, 0, expected, "clip")
    np.testing.assert_array_equal(found.numpy(), expected)


def test_function_without_counterpart_is_named():
    with pytest.raises(UnsupportedError, match=r"numpy\.median is not available .*--device cpu"):
        np.median(on(X))
    with pytest.raises(UnsupportedError, match=r"numpy\.arcsin is not available"):
        np.arcsin(on(X))
    with pytest.raises(UnsupportedError, match="conversion to a NumPy array"):
        np.asarray(on(X))


def test_read_only_array_is_copied_to_the_device_once():
    before = len(torch_arrays._CONSTANTS)
    constant = frozen(np.arange(3.0))
    x = on(X)
    first = x * constant
    assert len(torch_arrays._CONSTANTS) == before + 1
    np.testing.assert_array_equal((x * constant).numpy(), first.numpy())
    assert len(torch_arrays._CONSTANTS) == before + 1
    del constant
    gc.collect()
    assert len(torch_arrays._CONSTANTS) == before
    # One that may change is copied each time.
    changing = np.arange(3.0)
    np.testing.assert_array_equal((x * changing).numpy(), X * changing)
    changing[:] = 5.0
    np.testing.assert_array_equal((x * changing).numpy(), X * 5.0)


def test_draws_are_bit_identical():
    purposes = Purposes({"one": 2, "other": 3})
    both = []
    for like in (X, LIKE):
        draws = Draws(6, like)
        for env_id in range(6):
            draws.set_key(env_id, np.random.default_rng(env_id))
        for env_ids in (np.arange(6), np.array([1, 4])):
            draws.begin_episode(np.asarray(env_ids, like=like))
        env_ids, steps = (np.asarray(values, np.int64, like=like) for values in ([1, 2, 5], [0, 5, 999]))
        both.append(np.array(draws.uniform(purposes, env_ids, steps).tolist()))
    np.testing.assert_array_equal(*both)
    assert np.unique(both[0]).size == both[0].size


TASK_FILE = """
from quadruped_env.task import ModelField, Randomization, reward
import numpy as np

stiffness = Randomization("stiffness", ModelField("jnt_stiffness"), (0.0, 0.5), law="normal")


@reward(weight=-0.1)
def leaning(context):
    return np.sqrt(np.sum(context.readings.up_b[:, :2] ** 2, axis=-1)) * np.where(context.moving > 0.5, 1.0, 0.5)
"""


OFTEN = {"push_interval": [0.2, 0.6], "push_force_interval": [0.2, 0.6], "push_force_duration": [0.1, 0.3]}


def configs():
    clock = {"speeds": [0.0, 0.6], "frequencies": [2.6, 3.2]}
    return {
        "hard": {"randomization": {**preset_values("hard", MINI_QUADRUPED), **OFTEN}, "action": {"mode": "residual"}},
        "from scratch": {"command": {"resample_interval": [0.1, 0.3]}},
        "history": {"observation_history": 3, "clock_frequency": clock},
        "a user's file": {"randomization": {"joint_damping": [0.5, 2.0]}},
    }


CONFIGS = configs()


@pytest.mark.parametrize("name", CONFIGS)
def test_task_on_tensors_equals_task_on_arrays(name, tmp_path):
    """The same draws, observations, rewards, ends of episodes and privileged readings, over several episodes."""
    definition = BUILT_IN
    if name == "a user's file":
        (tmp_path / "task.py").write_text(TASK_FILE)
        definition = load_task_file(tmp_path / "task.py")
    config, n, steps = TaskConfig.from_dict(CONFIGS[name], definition), 16, 150
    model = config.compiled_model()
    arrays = Task(BatchSimulation(model, n, 1), config, 60)
    tensors = Task(TorchDriver(model, n, MINI_QUADRUPED), config, 60)
    for task in (arrays, tensors):
        task.reset(np.arange(n, like=task.simulation.sensordata), list(range(n)))
        task.shorten_episodes()
    privileged = [task.privileged_readings() for task in (arrays, tensors)]
    rng, ends = np.random.default_rng(1), 0
    for _ in range(steps):
        action = rng.uniform(-1.2, 1.2, (n, 8))
        expected, found = arrays.step(action), tensors.step(torch.tensor(action))
        for field in dataclasses.fields(expected):
            values = getattr(found, field.name).numpy(), getattr(expected, field.name)
            assert values[0].dtype == values[1].dtype
            np.testing.assert_allclose(*values, rtol=0.0, atol=1e-6 if values[0].dtype == np.float32 else 1e-9)
        np.testing.assert_allclose(privileged[1].values().numpy(), privileged[0].values(), atol=1e-6)
        done = np.flatnonzero(arrays.finished)
        np.testing.assert_array_equal(np.flatnonzero(tensors.finished).numpy(), done)
        if len(done):
            ends += len(done)
            arrays.reset(done)
            tensors.reset(TensorArray(torch.tensor(done)))
            np.testing.assert_allclose(tensors.observe().numpy(), arrays.observe(), atol=1e-6)
        # The physics are the same as long as the joint targets are; a difference in the last bit would grow.
        tensors.simulation.batch.batch.state[:] = arrays.simulation.batch.state
    assert ends >= 2 * n


def test_task_on_tensors_refuses_actions_that_are_not_finite():
    config = TaskConfig()
    task = Task(TorchDriver(config.compiled_model(), 2, MINI_QUADRUPED), config)
    task.reset(np.arange(2, like=task.simulation.sensordata))
    action = torch.zeros(2, 8)
    action[1, 3] = math.nan
    with pytest.raises(QuadrupedError, match=r"action: value nan for .* in env 1 is not finite"):
        task.step(action)
