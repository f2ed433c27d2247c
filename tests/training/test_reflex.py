"""A reflex against falls: its inputs, its gradient, and what it does to a policy."""

import copy
import math
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from networks import assert_symmetric, perturb
from trainings import SMALL as TRAINING
from trainings import learn, learn_until
from walking_models import ENVS, changed_parts, parameters, states, walking

from quadruped_env.policies import load_policy
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.training import TrainConfig, reflex
from quadruped_env.training.reflex import Reflex, add_reflex

PAIRS, INPUTS = 4, 12
"""Pairs of joints: hips and knees of the fore and the hind legs."""


def disturbed(up=(0.0, 0.0), rates=(0.0, 0.0), clock=(0.0, 0.0, 0.0, 0.0)):
    """A task of one robot: horizontal part of its up axis, roll and pitch rate, sine of each leg's clock."""
    readings = SimpleNamespace(up_b=np.array([[*up, 1.0]]), angular_velocity_b=np.array([[*rates, 9.0]]))
    control = SimpleNamespace(leg_clock=lambda: np.array([clock]))
    return SimpleNamespace(context=SimpleNamespace(readings=readings), control=control)


@pytest.mark.parametrize(
    ("task", "expected"),
    [
        (disturbed(), 0.0),
        (disturbed(up=(0.06, 0.08)), 0.0),
        (disturbed(up=(0.0, -0.14)), 0.5),
        (disturbed(rates=(1.7, 0.0)), 0.0),
        (disturbed(rates=(0.0, 2.2)), 0.5),
        (disturbed(rates=(-3.0, 4.0)), 1.0),
        (disturbed(up=(0.14, 0.0), rates=(1.95, 0.0)), 0.5),
    ],
)
def test_disturbance(task, expected):
    assert Reflex(MINI_QUADRUPED).disturbance(task) == pytest.approx([expected])


def test_inputs():
    """Left fore leg: pitch and roll in units of 0.2, rates in units of 3 rad/s, and the clock's part."""
    inputs = Reflex(MINI_QUADRUPED).inputs(disturbed((0.1, -0.2), (1.5, -3.0), (0.5, 0.0, 0.0, -1.0)))[0]
    plain = [1.0, 0.5, -1.0, -1.0, 0.5]
    assert inputs[0] == pytest.approx([*plain, 1.0, 0.5, *(0.5 * value for value in plain)])
    right_hind = [1.0, 0.5, -1.0, 1.0, -0.5]
    assert inputs[7] == pytest.approx([*right_hind, 1.0, 0.5, *(-value for value in right_hind)])


def test_reflex_of_the_mirrored_robot_is_the_mirrored_reflex():
    own = Reflex(MINI_QUADRUPED)
    own.weights[:] = np.random.default_rng(0).standard_normal((PAIRS, INPUTS))
    task = disturbed((0.2, 0.3), (2.0, -1.0), (0.1, 0.2, 0.3, 0.4))
    mirrored = disturbed((0.2, -0.3), (-2.0, -1.0), (0.2, 0.1, 0.4, 0.3))
    actions, of_mirrored = (own.actions(own.disturbance(t), own.inputs(t)) for t in (task, mirrored))
    assert np.abs(actions).max() > 0.1
    np.testing.assert_allclose(of_mirrored, actions[:, list(MINI_QUADRUPED.joint_mirror)])


def test_products_are_the_derivative_of_the_actions_by_the_weights():
    random = np.random.default_rng(1)
    own = Reflex(MINI_QUADRUPED)
    inputs, per_joint = random.standard_normal((5, 8, INPUTS)), random.standard_normal((5, 8))
    products = own.products(per_joint, inputs)
    before = np.einsum("nj,nj->n", per_joint, own.actions(np.ones(5), inputs))
    own.weights[2, 7] += 1.0
    after = np.einsum("nj,nj->n", per_joint, own.actions(np.ones(5), inputs))
    np.testing.assert_allclose(products[:, 2, 7], after - before)


PUSHED = {"push_speed": (0.9, 1.3), "push_interval": (0.5, 1.0)}
SMALL = {
    "_REPLAYS": 64,
    "_REPLAY_STEPS": 40,
    "_WALKING_STEPS": 20,
    "_FIRST_STEPS": 120 * ENVS,
    "_ROUND_STEPS": 120 * ENVS,
    "_LESSON_STEPS": 60 * ENVS,
    "_LESSON_BATCH": 64,
}


@pytest.fixture
def small(monkeypatch):
    for name, value in SMALL.items():
        monkeypatch.setattr(reflex, name, value)


@pytest.mark.parametrize("asymmetric_critic", [False, True])
def test_network_learns_the_reflex_and_nothing_else_changes(small, asymmetric_critic):
    model = walking(asymmetric_critic, **PUSHED)
    weights, envs = parameters(model), copy.deepcopy(states(model))
    shares = []
    rounds = add_reflex(model, 2, lambda share, rounds: shares.append((share, len(rounds))))
    assert len(rounds) == 2
    assert all(0.0 <= result.survived <= 1.0 and result.fall_rate > 0.0 for result in rounds)
    critic = {name for name in weights if "value_net" in name}
    assert changed_parts(weights, model) == {"mlp_extractor", "action_net"}
    assert all(torch.equal(weights[name], model.policy.state_dict()[name]) for name in critic)
    np.testing.assert_equal(states(model), envs)
    steps = 120 + 2 * (4 * 40 + 120) + 60
    assert model.num_timesteps == steps * ENVS
    assert [number for _, number in shares] == sorted(number for _, number in shares)
    assert [share for share, _ in shares] == sorted(share for share, _ in shares)
    assert 0.0 < shares[0][0] < 0.01
    assert shares[-1][0] == 1.0


def test_after_the_replays_each_env_goes_on_with_its_own_episodes(small, monkeypatch):
    model = walking(**PUSHED)
    collected = []
    usual = reflex._Practice._collect

    def collect(self, steps):
        rate = usual(self, steps)
        collected.append(states(model))
        return rate

    monkeypatch.setattr(reflex._Practice, "_collect", collect)
    add_reflex(model, 1)
    for found in collected:
        assert len({state["simulation"].integration.tobytes() for state in found}) == ENVS


@pytest.mark.parametrize(("tilted_until", "sign"), [(40, -1.0), (15, 0.0)])
def test_a_robot_that_sits_down_is_worth_less_than_one_that_walks_on(small, monkeypatch, tilted_until, sign):
    """Of the robots that repeat a state every second one is tilted until the end, or walks on after it was tilted."""
    model = walking()
    practice = reflex._Practice(model, 1, None, lambda: False)
    practice._falls.append(model.env.task.get_state(0))
    odd = np.arange(ENVS) % 2 == 1
    steps = []
    monkeypatch.setattr(Reflex, "disturbance", lambda self, task: 1.0 * odd * (len(steps) <= tilted_until))
    monkeypatch.setattr(reflex, "_NOISE", 0.0)
    usual = practice._step
    monkeypatch.setattr(practice, "_step", lambda actions: steps.append(1) or usual(actions))
    score, survived, *_ = practice._replay()
    assert survived == 1.0
    assert (np.sign(score[odd].round(6)) == sign).all()
    np.testing.assert_allclose(score[odd], -score[~odd], atol=1e-6)


def test_network_acts_itself_in_the_second_half_of_its_lesson(small, monkeypatch):
    model = walking(**PUSHED)
    usual, calls = model.policy.mean_action, []
    monkeypatch.setattr(model.policy, "mean_action", lambda seen: calls.append(1) or usual(seen))
    add_reflex(model, 1)
    assert len(calls) == 120 + (4 * 40 + 120) + 60 // 2


def test_policy_stays_symmetric(small):
    model = walking(**PUSHED)
    perturb(model)
    model.policy.project()
    add_reflex(model, 1)
    assert_symmetric(model)


@pytest.mark.parametrize("after", [0.0, 0.9])
def test_a_training_that_is_to_end_keeps_its_policy(small, after):
    model = walking(**PUSHED)
    weights, envs = parameters(model), copy.deepcopy(states(model))
    shares = [0.0]
    assert add_reflex(model, 1, lambda share, _: shares.append(share), lambda: shares[-1] >= after) == []
    assert shares[-1] < after + 0.05
    assert not changed_parts(weights, model)
    np.testing.assert_equal(states(model), envs)


def test_without_a_fall_the_policy_stays_as_it_is(small):
    model = walking()
    weights = parameters(model)
    assert add_reflex(model, 1) == []
    assert not changed_parts(weights, model)


def test_later_rounds_take_smaller_steps_in_the_same_direction(monkeypatch):
    sizes = []
    monkeypatch.setattr(reflex._Practice, "_collect", lambda self, steps: self._falls.append({}) or 0.0)
    monkeypatch.setattr(reflex._Practice, "_improve", lambda self, size: sizes.append(size) or 0.5)
    monkeypatch.setattr(reflex._Practice, "_teach", lambda self, teacher: None)
    add_reflex(walking(), 12)
    assert sizes == sorted(sizes, reverse=True)
    assert sizes[0] > sizes[5] > sizes[-1] > 0.0


def test_a_single_env_has_nothing_to_compare(small, monkeypatch):
    for name in ("_FIRST_STEPS", "_ROUND_STEPS", "_LESSON_STEPS"):
        monkeypatch.setattr(reflex, name, SMALL[name] // ENVS)
    model = walking(num_envs=1, **PUSHED)
    for result in add_reflex(model, 1):
        assert math.isfinite(result.survived)
    assert all(torch.isfinite(value).all() for value in parameters(model).values())


PUSHED_TRAINING = TRAINING | {"timesteps": 64, "reflex_rounds": 1, "task": {"randomization": PUSHED}}


def test_training_ends_with_the_reflex_and_says_so_on_the_card(small, tmp_path, capsys):
    plain, taught = (
        learn(tmp_path / name, TrainConfig(**PUSHED_TRAINING | changes))
        for name, changes in (("plain", {"reflex_rounds": 0}), ("taught", {}))
    )
    (first,) = load_policy(taught).card["reflex"]
    assert "reflex" not in load_policy(plain).card
    assert set(first) == {"survived", "fall_rate"}
    output = capsys.readouterr().err
    assert f"round 1: {first['survived']:.0%} of the replayed falls survived" in output
    more = load_policy(taught).card["timesteps"] - load_policy(plain).card["timesteps"]
    assert output.count("more steps for a reflex") == 1
    assert f"then {more:,} more steps for a reflex" in output
    weights = [(run / "policy.safetensors").read_bytes() for run in (plain, taught)]
    assert weights[0] != weights[1]


def test_signal_during_the_reflex_keeps_the_policy_of_ppo(small, tmp_path, monkeypatch):
    plain = learn(tmp_path / "plain", TrainConfig(**PUSHED_TRAINING | {"reflex_rounds": 0}))
    run = learn_until(monkeypatch, "note_reflex", tmp_path / "stopped", TrainConfig(**PUSHED_TRAINING))
    assert (run / "policy.safetensors").read_bytes() == (plain / "policy.safetensors").read_bytes()


@pytest.mark.slow
def test_reflex_saves_robots_that_are_pushed(monkeypatch):
    """On the scripted gait, with pushes that often throw it over."""
    sizes = {"_REPLAYS": 2048, "_FIRST_STEPS": 50_000, "_ROUND_STEPS": 50_000, "_LESSON_STEPS": 100_000}
    for name, value in sizes.items():
        monkeypatch.setattr(reflex, name, value)
    model = walking(num_envs=128, push_speed=(1.0, 1.2), push_interval=(1.0, 1.5))
    falls, tilted = falls_and_tilt(model)
    add_reflex(model, 3)
    falls_after, tilted_after = falls_and_tilt(model)
    assert falls_after < 0.85 * falls
    # Robots that sit down do not fall either: they would be tilted for 1.6 times as long. By the network's seed, those
    # that learned are for 0.8 to 1.5 times.
    assert tilted_after < 1.5 * tilted


def falls_and_tilt(model, steps=400):
    """Falls of the policy without noise, and its share of time tilted by more than 0.3 rad."""
    env, own = model.env, Reflex(MINI_QUADRUPED)
    env.seed(1000)
    observations, number, tilted = env.reset(), 0, []
    for _ in range(steps):
        with torch.inference_mode():
            actions = model.policy.mean_action(torch.from_numpy(observations)).numpy()
        observations, _, ended, infos = env.step(np.clip(actions, -1.0, 1.0))
        number += sum(not infos[env_id]["TimeLimit.truncated"] for env_id in np.flatnonzero(ended))
        tilted.append(np.hypot(*own._tilt_and_rate(env.task)[0]) > math.sin(0.3))
    return number, np.mean(tilted)
