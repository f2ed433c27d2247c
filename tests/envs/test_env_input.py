"""Invalid input to the environments is refused, and leaves their state unchanged."""

import numpy as np
import pytest
from environments import assert_same, make, make_native

from quadruped_env import QuadrupedError
from quadruped_env.envs import make_sb3_vec_env


@pytest.mark.parametrize(
    ("action", "message"),
    [
        (np.zeros(7), r"action: expected shape \(8,\), one value per joint; found \(7,\)"),
        (np.zeros((2, 8)), r"action: expected shape \(8,\).*found \(2, 8\)"),
        (0.0, r"action: expected shape \(8,\).*found \(\)"),
        (np.full(8, np.nan), r"action: value nan for LF_hip_joint in env 0 is not finite"),
        ([0, 0, 0, np.inf, 0, 0, 0, 0], r"action: value inf for RF_knee_joint in env 0 is not finite"),
        ([0, 0, 0, np.inf, 0, -np.inf, 0, 0], r"action: value inf for RF_knee_joint"),
    ],
)
def test_bad_action_is_refused_and_nothing_moves(action, message):
    env = make(disable_env_checker=True)
    env.reset(seed=0)
    before = env.unwrapped.get_state()
    with pytest.raises(QuadrupedError, match=message):
        env.step(action)
    assert_same(env.unwrapped.get_state(), before)


def test_bad_action_of_one_env_is_refused_and_no_env_moves():
    env = make_native(3)
    env.reset(seed=0)
    before = env.get_state()
    action = np.zeros((3, 8))
    action[1, 7] = np.nan
    with pytest.raises(QuadrupedError, match="value nan for RH_knee_joint in env 1 is not finite"):
        env.step(action)
    with pytest.raises(QuadrupedError, match=r"expected shape \(3, 8\).*found \(8,\)"):
        env.step(np.zeros(8))
    assert_same(env.get_state(), before)


@pytest.mark.parametrize("maker", [make, make_native])
@pytest.mark.filterwarnings("ignore:.*possible render_modes")
def test_bad_arguments_are_named_with_the_valid_ones(maker):
    for kwargs, message in (
        ({"action_mode": "torque"}, r"action.mode must be one of position, residual; found 'torque'"),
        ({"config": {"rewards": {}}}, r"config: unknown field 'rewards'; valid fields are .*reward.*randomization"),
        ({"config": {"reward": {"weights": {"speed": 1}}}}, r"config.reward.weights: unknown field 'speed'; .*upright"),
        ({"config": {"randomization": {"friction": 0.5}}}, r"config.randomization.friction: expected a pair.*0\.5"),
        ({"config": {"decimation": 2.5}}, r"config.decimation must be a whole number from 1 to 1000; found 2\.5"),
        ({"config": {"decimation": 0}}, r"config.decimation must be a whole number from 1 to 1000; found 0"),
        ({"config": "fast"}, r"config: expected a mapping of fields; found 'fast'"),
        ({"render_mode": "ascii"}, r"render_mode must be one of human, rgb_array; found 'ascii'"),
        *(
            ({"render_mode": "rgb_array", name: value}, f"{name}: expected a whole number, 1 or more; found {value!r}")
            for name in ("width", "height")
            for value in (0, 64.0, "64", None)
        ),
    ):
        with pytest.raises(QuadrupedError, match=message):
            maker(**kwargs)
    with pytest.raises(TypeError, match="gravity"):
        maker(gravity=1.6)


@pytest.mark.parametrize("maker", [make, lambda **kwargs: make_native(3, **kwargs)], ids=["single", "native"])
def test_bad_reset_options_are_refused_and_the_episode_continues(maker):
    env, untouched = maker(), maker()
    env.reset(seed=0), untouched.reset(seed=0)
    before = env.unwrapped.get_state()
    for options, message in (
        ({"command": (9.0, 0.0)}, r"forward_velocity = 9 is outside .*widen config\['command'\]\['forward_velocity'\]"),
        ({"command": (0.0, -9.0)}, r"yaw_rate = -9 is outside"),
        ({"command": 0.3}, r"options\['command'\]: expected two finite numbers.*found 0\.3"),
        ({"command": (0.3, 0.0, 0.0)}, r"expected two finite numbers"),
        ({"command": (0.3, np.nan)}, r"expected two finite numbers"),
        ({"command": "fast"}, r"expected two finite numbers.*found 'fast'"),
        ({"comand": (0.0, 0.0)}, r"options: unknown field 'comand'; valid fields are command"),
        (5, r"options: expected a dict with 'command'.*, or None; found 5"),
    ):
        with pytest.raises(QuadrupedError, match=message):
            env.unwrapped.reset(options=options, seed=8)
        assert_same(env.unwrapped.get_state(), before)
    assert_same(env.unwrapped.reset(), untouched.unwrapped.reset())


def test_bad_reset_masks_are_refused():
    env = make_native(3)
    env.reset(seed=0)
    for mask in (np.zeros(3, bool), np.ones(4, bool), np.ones(3), [True, False, True], True, np.ones((3, 1), bool)):
        with pytest.raises(QuadrupedError, match=r"reset_mask.*bool array of shape \(3,\)"):
            env.reset(options={"reset_mask": mask})


def make_sb3(num_envs=2, **kwargs):
    return make_sb3_vec_env(num_envs, **kwargs)


@pytest.mark.parametrize("maker", [make_native, make_sb3])
def test_vector_environment_with_invalid_argument_names_the_valid_ones(maker):
    for name, values, message in (
        ("num_envs", (0, "2", 2.0, True), "num_envs: expected a whole number, 1 or more; found"),
        ("num_threads", (-1, 1.5), "num_threads: expected a whole number, 0 or more; found"),
        ("max_episode_steps", (0, 10.5), "max_episode_steps: expected a whole number, 1 or more, or None; found"),
        ("autoreset_mode", ("same", 1), "autoreset_mode must be one of NextStep, SameStep, Disabled; found"),
    ):
        for value in values:
            with pytest.raises(QuadrupedError, match=message):
                maker(**{name: value})


def test_reset_with_an_invalid_seed_is_refused():
    single, vector = make(), make_native(3)
    for env, seeds in ((single, (1.5, "1", -1, True, [0])), (vector, (1.5, "1", -1, [0, 1, 2.5], [0, -1, 2]))):
        for seed in seeds:
            with pytest.raises(
                QuadrupedError, match=r"seed(\[\d\])?: expected a whole number, 0 or more, or None; found"
            ):
                env.reset(seed=seed)
    with pytest.raises(QuadrupedError, match="seed: expected one number, or 3, one per env; found 2"):
        vector.reset(seed=[1, 2])


def test_numpy_integers_are_taken_as_whole_numbers():
    env = make_native(np.int64(2), num_threads=np.int32(1), max_episode_steps=np.int64(5))
    assert_same(env.reset(seed=np.int64(3)), env.reset(seed=3))
    assert_same(env.reset(seed=np.array([3, 4])), env.reset(seed=3))
    assert_same(make().reset(seed=np.int64(3)), make().reset(seed=3))


def test_step_before_reset_is_refused_by_every_environment():
    message = r"call reset\(\) first; env 0"
    with pytest.raises(QuadrupedError, match=message):
        make().unwrapped.step(np.zeros(8))
    with pytest.raises(QuadrupedError, match=message):
        make_native(2).step(np.zeros((2, 8)))
    with pytest.raises(QuadrupedError, match=message):
        make_sb3(2).step(np.zeros((2, 8)))


def test_step_after_reset_of_some_environments_names_one_that_was_not_reset():
    env = make_native(3)
    env.reset(options={"reset_mask": np.array([True, False, True])})
    with pytest.raises(QuadrupedError, match=r"call reset\(\) first; env 1 of 3 has no episode yet"):
        env.step(np.zeros((3, 8)))
    env.reset(options={"reset_mask": np.array([False, True, False])})
    env.step(np.zeros((3, 8)))
