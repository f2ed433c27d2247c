"""Left/right symmetry of the task, and of a policy that is built to be symmetric."""

import math

import gymnasium
import numpy as np
import pytest
import twelve_joints
from mirroring import mirrored
from tasks import ACTION_WIDTH, OBSERVATION_WIDTH

import quadruped_env  # noqa: F401  registers the environment
from quadruped_env.control.control_config import ACTION_MODES
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.robot import MINI_QUADRUPED

ROW = np.array([0])
MIRROR = MirrorMap.of(ObservationLayout(MINI_QUADRUPED, history=3))


CASES = [
    *((MINI_QUADRUPED, given) for given in [(0.4, 0.5), (-0.2, -0.3), (0.0, 0.0)]),
    *((twelve_joints.ROBOT, given) for given in [(0.4, 0.5, -0.2), (0.0, 0.0, 0.2)]),
]


@pytest.mark.parametrize("mode", ACTION_MODES)
@pytest.mark.parametrize(("kind", "command"), CASES, ids=lambda case: getattr(case, "name", str(case)))
def test_mirrored_actions_give_mirrored_observations_and_the_same_reward(mode, kind, command):
    rng = np.random.default_rng(0)
    robot, mirror = (gymnasium.make("MiniQuadruped-v0", action_mode=mode, robot=kind).unwrapped for _ in range(2))
    columns = MirrorMap.of(ObservationLayout(kind, history=3))
    robot.reset(seed=0, options={"command": command})
    mirror.reset(seed=1, options={"command": np.array(command) * [1.0, -1.0, -1.0][: len(command)]})
    qpos, qvel, _ = mirrored(robot.data.qpos, robot.data.qvel, kind.stance, kind)
    mirror.task.simulation.reset(ROW, qpos[None], qvel[None])
    mirror.task.control.phase[:] = (robot.task.control.phase + math.pi) % math.tau
    mirror.task.observe()  # before the first step, so that the past is the mirrored start, too
    privileged = [one.task.privileged_readings() for one in (robot, mirror)]
    mirror_privileged = MirrorMap.of(privileged[0].layout)
    for _ in range(25):
        action = rng.uniform(-1, 1, kind.num_joints)
        observation, reward, fallen, _, info = robot.step(action)
        other, other_reward, other_fallen, _, other_info = mirror.step(columns.action(action))
        np.testing.assert_allclose(other, columns.observation(observation), atol=1e-5)
        hidden, other_hidden = (readings.values() for readings in privileged)
        np.testing.assert_allclose(other_hidden, mirror_privileged.observation(hidden), atol=1e-5)
        assert other_reward == pytest.approx(reward, abs=1e-6)
        terms = {name: value for name, value in info.items() if name.startswith("reward_")}
        assert {name: other_info[name] for name in terms} == pytest.approx(terms, abs=1e-6)
        assert other_fallen == fallen
        if fallen:
            break


def test_mirroring_twice_changes_nothing():
    rng = np.random.default_rng(0)
    observation, action = rng.normal(size=(3, OBSERVATION_WIDTH)), rng.normal(size=(3, ACTION_WIDTH))
    np.testing.assert_array_equal(MIRROR.observation(MIRROR.observation(observation)), observation)
    np.testing.assert_array_equal(MIRROR.action(MIRROR.action(action)), action)
    assert (MIRROR.observation(observation) != observation).any()
    assert (MIRROR.action(action) != action).any()


def test_symmetric_policy_gives_mirrored_actions_and_equal_values_on_both_sides():
    import torch
    from networks import perturb

    from quadruped_env.envs import make_sb3_vec_env
    from quadruped_env.training import TrainConfig
    from quadruped_env.training.sb3_models import make_model

    observation = np.random.default_rng(0).uniform(-1, 1, (50, OBSERVATION_WIDTH)).astype(np.float32)
    both = torch.as_tensor(np.stack([observation, MIRROR.observation(observation)]))
    differs = {}
    for symmetric in (True, False):
        torch.manual_seed(0)
        config = TrainConfig(num_envs=2, n_steps=8, batch_size=16, symmetric=symmetric)
        model = make_model(config, make_sb3_vec_env(2, seed=0))
        perturb(model, 0.1)
        with torch.no_grad():
            mean = [model.policy.get_distribution(side).distribution.mean.numpy() for side in both]
            value = [model.policy.predict_values(side).numpy() for side in both]
        differs[symmetric] = max(abs(mean[1] - MIRROR.action(mean[0])).max(), abs(value[1] - value[0]).max())
    assert differs[True] < 1e-5  # float32, whose sums differ in order
    assert differs[False] > 0.01
