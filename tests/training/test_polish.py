"""The polish of a gait: what candidates change, what they cost, and what the search does to a policy."""

import copy

import numpy as np
import pytest
import torch
from networks import assert_symmetric, perturb
from trainings import SMALL as TRAINING
from trainings import learn, learn_until
from walking_models import changed_parts, parameters, states, walking

from quadruped_env.policies import load_policy
from quadruped_env.training import TrainConfig, polish
from quadruped_env.training.polish import polish_steps

SMALL = {"_CANDIDATES": 4, "_STARTS": 1, "_WARM_UP_STEPS": 20, "_STEPS": 60, "_DIRECTION_STEPS": 40}
GOOD = {
    "touchdowns": np.full((7, 1, 4), 1.0),
    "clearance": np.full((7, 1, 4), 0.02),
    "velocity": np.array([[0.2, 0], [0.3, 0], [0.4, 0], [0.5, 0], [-0.2, 0], [0, 0.5], [0.3, 0.5]])[:, None],
    "stiffened": np.zeros((5, 1)),
    "power": np.zeros((7, 1)),
    "fallen": np.zeros((7, 1)),
}
"""Of a gait that costs nothing."""


@pytest.fixture
def small(monkeypatch):
    for name, value in SMALL.items():
        monkeypatch.setattr(polish, name, value)


def search(model):
    found = polish._Search(model, 1, None, lambda: False)
    found.learn_directions()
    return found


def cost(model, **changes):
    """Cost on each command of a gait that is good but for some (command, ...) of its means."""
    means = copy.deepcopy(GOOD)
    for name, (place, value) in changes.items():
        means[name][place] = value
    return polish._Search(model, 1, None, lambda: False)._cost_of(polish._Means(**means))[:, 0]


@pytest.mark.parametrize(
    ("changes", "command", "expected"),
    [
        ({}, 0, 0.0),
        ({"touchdowns": ((3, 0, 2), 1.12)}, 3, 8.0),
        ({"touchdowns": ((5, 0, 2), 1.2)}, 5, 0.0),
        ({"touchdowns": ((5, 0, 2), 1.3)}, 5, 8.0),
        ({"clearance": ((1, 0, 3), 0.010)}, 1, 3.0),
        ({"velocity": ((4, 0, 0), -0.218)}, 4, 4.0),
        ({"velocity": ((6, 0, 1), 0.52)}, 6, 1.0),
        ({"stiffened": ((4, 0), 0.0062)}, 4, 4.0),
        ({"stiffened": ((3, 0), -0.0155)}, 3, 4.0),
        ({"stiffened": ((3, 0), -0.012)}, 3, 0.0),
        ({"fallen": ((2, 0), 0.5)}, 2, 25.0),
    ],
)
def test_cost_is_that_of_the_worst_foot_and_of_the_errors(small, changes, command, expected):
    costs = cost(walking(), **changes)
    assert costs[command] == pytest.approx(expected, abs=1e-6)
    assert np.delete(costs, command) == pytest.approx(np.zeros(6), abs=1e-6)


def test_energy_costs_by_the_distance_that_the_command_asks_for(small):
    model = walking()
    weight = 9.81 * model.env.task.config.robot.total_mass
    costs = cost(model, power=(slice(None), weight))  # W: a cost of transport of 1 / (m/s)
    assert costs == pytest.approx([3 / 0.2, 3 / 0.3, 3 / 0.4, 3 / 0.5, 3 / 0.2, 0.0, 3 / 0.3])


def test_measures_of_the_scripted_gait(monkeypatch):
    """It follows its commands, and each foot lifts by a centimetre once in a stride."""
    for name, value in (SMALL | {"_DIRECTION_STEPS": 110, "_WARM_UP_STEPS": 100, "_STEPS": 200}).items():
        monkeypatch.setattr(polish, name, value)
    model, means = walking(), []
    with torch.no_grad():
        for parameter in model.policy.action_net.parameters():
            parameter.zero_()
    found = search(model)
    usual = found._cost_of
    monkeypatch.setattr(found, "_cost_of", lambda own: means.append(own) or usual(own))
    found.costs(np.zeros((4, found.size)))
    straight = slice(0, 5)
    assert not means[0].fallen.any()
    np.testing.assert_allclose(means[0].velocity[straight, 0], found._commands[straight], atol=0.05)
    assert ((means[0].touchdowns[straight] >= 0.9) & (means[0].touchdowns[straight] < 1.6)).all()
    assert ((means[0].clearance[straight] > 0.005) & (means[0].clearance[straight] < 0.03)).all()
    assert ((means[0].power[straight] > 3.0) & (means[0].power[straight] < 15.0)).all()


def test_a_candidate_changes_actions_by_its_size_along_directions_that_do_not_correlate(small, monkeypatch):
    random = np.random.default_rng(0)
    inputs = random.standard_normal((500, 16)) @ random.standard_normal((16, 16)) + 1.0
    found = polish._Search(walking(), 1, None, lambda: False)
    monkeypatch.setattr(found, "_walk", lambda *_: [None] * 20 + [inputs])
    found.learn_directions()
    changes = found.changed(0.01 * np.eye(found.size)) - found._layer
    actions = inputs @ changes[:, :-1] + changes[:, -1:]
    # Of each candidate: one direction (the last is the bias), one joint of the left side.
    own = len(found._own)
    by_joint = actions[..., found._own].reshape(-1, own, len(inputs), own)
    for joint in range(own):
        moved = by_joint[:, joint]
        assert not np.delete(moved, joint, axis=2).any()
        *along, constant = moved[..., joint]
        np.testing.assert_allclose(np.cov(along), 1e-4 * np.eye(12), atol=1e-9)
        np.testing.assert_allclose(np.mean(along, axis=1), 0.0, atol=1e-9)
        np.testing.assert_allclose(constant, 0.01)


def test_a_policy_with_a_candidates_layer_does_what_the_candidate_did(small):
    model = walking()
    perturb(model)
    found = search(model)
    candidate = 0.1 * np.random.default_rng(0).standard_normal(found.size)
    layer = found.changed(candidate[None])[0]
    observations = found._robots.task.observe()
    with torch.inference_mode():
        inputs = model.policy.mlp_extractor.policy_net(torch.from_numpy(observations)).numpy()
    before = parameters(model)
    found.take(candidate)
    assert changed_parts(before, model) == {"action_net"}
    with torch.inference_mode():
        actions = model.policy.mean_action(torch.from_numpy(observations)).numpy()
    np.testing.assert_allclose(actions, inputs @ layer[:-1] + layer[-1], atol=1e-5)
    assert_symmetric(model)


@pytest.mark.parametrize("changes", [{"asymmetric_critic": True}, {"symmetric": False}])
def test_search_changes_the_last_layer_alone(small, changes):
    model = walking(**changes)
    perturb(model, 0.05)
    weights, envs, before = parameters(model), copy.deepcopy(states(model)), model.num_timesteps
    seen = []
    result = polish.polish(model, 2, lambda share, result: seen.append((share, result)))
    assert result.after <= result.before
    assert changed_parts(weights, model) == ({"action_net"} if result.after < result.before else set())
    np.testing.assert_equal(states(model), envs)
    assert model.num_timesteps - before == polish_steps(2)
    shares = [share for share, _ in seen]
    assert shares == sorted(shares)
    assert 0.0 < shares[0] < 0.01
    assert seen[-1] == (1.0, result)
    assert {result for _, result in seen[:-1]} == {None}


def test_all_candidates_have_the_same_starts_and_those_of_the_end_many(small, monkeypatch):
    monkeypatch.setattr(polish, "_STARTS", 2)
    found, seeds = search(walking()), []
    for robots in (found._robots, found._stiff_robots):
        next(found._walk(robots, found._layer, 1, 0))
        monkeypatch.setattr(robots.task, "reset", lambda envs, own, command: seeds.append(own))
    for sets in (1, 2):
        for robots, expected, commands in (
            (found._robots, [0, 1, *((2, 3) if sets == 2 else (0, 1))] * 2, 7),
            (found._stiff_robots, [0, 2 if sets == 2 else 0] * 2, 5),
        ):
            next(found._walk(robots, found._layer, 1, 70, sets))
            assert seeds == [[70 + start for start in expected]] * commands, "on all commands"
            seeds.clear()


def test_stiff_contacts_have_half_the_time_constant_and_are_compared_with_the_first_start(small, monkeypatch):
    monkeypatch.setattr(polish, "_STARTS", 2)
    found = search(walking())
    own, stiff = (robots.task for robots in (found._robots, found._stiff_robots))
    for task, time_constant, timestep in ((own, 0.01, 0.005), (stiff, 0.005, 0.0025)):
        model = task.simulation.model
        assert (model.geom_solref[model.geom_contype > 0, 0] == time_constant).all()
        assert model.opt.timestep == timestep
        assert task.config.control_timestep == 0.02
    layers = np.tile(found._layer, (4, 1, 1))
    measures = [found._measured(robots, layers, 5, 1) for robots in (found._robots, found._stiff_robots)]
    means = measures[0].means(measures[1])
    first, last = (measure.velocity()[:, :, 0, 0] for measure in measures)
    np.testing.assert_array_equal(means.stiffened, last - first[:5], "of the commands without a turn")
    changes = np.abs(means.stiffened)
    assert ((changes > 0.0) & (changes < 0.3)).all()


def test_what_is_worse_on_new_starts_is_not_taken(small, monkeypatch):
    model = walking()
    weights = parameters(model)

    def worse(self, candidates, sets=1):
        same = np.array([np.array_equal(candidates[0], candidate) for candidate in candidates])
        return np.where(same, 1.0, 2.0) if same.sum() > 1 else np.abs(candidates).sum(axis=1)

    monkeypatch.setattr(polish._Search, "costs", worse)
    result = polish.polish(model, 2)
    assert (result.before, result.after) == (1.0, 1.0)
    assert not changed_parts(weights, model)


@pytest.mark.parametrize("after", [0.0, 0.95])
def test_a_training_that_is_to_end_keeps_its_policy(small, after):
    model = walking()
    weights, shares = parameters(model), [0.0]
    assert polish.polish(model, 2, lambda share, _: shares.append(share), lambda: shares[-1] >= after) is None
    assert shares[-1] < after + 0.05
    assert not changed_parts(weights, model)


POLISHED = TRAINING | {"timesteps": 64, "polish_generations": 1}


def test_training_ends_with_the_polish_and_says_so_on_the_card(small, tmp_path, capsys):
    plain, polished = (
        learn(tmp_path / name, TrainConfig(**POLISHED | changes))
        for name, changes in (("plain", {"polish_generations": 0}), ("polished", {}))
    )
    result = load_policy(polished).card["polish"]
    assert "polish" not in load_policy(plain).card
    output = capsys.readouterr().err
    assert f"its cost falls from {result['before']:.1f} to {result['after']:.1f}" in output
    more = load_policy(polished).card["timesteps"] - load_policy(plain).card["timesteps"]
    assert f"then {more:,} more steps to polish the gait" in output
    assert more == polish_steps(1)


def test_signal_during_the_polish_keeps_the_policy_of_ppo(small, tmp_path, monkeypatch):
    plain = learn(tmp_path / "plain", TrainConfig(**POLISHED | {"polish_generations": 0}))
    run = learn_until(monkeypatch, "note_polish", tmp_path / "stopped", TrainConfig(**POLISHED))
    assert (run / "policy.safetensors").read_bytes() == (plain / "policy.safetensors").read_bytes()


@pytest.mark.slow
def test_polish_takes_a_bias_out_of_a_gait(monkeypatch):
    """Of the scripted gait, whose knees are all bent a little further."""
    for name, value in {"_CANDIDATES": 16, "_STARTS": 1}.items():
        monkeypatch.setattr(polish, name, value)
    model = walking()
    with torch.no_grad():
        model.policy.action_net.bias[1::2] += 0.1
    result = polish.polish(model, 6)
    assert result.after < 0.3 * result.before
