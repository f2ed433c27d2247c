"""Values drawn ahead: those that each env would get alone, computed seldom, and only where nothing else counts."""

import numpy as np
import pytest
from environments import SHOVED, assert_same, make_native

from quadruped_env import QuadrupedError
from quadruped_env.task import ModelField, Randomization
from quadruped_env.task.ahead import Ahead
from quadruped_env.utils.arrays import NUMPY

N = 5


class Doubling:
    """Computes twice the keys, and the envs themselves; counts its calls and rows."""

    def __init__(self, num_envs=N):
        self.rows = []
        self.ahead = Ahead(self.compute, num_envs, NUMPY)

    def compute(self, env_ids, keys):
        self.rows.append(len(env_ids))
        return 2.0 * keys, np.stack([env_ids, env_ids], axis=-1)

    def of(self, env_ids, keys, expected):
        """Check the values of some envs."""
        doubled, envs = self.ahead.of(np.array(env_ids), np.array(keys, np.uint64), expected.copy)
        np.testing.assert_array_equal(doubled, 2.0 * np.array(keys))
        np.testing.assert_array_equal(envs, np.stack([env_ids, env_ids], axis=-1))


def test_what_one_env_lacks_is_computed_for_all_that_lack_it():
    doubling, expected = Doubling(), np.array([10, 11, 12, 13, 14], np.uint64)
    doubling.of([2], [7], expected)
    assert doubling.rows == [N]
    doubling.of([0, 4], [10, 14], expected)
    doubling.of([2], [7], expected)
    assert doubling.rows == [N], "known already"
    # Env 2 and env 3 have other keys by now; the others keep their values.
    expected[3] = 23
    doubling.of([2, 1], [8, 11], expected)
    assert doubling.rows == [N, 2]
    doubling.of([3], [23], expected)
    assert doubling.rows == [N, 2]
    doubling.ahead.forget()
    doubling.of([3], [23], expected)
    assert doubling.rows == [N, 2, N]


def test_a_single_env_draws_for_itself():
    doubling = Doubling(1)
    for key in (3, 3):
        doubling.of([0], [key], np.array([99], np.uint64))
    assert doubling.rows == [1, 1]


def test_straight_commands_begin_with_the_next_command_and_the_next_start():
    n = 64
    env = make_native(n, config={"command": {"resample_interval": [0.1, 0.5]}})
    env.reset(seed=0)
    actions = np.zeros((n, 8), np.float32)
    for _ in range(30):
        env.step(actions)
    env.reset(options={"reset_mask": np.arange(n) == 1})
    before = env.task.command.copy()
    assert before[:, 1].any(), "some turn"
    env.task.straight_only = True
    env.reset(options={"reset_mask": np.arange(n) == 0})
    for _ in range(25):  # the longest interval
        changed = (env.task.command != before).any(axis=1)
        assert changed[0], "a start"
        assert not env.task.command[changed, 1].any()
        assert (env.task.command[changed, 0] > 0.4).all()
        env.step(actions)
    assert (env.task.command != before).any(axis=1).all()


STARTS = """
from quadruped_env.task import Randomization

calls = []


def aside(event, values):
    calls.append((event.env_ids.tolist(), event.simulation.readings.base_position[event.env_ids, 0].tolist()))
    event.qpos[:, :1] += values


start = Randomization("start", aside, (1.0, 2.0), "m", pure={pure})
"""


@pytest.mark.parametrize("pure", [False, True])
def test_starts_are_drawn_ahead_only_if_they_are_pure(tmp_path, pure):
    file = tmp_path / "own.py"
    file.write_text(STARTS.format(pure=pure))
    env = make_native(4, task_file=str(file))
    env.reset(seed=0)
    (own,) = [r for r in env.task.config.definition.randomizations if r.name == "start"]
    calls = own.apply.__globals__["calls"]
    assert [ids for ids, _ in calls] == [[0, 1, 2, 3]]
    env.reset(options={"reset_mask": np.array([False, True, False, False])})
    env.reset(options={"reset_mask": np.array([False, False, True, False])})
    later = [ids for ids, _ in calls[1:]]
    assert later == ([[0, 1, 2, 3]] if pure else [[1], [2]])
    position = env.task.simulation.readings.base_position[:, 0]
    assert ((position > 0.9) & (position < 2.1)).all()
    if not pure:
        assert calls[1][1] != [0.0], "it sees the robot that it moves"


def test_a_restored_or_reseeded_env_gets_its_own_starts():
    kwargs = {"config": SHOVED, "max_episode_steps": 30}
    env = make_native(3, **kwargs)
    env.reset(seed=0)
    actions = np.random.default_rng(0).uniform(-1.0, 1.0, (150, 3, 8)).astype(np.float32)
    for action in actions[:40]:
        env.step(action)
    state = env.get_state()
    expected = [env.step(action) for action in actions[40:]]
    env.set_state(state)
    assert_same([env.step(action) for action in actions[40:]], expected)
    env.reset(seed=0)
    other = make_native(3, **kwargs)
    other.reset(seed=0)
    assert_same([env.step(action) for action in actions], [other.step(action) for action in actions])


def test_a_model_field_cannot_be_pure():
    with pytest.raises(QuadrupedError, match=r"randomization x: pure needs a function .*found ModelField"):
        Randomization("x", ModelField("body_mass"), (0.5, 2.0), pure=True)
