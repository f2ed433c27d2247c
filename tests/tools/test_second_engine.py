"""The comparison of two engines, here MuJoCo with two contact models: no test of this file needs Drake."""

import importlib.util
import json
import math

import mujoco
import numpy as np
import pytest

import sim2sim
from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.policies import PolicyController, load_policy
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import TaskConfig
from second_engine.engines import Drake, MuJoCo
from second_engine.transfer import COMMANDS, Transfer, run_transfer

ENGINES = {"name": "MuJoCo", "version": "1", "timestep": 0.005}, {"name": "Drake", "version": "2", "timestep": 0.002}


@pytest.fixture(scope="module")
def policy():
    return load_policy("flat")


@pytest.fixture(scope="module")
def transfer(policy):
    commands = [(0.3, 0.0), (0.0, 0.5), (0.0, 0.0)]
    return run_transfer(policy, commands, 2, 3.0, there=MuJoCo(cone="pyramidal"))


def made(forward, yaw_rate, falls=((0.0,), (0.0,)), commands=((0.5, 0.0),)):
    """A transfer of a policy with one seed; forward and yaw_rate are the commands' here and there."""
    engines = [
        {
            "forward_velocity": np.array(forward[i], dtype=float)[:, None],
            "yaw_rate": np.array(yaw_rate[i], dtype=float)[:, None],
            "base_height": np.full((len(commands), 1), 0.18),
            "fallen": np.array(falls[i])[:, None],
        }
        for i in range(2)
    ]
    return Transfer({"policy": commands}, (0,), 10.0, ENGINES, {"policy": (engines[0], engines[1])})


def test_loss_is_the_missing_share_of_the_velocity_here():
    commands = ((0.5, 0.0), (-0.2, 0.0), (0.3, 0.5), (0.0, 0.0))
    found = made(
        ([0.5, -0.2, 0.3, 0.0], [0.4, -0.21, 0.3, 0.1]), ([0, 0, 0.5, 0], [0.2, 0.2, 0.25, 0]), commands=commands
    )
    assert found.loss("policy", "forward_velocity", 0) == pytest.approx(0.2)
    assert found.loss("policy", "forward_velocity", 1) == pytest.approx(-0.05), "faster there"
    assert found.loss("policy", "yaw_rate", 2) == pytest.approx(0.5)
    assert math.isnan(found.loss("policy", "yaw_rate", 0)), "the command does not ask for it"
    assert math.isnan(found.loss("policy", "forward_velocity", 3))
    assert found.largest_loss("policy", "forward_velocity") == (pytest.approx(0.2), (0.5, 0.0))
    assert found.largest_loss("policy", "yaw_rate") == (pytest.approx(0.5), (0.3, 0.5))


def test_results_for_the_suite_have_the_largest_change_of_either_sign_straight_and_on_turns():
    """Too fast is as wrong as too slow; a turn counts by all of its velocities, and standing not at all."""
    commands = ((0.5, 0.0), (-0.2, 0.0), (0.3, 0.5), (0.0, 0.0))
    forward = [0.5, -0.2, 0.3, 0.0], [0.49, -0.22, 0.42, 0.1]
    yaw_rate = [0.0, 0.0, 0.5, 0.0], [0.1, 0.0, 0.4, math.nan]
    found = made(forward, yaw_rate, ((0.0,) * 4, (0.0, 0.0, 1.0, 0.0)), commands).to_dict()
    assert found == json.loads(json.dumps(found, allow_nan=False))
    assert found["largest_change"] == pytest.approx({"straight": 0.1, "turning": 0.4})
    curve, stand = found["commands"][2:]
    assert curve == {"command": [0.3, 0.5], "here": [0.3, 0.5], "there": [0.42, 0.4], "falls_here": 0, "falls_there": 1}
    assert stand["there"] == [0.1, None]
    assert made(([0.5], [0.5]), ([0], [0])).to_dict()["largest_change"] == {"straight": 0.0, "turning": None}


@pytest.mark.parametrize("here", [-0.1, 0.0, math.nan])
def test_loss_is_undefined_where_the_robot_does_not_follow_the_command_here(here):
    found = made(([here], [0.4]), ([0], [0]))
    assert math.isnan(found.loss("policy", "forward_velocity", 0))
    assert found.largest_loss("policy", "forward_velocity") is None


def test_loss_is_complete_where_all_robots_fall_in_the_second_engine():
    found = made(([0.5], [math.nan]), ([0], [math.nan]), falls=((0.0,), (1.0,)))
    assert found.loss("policy", "forward_velocity", 0) == 1.0
    assert not found.carries_over()


@pytest.mark.parametrize(
    ("forward", "yaw_rate", "falls", "expected"),
    [
        (0.476, 0.405, 0.0, True),
        (0.474, 0.405, 0.0, False),  # 5.2 % of the forward velocity
        (0.476, 0.395, 0.0, False),  # 21 % of the yaw rate
        (0.476, 0.405, 1.0, False),
        (0.6, 0.6, 0.0, True),
    ],
)
def test_policy_carries_over_within_the_targets_and_without_more_falls(forward, yaw_rate, falls, expected):
    commands = ((0.5, 0.0), (0.0, 0.5))
    found = made(([0.5, 0.0], [forward, 0.0]), ([0.0, 0.5], [0.0, yaw_rate]), ((0.0, 0.0), (0.0, falls)), commands)
    assert found.carries_over() is expected
    sentences = found.verdict()
    assert ("does not carry over" in sentences[0]) is not expected
    assert sum("missed" in sentence for sentence in sentences) == (not expected and not falls)


@pytest.mark.parametrize("here", [0.0, math.nan])
def test_command_that_is_not_followed_here_leaves_the_conclusion_open(here):
    """No command has a loss, and nothing was measured that could carry over."""
    found = made(([here], [0.0]), ([0], [0]))
    assert found.carries_over() is None
    assert found.verdict()[0] == (
        "Whether the policy carries over to Drake is open: in MuJoCo it does not follow the command of 0.5 m/s and "
        "0 rad/s."
    )
    # A second command whose loss is too large decides.
    assert made(([here, 0.3], [0, 0.2]), ([0, 0], [0, 0]), commands=((0.5, 0.0), (0.3, 0.0))).carries_over() is False


def test_lateral_velocity_has_columns_a_loss_and_a_target():
    commands = ((0.3, 0.0, 0.0), (0.0, 0.0, -0.2))
    here, there = made(([0.3, 0.0], [0.3, 0.0]), ([0, 0], [0, 0]), ((0, 0), (0, 0)), commands).values["policy"]
    here["lateral_velocity"], there["lateral_velocity"] = np.array([[0.0], [-0.2]]), np.array([[0.1], [-0.15]])
    found = Transfer({"policy": commands}, (0,), 10.0, ENGINES, {"policy": (here, there)})
    assert found.largest_loss("policy", "lateral_velocity") == (pytest.approx(0.25), (0.0, 0.0, -0.2))
    assert found.carries_over() is False
    head, _, sideways = found.tables()[0].splitlines()[1:]
    assert head.split("  ")[0].strip() == "m/s, rad/s, m/s"
    assert "0, 0, -0.2" in sideways
    assert "25.0 %" in sideways
    assert any(
        "Largest loss of lateral velocity against MuJoCo: 25.0 %, at 0 m/s and 0 rad/s and -0.2 m/s; target 5.0 %"
        in line
        for line in found.verdict()
    )


def test_same_engine_twice_loses_nothing_and_ignores_the_tasks_randomization(policy):
    config = policy.config.randomized("hard").on_terrain("stairs")
    hard = policy.for_task(policy.weights, policy.biases, policy.activation, config, policy.card)
    plain, found = (run_transfer(one, [(0.3, 0.5)], 2, 2.0, there=MuJoCo()) for one in (policy, hard))
    assert set(found.commands) == {"policy", "tuned"}
    for name in ("forward_velocity", "yaw_rate", "base_height"):
        here, there = found.values["policy"]
        np.testing.assert_array_equal(here[name], there[name])
        np.testing.assert_array_equal(here[name], plain.values["policy"][0][name])
    assert found.loss("policy", "forward_velocity", 0) == 0.0


def test_transfer_runs_the_zero_action_only_where_standing_is_commanded(transfer):
    assert transfer.commands["zero"] == ((0.0, 0.0),)
    assert transfer.commands["policy"] == transfer.commands["tuned"] == ((0.3, 0.0), (0.0, 0.5), (0.0, 0.0))
    here, there = transfer.means("zero", "base_height", 0)
    assert here == pytest.approx(0.1835, abs=5e-4)
    assert there == pytest.approx(here, abs=5e-4)


def test_robots_walk_and_turn_in_the_pyramid_too_but_not_equally(transfer):
    for name in ("policy", "tuned"):
        for quantity, command in (("forward_velocity", 0), ("yaw_rate", 1)):
            assert 1e-4 < abs(transfer.loss(name, quantity, command)) < 0.5, (name, quantity)


def test_engine_of_a_rollout_is_the_one_that_is_passed(policy):
    def with_pyramidal_cone(config, num_envs):
        model = config.compiled_model()
        model.opt.cone = mujoco.mjtCone.mjCONE_PYRAMIDAL
        return BatchSimulation(model, num_envs)

    velocities = [
        roll_out(PolicyController(policy), [(0.0, 0.5)], [0], 1.0, policy.config, engine=engine).velocity
        for engine in (with_pyramidal_cone, MuJoCo(cone="pyramidal"), MuJoCo())
    ]
    np.testing.assert_array_equal(velocities[0], velocities[1])
    assert not np.array_equal(velocities[1], velocities[2])


def test_mujoco_engine_sets_every_field_of_its_contact_model():
    engine = MuJoCo(cone="elliptic", impratio=10.0, noslip_iterations=3, friction=0.6)
    model = engine(TaskConfig(), 1).model
    assert model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC
    assert (model.opt.impratio, model.opt.noslip_iterations) == (10.0, 3)
    assert (model.geom_friction[:, 0] == 0.6).all()
    settings = engine.settings(TaskConfig())
    assert settings == settings | {"cone": "elliptic", "impratio": 10.0, "noslip_iterations": 3, "friction": 0.6}
    assert MuJoCo().settings(TaskConfig())["friction"] == 0.8


def test_drakes_time_step_divides_the_control_step():
    assert Drake().timestep(TaskConfig()) == pytest.approx(0.002)
    assert Drake(max_timestep=0.003).timestep(TaskConfig()) == pytest.approx(0.02 / 7)
    assert Drake().timestep(TaskConfig(physics_timestep=0.005, decimation=5)) == pytest.approx(0.025 / 13)


@pytest.mark.parametrize(
    "bad",
    [
        lambda: MuJoCo(cone="round"),
        lambda: MuJoCo(impratio=0.0),
        lambda: MuJoCo(noslip_iterations=-1),
        lambda: MuJoCo(friction=-0.1),
        lambda: Drake(approximation="hard"),
        lambda: Drake(max_timestep=0.0),
        lambda: Drake(friction=math.nan),
    ],
)
def test_engine_with_a_bad_field_is_an_error_that_names_it(bad):
    with pytest.raises(QuadrupedError, match=r"engine: \w+ must be .*; found "):
        bad()


@pytest.mark.parametrize(
    ("arguments", "name"),
    [
        ({"commands": []}, "command"),
        ({"commands": [(math.nan, 0.0)]}, "command"),
        ({"commands": [(0.3, 0.0), (0.3, 0.0, 0.1)]}, "command"),
        ({"num_seeds": 0}, "seeds"),
        ({"seconds": 1.0}, "seconds"),
        ({"seconds": 1e4}, "seconds"),
    ],
)
def test_bad_episodes_are_an_error_that_names_the_field(policy, arguments, name):
    with pytest.raises(QuadrupedError, match=rf"^{name}: expected .*; found "):
        run_transfer(policy, **{"commands": COMMANDS, "num_seeds": 1, **arguments}, there=MuJoCo())


def test_command_that_the_policy_was_not_trained_for_is_a_warning_with_the_range(policy):
    with pytest.warns(QuadrupedWarning, match="--command: forward_velocity = 5 is outside -0.3 to 0.6 m/s, for which"):
        run_transfer(policy, [(5.0, 0.0)], 1, 2.0, there=MuJoCo())


def test_missing_drake_is_an_error_that_names_the_fix(monkeypatch, capsys):
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None if name == "pydrake" else find_spec(name))
    with pytest.raises(QuadrupedError, match=r"pip install .*second_engine/requirements\.txt"):
        Drake()(TaskConfig(), 1)
    assert sim2sim.main(["flat"]) == 2
    assert "second_engine/requirements.txt" in capsys.readouterr().err
