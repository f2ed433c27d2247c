"""What the environments refuse, and that nothing is lost by it."""

import numpy as np
import pytest
from environments import assert_same, make, make_native

from quadruped_env import QuadrupedError


@pytest.mark.parametrize(
    ("action", "message"),
    [
        (np.zeros(7), r"action: expected shape \(8,\), one value per joint; found \(7,\)"),
        (np.zeros((2, 8)), r"action: expected shape \(8,\).*found \(2, 8\)"),
        (0.0, r"action: expected shape \(8,\).*found \(\)"),
        (np.full(8, np.nan), r"action: value nan for LF_hip_joint in row 0 is not finite"),
        ([0, 0, 0, np.inf, 0, 0, 0, 0], r"action: value inf for RF_knee_joint in row 0 is not finite"),
        ([0, 0, 0, np.inf, 0, -np.inf, 0, 0], r"action: value inf for RF_knee_joint"),
    ],
)
def test_a_bad_action_is_refused_and_nothing_moves(action, message):
    env = make(disable_env_checker=True)
    env.reset(seed=0)
    before = env.unwrapped.get_state()
    with pytest.raises(QuadrupedError, match=message):
        env.step(action)
    assert_same(env.unwrapped.get_state(), before)


def test_a_bad_action_of_one_row_is_refused_and_no_row_moves():
    env = make_native(3)
    env.reset(seed=0)
    before = env.get_state()
    action = np.zeros((3, 8))
    action[1, 7] = np.nan
    with pytest.raises(QuadrupedError, match="value nan for RH_knee_joint in row 1 is not finite"):
        env.step(action)
    with pytest.raises(QuadrupedError, match=r"expected shape \(3, 8\).*found \(8,\)"):
        env.step(np.zeros(8))
    assert_same(env.get_state(), before)


@pytest.mark.parametrize("maker", [make, make_native])
@pytest.mark.parametrize(
    ("kwargs", "message"),
    [
        ({"action_mode": "torque"}, r"action_mode: 'torque'.*position, residual"),
        ({"config": {"action": {"mode": "torque"}}}, r"'torque'.*position, residual"),
        ({"config": {"rewards": {}}}, r"config: unknown field 'rewards'; valid fields are .*reward.*randomization"),
        ({"config": {"reward": {"weight": {}}}}, r"config.reward: unknown field 'weight'; valid fields are weights"),
        ({"config": {"reward": {"weights": {"speed": 1}}}}, r"unknown reward term 'speed'; valid terms are .*upright"),
        ({"config": {"randomization": {"friction": 0.5}}}, r"config.randomization.friction: expected a pair.*0\.5"),
        ({"config": {"decimation": 2.5}}, r"config.decimation: expected a whole number; found 2\.5"),
        ({"config": {"decimation": 0}}, r"decimation must be 1 or more; found 0"),
        ({"config": []}, r"config: expected a mapping of fields; found \[\]"),
        ({"config": "fast"}, r"config: expected a mapping of fields; found 'fast'"),
        ({"render_mode": "ascii"}, r"render_mode: 'ascii' is unknown; valid modes are None, human, rgb_array"),
    ],
)
@pytest.mark.filterwarnings("ignore:.*possible render_modes")
def test_bad_arguments_are_named_with_the_valid_ones(maker, kwargs, message):
    with pytest.raises(QuadrupedError, match=message):
        maker(**kwargs)


@pytest.mark.parametrize("maker", [make, make_native])
def test_an_unknown_argument_is_refused(maker):
    with pytest.raises(TypeError, match="gravity"):
        maker(gravity=1.6)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"command": (9.0, 0.0)}, r"forward_velocity = 9 is outside .*widen config\['command'\]\['forward_velocity'\]"),
        ({"command": (0.0, -9.0)}, r"yaw_rate = -9 is outside"),
        ({"command": 0.3}, r"options\['command'\]: expected two finite numbers.*found 0\.3"),
        ({"command": (0.3,)}, r"expected two finite numbers"),
        ({"command": (0.3, 0.0, 0.0)}, r"expected two finite numbers"),
        ({"command": (0.3, np.nan)}, r"expected two finite numbers"),
        ({"command": "fast"}, r"expected two finite numbers.*found 'fast'"),
        ({"comand": (0.0, 0.0)}, r"options: unknown option 'comand'; valid options are 'command'"),
    ],
)
@pytest.mark.parametrize("maker", [make, lambda **kwargs: make_native(3, **kwargs)], ids=["single", "native"])
def test_bad_reset_options_are_refused_and_the_episode_goes_on(maker, options, message):
    env, untouched = maker(), maker()
    env.reset(seed=0), untouched.reset(seed=0)
    before = env.unwrapped.get_state()
    with pytest.raises(QuadrupedError, match=message):
        env.reset(options=options, seed=8)
    assert_same(env.unwrapped.get_state(), before)
    assert_same(env.unwrapped.reset(), untouched.unwrapped.reset())


def test_a_wider_command_range_lets_a_command_through_that_was_refused():
    env = make(config={"command": {"forward_velocity": [-1.0, 10.0]}})
    _, info = env.reset(options={"command": (9.0, 0.0)})
    assert info["command"][0] == 9.0


@pytest.mark.parametrize(
    "mask",
    [np.zeros(3, dtype=bool), np.ones(4, dtype=bool), np.ones(3), [True, False, True], True, np.ones((3, 1), bool)],
    ids=["none", "too long", "not bool", "a list", "a bool", "two axes"],
)
def test_a_bad_reset_mask_is_refused(mask):
    env = make_native(3)
    env.reset(seed=0)
    with pytest.raises(QuadrupedError, match=r"reset_mask.*bool array of shape \(3,\)"):
        env.reset(options={"reset_mask": mask})


def test_a_list_of_seeds_must_have_one_a_row():
    with pytest.raises(QuadrupedError, match="seed: expected one number, or 3, one a row; found 2"):
        make_native(3).reset(seed=[1, 2])


@pytest.mark.parametrize("count", [0, -1])
def test_there_must_be_a_robot(count):
    with pytest.raises(QuadrupedError, match=f"num_envs: expected 1 or more; found {count}"):
        make_native(count)


def test_an_episode_must_last_a_step():
    with pytest.raises(QuadrupedError, match="max_episode_steps: expected 1 or more, or None; found 0"):
        make_native(1, max_episode_steps=0)
