"""Latency of actions against shifted actions and compiled delays; pushes and sustained forces against Newton's laws."""

import gymnasium
import mujoco
import numpy as np
import pytest
from settings import settings

from quadruped_env.envs import ENV_ID

BASE = 1


# --- latency of actions ---


def rollout(env, actions, seed=0):
    """Full states (T, ...) of a robot that starts at rest in its stance."""
    env.reset(seed=seed, options={"command": (0.0, 0.0)})
    trace = []
    for action in actions:
        env.step(action)
        trace.append(np.concatenate([env.unwrapped.data.qpos, env.unwrapped.data.qvel]))
    return np.array(trace)


def still(**ranges):
    return gymnasium.make(
        ENV_ID, config=settings(never_ends=True, still_start=True, randomization={**ranges, "start_heading": 0.0})
    )


@pytest.mark.parametrize("steps", [1, 2, 3])
def test_latency_of_whole_control_steps_is_a_shift_of_the_actions(steps):
    actions = np.random.default_rng(0).uniform(-0.4, 0.4, (40, 8))
    late = rollout(still(action_latency=[0.02 * steps] * 2), actions)
    # A zero action is the stance, in which the robot starts.
    shifted = rollout(still(), np.concatenate([np.zeros((steps, 8)), actions[:-steps]]))
    np.testing.assert_allclose(late, shifted, rtol=0.0, atol=1e-9)
    assert abs(late - rollout(still(), actions)).max() > 0.1


@pytest.mark.parametrize("seconds", [0.0025, 0.0125, 0.043, 0.06])
def test_latency_between_control_steps_equals_a_model_compiled_with_that_delay(seconds):
    actions = np.random.default_rng(1).uniform(-0.4, 0.4, (40, 8))
    late = rollout(still(action_latency=[seconds, seconds]), actions)
    config = settings(never_ends=True, still_start=True, randomization={"start_heading": 0.0})
    delayed = gymnasium.make(ENV_ID, config={**config, "motor": {"delay": seconds}})
    np.testing.assert_array_equal(late, rollout(delayed, actions))
    both = gymnasium.make(
        ENV_ID,
        config={
            **settings(
                never_ends=True,
                still_start=True,
                randomization={"start_heading": 0.0, "action_latency": [seconds / 2.0] * 2},
            ),
            "motor": {"delay": seconds / 2.0},
        },
    )
    np.testing.assert_allclose(rollout(both, actions), late, rtol=0.0, atol=1e-9)


# --- sustained forces ---


def test_force_accelerates_the_whole_robot_by_its_mass_for_its_duration():
    """In flight, where the only other force is gravity: Newton's second law, from the momentum over each step."""
    env = gymnasium.make(
        ENV_ID,
        config=settings(
            never_ends=True,
            still_start=True,
            fast_control=True,
            randomization={
                "push_force": [2.0, 6.0],
                "push_force_interval": [0.1, 0.1],
                "push_force_duration": [0.02, 0.06],
            },
        ),
    )
    robot = env.unwrapped
    durations, directions = [], []
    for seed in range(12):
        env.reset(seed=seed)
        robot.data.qpos[2] += 5.0
        mujoco.mj_step1(robot.model, robot.data)
        forces, before = [], momentum(robot)
        for _ in range(40):
            env.step(np.zeros(8))
            after = momentum(robot)
            forces.append((after - before) / 0.005)
            before = after
        forces = np.array(forces)
        # The legs move, which the integrator follows to its first order.
        np.testing.assert_allclose(forces[:, 2], -9.81 * 4.0, rtol=1e-4)
        pushed = np.hypot(*forces[:, :2].T) > 1.0
        # Drawn at the end of the step at 0.1 s, so that the force acts from the next step on.
        assert not pushed[:20].any()
        length = int(np.argmin(pushed[20:]))
        assert pushed[20 : 20 + length].all()
        assert not pushed[20 + length :].any()
        assert 4 <= length <= 12
        np.testing.assert_allclose(forces[20 : 20 + length], forces[[20] * length], atol=1e-3)
        np.testing.assert_allclose(forces[~pushed, :2], 0.0, atol=1e-3)
        assert 2.0 <= np.hypot(*forces[20, :2]) <= 6.0
        durations.append(length)
        directions.append(np.arctan2(forces[20, 1], forces[20, 0]))
    assert len(set(durations)) > 3
    assert np.ptp(directions) > 3.0


def momentum(robot):
    mujoco.mj_subtreeVel(robot.model, robot.data)
    return robot.model.body_subtreemass[BASE] * robot.data.subtree_linvel[BASE]


def test_force_ends_with_the_episode():
    config = settings(
        randomization={"push_force": [5.0, 5.0], "push_force_interval": [0.02, 0.02], "push_force_duration": [9.0, 9.0]}
    )
    env = gymnasium.make(ENV_ID, config=config)
    env.reset(seed=0)
    env.step(np.zeros(8))
    assert np.hypot(*env.unwrapped.data.xfrc_applied[BASE, :2]) == pytest.approx(5.0)
    env.reset()
    np.testing.assert_array_equal(env.unwrapped.data.xfrc_applied, 0.0)


def test_push_of_a_speed_adds_it_in_a_horizontal_direction():
    env = still(push_speed=[0.75, 0.75], push_interval=[0.1, 0.1])
    quiet = still()
    for e in (env, quiet):
        e.reset(seed=0, options={"command": (0.0, 0.0)})
    for step in range(1, 6):
        for e in (env, quiet):
            e.step(np.zeros(8))
        change = env.unwrapped.data.qvel - quiet.unwrapped.data.qvel
        if step < 5:
            np.testing.assert_array_equal(change, 0.0)
    assert np.hypot(*change[:2]) == pytest.approx(0.75, rel=1e-12)
    np.testing.assert_array_equal(change[2:], 0.0)
