"""Shipped policies, and the environment that a policy makes for its task."""

import numpy as np
import pytest
import second_robot
from gymnasium import make, make_vec
from policies import TASK, make_policy

from quadruped_env import QuadrupedError
from quadruped_env.envs import ENV_ID
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.policies import Policy, PolicyController, load_policy
from quadruped_env.policies.files import SHIPPED
from quadruped_env.task import TaskConfig, load_task_file

# --- the shipped policies ---


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_policy_follows_its_velocity_commands(name):
    policy = load_policy(name)
    assert {"command", "seed", "versions", "git_commit"} <= set(policy.card)
    config = policy.config.on_terrain("flat").randomized("none")
    env = make_vec(ENV_ID, num_envs=4, action_mode=policy.action_mode, config=config)
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
        ({"action": {"mode": "residual", "gait": "low"}, "decimation": 5}, r"action\.gait 'sinusoid', .* has 'low'"),
        (
            {"action": {"mode": "residual"}, "decimation": 5, "clock_frequency": 3.0},
            r"clock_frequency 3\.4, .* has 3\.0",
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


OTHER_SCALE = """
from quadruped_env.task import observation

@observation(unit="rad/s", mirror="joints", scale=0.1, bound=3.0)
def joint_velocity(readings, control):
    "Joint velocities, with another scale."
    return readings.joint_velocity
"""
ONE_MORE = """
from quadruped_env.task import observation

@observation(unit="m", mirror=(1.0,))
def base_height(readings, control):
    "Height of the base."
    return readings.base_position[:, 2:]
"""


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (OTHER_SCALE, r"the observation joint_velocity .*0.2.*has .*0.1"),
        (ONE_MORE, r"the observations .*, gait_clock, base_height"),
    ],
)
def test_task_with_other_observations_is_refused(text, message, tmp_path):
    (tmp_path / "mine.py").write_text(text)
    policy, task = make_policy(), load_task_file(tmp_path / "mine.py")
    config = TaskConfig.from_dict(TASK.to_dict(), task)
    env = make(ENV_ID, config=config)
    pattern = rf"it was trained with {message}.*; make its own with policy"
    with pytest.raises(QuadrupedError, match=pattern):
        policy.check_env(env)
    with pytest.raises(QuadrupedError, match=pattern):
        roll_out(PolicyController(policy), [(0.3, 0.0)], [0], 1.0, config)
    env.close()


def test_every_kind_of_env_is_checked():
    from stable_baselines3.common.vec_env import DummyVecEnv, VecNormalize

    from quadruped_env.envs import make_sb3_vec_env

    policy = make_policy()
    for config, matches in ((TASK.to_dict(), True), ({}, False)):
        envs = [
            make(ENV_ID, config=config),
            make_vec(ENV_ID, num_envs=2, config=config),
            make_vec(ENV_ID, num_envs=2, vectorization_mode="sync", config=config),
            make_sb3_vec_env(2, seed=0, config=config),
            VecNormalize(make_sb3_vec_env(2, seed=0, config=config)),
            DummyVecEnv([lambda config=config: make(ENV_ID, config=config)]),
        ]
        for env in envs:
            if matches:
                policy.check_env(env)
            else:
                with pytest.raises(
                    QuadrupedError, match=r"action\.mode 'residual', and this environment has 'position'"
                ):
                    policy.check_env(env)
            env.close()


def test_check_env_of_another_environment_is_refused():
    with pytest.raises(QuadrupedError, match=r"is not an environment of this package; make one with policy.make_env"):
        make_policy().check_env(make("CartPole-v1"))


# --- other robots, and users' files ---

OWN_TERM = '''
from quadruped_env.task import reward


@reward(weight=-3.0)
def own_term(context):
    """One where the robot has fallen."""
    return context.fallen
'''


@pytest.mark.parametrize("text", [OWN_TERM, ONE_MORE])
def test_policy_that_needs_no_users_file_is_not_affected_by_one(run_directory, tmp_path, text):
    (tmp_path / "own.py").write_text(text)
    config = load_policy(run_directory, task_file=tmp_path / "own.py").config
    assert config == TASK
    assert "own_term" not in config.reward.weights


def test_policy_for_another_robot_has_an_env_with_that_robot_and_is_refused_in_others():
    own, other = make_policy(), TASK.for_robot(second_robot.ROBOT)
    policy = Policy.for_task(own.weights, own.biases, own.activation, other, own.card)
    task = policy.make_env().unwrapped.task
    assert task.config == policy.config == other
    with pytest.raises(QuadrupedError, match=f"made for the robot '{second_robot.ROBOT.name}'"):
        policy.check_env(own.make_env())
    with pytest.raises(QuadrupedError, match="made for the robot 'mini_quadruped'"):
        PolicyController(own).act(task.observe(), task.control)
