"""Directions of motion under every controller: forwards is +x of the base, a positive yaw rate turns left."""

from dataclasses import replace

import gymnasium
import numpy as np
import pytest

from quadruped_env import CommandedGait, JointTrajectory, SinusoidalGait
from quadruped_env.envs import ENV_ID
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.gait import PRESETS
from quadruped_env.policies import (
    GaitController,
    PolicyController,
    TrajectoryController,
    ZeroController,
    load_policy,
)
from quadruped_env.robot import JOINT_NAMES

SECONDS, WARM_UP, DT = 4.0, 1.0, 0.02
SEEDS = (0, 1)
COMMANDS = ((0.4, 0.0), (-0.2, 0.0), (0.0, 0.5), (0.0, -0.5), (0.3, 0.5), (0.3, -0.5), (-0.2, 0.4), (-0.2, -0.4))
"""Velocity commands, m/s and rad/s."""
STANDING = (0.0, 0.0)
JOINT_MIRROR = [2, 3, 0, 1, 6, 7, 4, 5]


def velocities(positions, quaternions):
    """Mean forward velocity (m/s) and yaw rate (rad/s) after the warm-up, from poses (T, N, ...) of the base."""
    w, x, y, z = np.moveaxis(quaternions.astype(np.float64), -1, 0)
    yaw = np.unwrap(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)), axis=0)[round(WARM_UP / DT) :]
    step = np.diff(positions.astype(np.float64)[round(WARM_UP / DT) :, :, :2], axis=0)
    forward = step[..., 0] * np.cos(yaw[1:]) + step[..., 1] * np.sin(yaw[1:])
    return forward.mean(axis=0) / DT, (yaw[-1] - yaw[0]) / (len(yaw) - 1) / DT


def walked(controller, commands, seeds=SEEDS, seconds=SECONDS):
    """Mean forward velocity and yaw rate (K, 2) under each command; asserts that no robot falls."""
    rollout = roll_out(controller, commands, seeds, seconds)
    assert not rollout.fallen.any()
    found = np.stack(velocities(rollout.base_position, rollout.orientation), axis=1)
    return found.reshape(len(commands), len(seeds), 2).mean(axis=1)


def walked_with_changed_settings(commands):
    """As `walked`, with the searched gait as the viewer controls it, one robot at a time."""
    found = []
    for command in commands:
        controller = GaitController(CommandedGait.preset("tuned"))
        controller.settings = replace(controller.settings, amplitude=1.05)
        found.append(walked(controller, [command], seeds=[0]))
    return np.concatenate(found)


def walked_in_env(mode, commands, policy=None, **config):
    """As `walked`, in the native vector env; the zero action without a policy."""
    env = gymnasium.make_vec(ENV_ID, num_envs=len(commands), action_mode=mode, config=config)
    for i, command in enumerate(commands):
        mask = np.arange(len(commands)) == i
        observation, info = env.reset(seed=0, options={"command": command, "reset_mask": mask})
    forward, yaw_rate = [], []
    for _ in range(round(SECONDS / DT)):
        action = np.zeros((len(commands), 8), dtype=np.float32) if policy is None else policy.predict(observation)
        observation, _, fallen, _, info = env.step(action)
        assert not fallen.any()
        forward.append(info["base_linear_velocity"][:, 0])
        yaw_rate.append(info["base_angular_velocity"][:, 2])
    return np.array([forward, yaw_rate])[:, round(WARM_UP / DT) :].mean(axis=1).T


FOLLOWERS = {
    "searched gait": lambda: walked(GaitController(), COMMANDS),
    "searched gait in the viewer": lambda: walked_with_changed_settings(COMMANDS),
    "searched gait under a residual policy": lambda: walked_in_env("residual", COMMANDS, action={"gait": "tuned"}),
    "searched gait at each command": lambda: np.concatenate(
        [walked(GaitController(CommandedGait.preset("tuned").at(command), "at"), [STANDING]) for command in COMMANDS]
    ),
    "shipped policy": lambda: walked(PolicyController(load_policy("flat")), COMMANDS),
    "shipped policy in its env": lambda: walked_in_env("residual", COMMANDS, load_policy("flat")),
}


QUICK = ("searched gait", "shipped policy in its env")


@pytest.mark.parametrize(
    "name", [name if name in QUICK else pytest.param(name, marks=pytest.mark.slow) for name in FOLLOWERS]
)
def test_command_follower_goes_and_turns_as_commanded(name):
    forward, yaw_rate = FOLLOWERS[name]().T
    for i, command in enumerate(COMMANDS):
        for value, wanted in ((forward[i], command[0]), (yaw_rate[i], command[1])):
            # The open-loop gait on slipping feet reaches only a third of some commands.
            assert value * np.sign(wanted) >= abs(wanted) / 4, (
                f"{command}: {forward[i]:.3f} m/s, {yaw_rate[i]:.3f} rad/s"
            )
        if command[1] == 0.0:
            assert abs(yaw_rate[i]) < 0.2, command
        assert abs(forward[i] - command[0]) < 0.25, command
    found = dict(zip(COMMANDS, zip(forward, yaw_rate, strict=True), strict=True))
    for v, w in COMMANDS:
        if w > 0:
            left, right = found[v, w], found[v, -w]
            assert left[0] == pytest.approx(right[0], abs=0.1), "the mirrored command must be as fast"
            assert left[1] == pytest.approx(-right[1], abs=0.2), "the mirrored command must turn the other way"


@pytest.mark.parametrize(
    "make", [ZeroController, GaitController, lambda: PolicyController(load_policy("flat"))],
    ids=["zero", "searched gait", "shipped policy"],
)  # fmt: skip
def test_controller_at_a_standing_command_stays_where_it_is(make):
    forward, yaw_rate = walked(make(), [STANDING])[0]
    assert abs(forward) < 0.02
    assert abs(yaw_rate) < 0.05


@pytest.mark.parametrize(
    ("preset", "speed"),
    [("article", 0.0), ("trot", 0.4), ("walk", 0.25), ("bound", 0.35), ("pace", 0.3), ("tuned", 0.4), ("low", 0.4)],
)
def test_gait_preset_walks_straight_ahead_under_any_command(preset, speed):
    assert preset in PRESETS
    gait = SinusoidalGait.preset(preset)
    for forward, yaw_rate in walked(GaitController(gait, preset), [STANDING, (-0.2, 0.6)]):
        assert forward == pytest.approx(speed, abs=0.1)
        assert abs(yaw_rate) < 0.2


def test_recording_of_a_gait_goes_where_the_gait_goes():
    gait = CommandedGait.preset("tuned").at((0.2, 0.5))
    times = np.arange(round(SECONDS / DT) + 1) * DT
    stamps = 7_000_000_000 + np.rint(times * 1e9).astype(np.int64)
    # Joint names in another order, as in a recording.
    order = np.roll(np.arange(8), 3)
    recording = JointTrajectory(
        stamps=stamps, names=[JOINT_NAMES[i] for i in order], positions=gait.positions(times)[:, order]
    )
    by_recording, by_gait = (
        roll_out(controller, [STANDING], SEEDS, SECONDS)
        for controller in (TrajectoryController(recording), GaitController(gait, "gait"))
    )
    np.testing.assert_allclose(by_recording.joint_position, by_gait.joint_position, atol=1e-3)


def test_recording_that_has_ended_holds_its_last_positions():
    last = np.array([0.5, -0.6] * 4)
    recording = JointTrajectory(
        stamps=np.array([0, 500_000_000]), names=JOINT_NAMES, positions=np.stack([[0.6, -0.72] * 4, last])
    )
    rollout = roll_out(TrajectoryController(recording), [STANDING], [0], 2.0)
    np.testing.assert_allclose(rollout.joint_position[-1, 0], last, atol=0.1)
    assert abs(rollout.joint_velocity[-1]).max() < 0.05


def test_shipped_policy_mirrors_its_action_with_its_observation():
    policy = load_policy("flat")
    observation = np.random.default_rng(0).uniform(-1.0, 1.0, (100, 3 * 34)).astype(np.float32)
    mirror, sign = np.arange(34), np.ones(34, dtype=np.float32)
    for start in (6, 14, 22):
        mirror[start : start + 8] = start + np.array(JOINT_MIRROR)
    sign[[1, 3, 5, 31, 32, 33]] = -1.0  # gravity y; roll and yaw rate; commanded yaw rate; half a cycle of the clock
    mirror, sign = np.concatenate([mirror, 34 + mirror, 68 + mirror]), np.tile(sign, 3)
    action, mirrored = policy.predict(observation), policy.predict(observation[:, mirror] * sign)
    np.testing.assert_allclose(mirrored, action[:, JOINT_MIRROR], atol=1e-5)
    assert abs(mirrored - action).max() > 0.01
