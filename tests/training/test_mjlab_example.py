"""The example for mjlab, in an interpreter with mjlab that MJLAB_PYTHON names: it trains, and its policy comes back."""

import math
import os
import subprocess

import gymnasium
import numpy as np
import pytest
from paths import ROOT
from waiting import DEADLINE

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.envs import ENV_ID
from quadruped_env.policies import Policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig

EXAMPLE = ROOT / "examples" / "mjlab" / "train.py"
PYTHON = os.environ.get("MJLAB_PYTHON", "")
CONFIG = {"observation_history": 1}
STEPS = 12
WATCHED = """
import runpy, sys, numpy as np, torch
from mjlab.envs import ManagerBasedRlEnv
from mjlab.rl import RslRlVecEnvWrapper
cfg = runpy.run_path(sys.argv[1])["env_cfg"]()
cfg.scene.num_envs, cfg.seed, cfg.events = 2, 0, {name: cfg.events[name] for name in ("base", "joints")}
cfg.events["base"].params = {"pose_range": {}, "velocity_range": {}}
cfg.events["joints"].params |= {"position_range": (0.0, 0.0), "velocity_range": (0.0, 0.0)}
cfg.observations["actor"].enable_corruption = False
env = ManagerBasedRlEnv(cfg, device="cpu")
wrapped = RslRlVecEnvWrapper(env, clip_actions=1.0)
seen = []
def look(observation):
    robot = env.scene["robot"].data
    seen.append({
        "observation": observation["actor"], "gravity": robot.projected_gravity_b, "rate": robot.root_link_ang_vel_b,
        "position": robot.joint_pos, "velocity": robot.joint_vel, "action": env.action_manager.action,
        "command": env.command_manager.get_command("twist")[:, [0, 2]], "step": env.episode_length_buf,
        "height": robot.root_link_pos_w[:, 2],
    })
    seen[-1] = {name: np.array(value.detach().clone()) for name, value in seen[-1].items()}
actions = torch.from_numpy(np.load(sys.argv[2]))
look(wrapped.get_observations())
for action in actions:
    look(wrapped.step(action.tile(2, 1))[0])
np.savez(sys.argv[3], **{name: np.stack([one[name] for one in seen]) for name in seen[0]})
"""


def test_example_is_small_and_compiles():
    text = EXAMPLE.read_text()
    compile(text, str(EXAMPLE), "exec")
    assert len(text.splitlines()) <= 300


@pytest.fixture(scope="module")
def mjlab():
    """Function that runs a program with mjlab's interpreter."""
    if not PYTHON:
        pytest.skip("no interpreter with mjlab: name one in MJLAB_PYTHON (examples/mjlab/README.md)")

    def run(*arguments, cwd):
        # Not this package's paths: MuJoCo has another version there.
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        command = [PYTHON, *map(str, arguments)]
        done = subprocess.run(
            command, cwd=cwd, env=environment, capture_output=True, text=True, check=False, timeout=DEADLINE
        )
        assert done.returncode == 0, done.stderr[-3000:]

    return run


@pytest.mark.slow
def test_example_trains_and_its_policy_comes_back(mjlab, tmp_path):
    options = ("--gpu-ids", "None", "--env.scene.num-envs", 4, "--agent.max-iterations", 1)
    mjlab(EXAMPLE, "Mini-Quadruped", *options, cwd=tmp_path)
    (path,) = tmp_path.glob("logs/rsl_rl/mini_quadruped/*/*.onnx")
    policy = Policy.from_onnx(path, action_mode="position", config=CONFIG)
    env = policy.make_env()
    observation, _ = env.reset(seed=0)
    for _ in range(10):
        observation, *_ = env.step(policy.predict(observation))
    assert observation in env.observation_space


@pytest.mark.slow
def test_observations_and_motion_are_those_of_this_package(mjlab, tmp_path):
    time = 0.02 * np.arange(STEPS)[:, None]
    actions = 0.5 * np.sin(math.tau * (time + np.arange(8) / 8.0)).astype(np.float32)
    np.save(tmp_path / "actions.npy", actions)
    (tmp_path / "watch.py").write_text(WATCHED)
    mjlab("watch.py", EXAMPLE, "actions.npy", "seen.npz", cwd=tmp_path)
    seen = dict(np.load(tmp_path / "seen.npz"))
    layout = ObservationLayout(MINI_QUADRUPED)
    phase = math.tau * 3.4 * 0.02 * seen["step"][..., None]
    moving = (np.abs(seen["command"]) > 0.02).any(axis=-1, keepdims=True)
    raw = [
        *(seen[name] for name in ("gravity", "rate")),
        seen["position"] - MINI_QUADRUPED.stance,
        *(seen[name] for name in ("velocity", "action", "command")),
        np.concatenate([np.sin(phase), np.cos(phase)], axis=-1) * moving,
    ]
    expected = np.clip(np.concatenate(raw, axis=-1) * layout.scale, layout.low, layout.high)
    np.testing.assert_allclose(seen["observation"], expected, atol=1e-5)
    assert np.abs(seen["command"]).max() > 0.02
    # Motors, contacts and action scale: the same joints and height, but for explicit motors instead of implicit ones.
    start = dict.fromkeys((name for name in TaskConfig().to_dict()["randomization"] if name.startswith("start_")), 0.0)
    env = gymnasium.make(ENV_ID, action_mode="position", config={**CONFIG, "randomization": start})
    env.reset(seed=0)
    for number, action in enumerate(actions, 1):
        env.step(action)
        qpos = env.unwrapped.data.qpos
        np.testing.assert_allclose(seen["position"][number], [qpos[7:]] * 2, atol=0.05)
        np.testing.assert_allclose(seen["height"][number], qpos[2], atol=0.01)
