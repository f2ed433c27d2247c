"""Environments and random rollouts that the tests of the environments share."""

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode

from quadruped_env.envs import ENV_ID

NUM_ENVS = 6
EPISODE_STEPS = 40
ACTION_MODES = ("position", "residual")

# Rough enough for falls within an episode of EPISODE_STEPS; every randomization and every reward term is on.
# 0.05 s and 0.03 s of latency are no whole numbers of control steps.
ROUGH = {
    "command": {"resample_interval": [0.1, 0.5]},
    "reward": {"weights": {"electrical_power": -0.002}},
    "termination": {"max_tilt": 0.35},
    "randomization": {
        "start_tilt": 0.2,
        "friction": [0.2, 1.2],
        "payload": [-0.5, 1.0],
        "push_velocity": 3.0,
        "push_interval": [0.2, 0.8],
        "observation_noise": 1.0,
        "noise_amplitude": {"joint_velocity": 0.5},
        "link_mass": [0.8, 1.2],
        "link_inertia": [0.8, 1.2],
        "base_com": 0.02,
        "payload_position": 0.05,
        "motor_strength": [0.8, 1.2],
        "supply_voltage": [0.85, 1.05],
        "position_gain": [0.8, 1.2],
        "velocity_gain": [0.8, 1.2],
        "joint_friction": [0.0, 0.1],
        "joint_damping": [0.5, 2.0],
        "rotor_inertia": [0.7, 1.5],
        "encoder_offset": 0.05,
        "imu_mounting": 0.05,
        "target_step": [0.0, 0.02],
        "backlash": [0.0, 0.02],
        "dead_band": [0.0, 0.01],
        "action_latency": [0.0, 0.05],
        "observation_latency": [0.0, 0.03],
        "push_speed": [0.5, 1.0],
        "push_force": [5.0, 20.0],
        "push_force_interval": [0.1, 0.4],
        "push_force_duration": [0.05, 0.2],
    },
}
# Only the time limit ends an episode.
SAFE = {"termination": {"max_tilt": 3.1, "max_trunk_force": 1e9}}


def make(**kwargs):
    return gymnasium.make(ENV_ID, **kwargs)


def make_native(num_envs=NUM_ENVS, **kwargs):
    return gymnasium.make_vec(ENV_ID, num_envs=num_envs, **kwargs)


def make_sync(num_envs=NUM_ENVS, autoreset_mode=AutoresetMode.SAME_STEP, **kwargs):
    vector_kwargs = {"autoreset_mode": autoreset_mode}
    return gymnasium.make_vec(
        ENV_ID, num_envs=num_envs, vectorization_mode="sync", vector_kwargs=vector_kwargs, **kwargs
    )


def assert_same(actual, expected, path="result"):
    """Assert equality in type, shape and every bit, NaN and the sign of zero included."""
    assert type(actual) is type(expected), path
    if isinstance(expected, dict):
        assert sorted(actual) == sorted(expected), path
        for key, value in expected.items():
            assert_same(actual[key], value, f"{path}[{key!r}]")
    elif isinstance(expected, (list, tuple)) or (isinstance(expected, np.ndarray) and expected.dtype == object):
        assert len(actual) == len(expected), path
        for i, (one, other) in enumerate(zip(actual, expected, strict=True)):
            assert_same(one, other, f"{path}[{i}]")
    elif isinstance(expected, (np.ndarray, np.generic)):
        assert (actual.shape, actual.dtype) == (expected.shape, expected.dtype), path
        if actual.tobytes() != expected.tobytes():
            np.testing.assert_array_equal(actual, expected, err_msg=path)
            raise AssertionError(f"{path}: equal but for the bits of a NaN or of a zero")
    elif isinstance(expected, float):
        assert actual.hex() == expected.hex(), path
    else:
        assert actual == expected, path


def episodes(env, steps, seed=0):
    """Results of every call: random actions, with masked, fixed-command and partly seeded resets in between."""
    rng = np.random.default_rng(seed)
    log = [env.reset(seed=seed)]
    for step in range(1, steps + 1):
        action = rng.uniform(-1.3, 1.3, env.action_space.shape).astype(np.float32)
        log.append(env.step(action))
        if step % 37 == 0:
            mask = rng.random(env.num_envs) < 0.5
            mask[rng.integers(env.num_envs)] = True
            options = {"reset_mask": mask}
            if step % 2:
                options["command"] = [0.2, -0.1]
            seeds = [None if rng.random() < 0.5 else int(rng.integers(1000)) for _ in range(env.num_envs)]
            log.append(env.reset(seed=seeds, options=options))
    return log


def play(env, steps, seed=0):
    """Results of every call: random actions in a single environment, with a reset after each episode."""
    rng = np.random.default_rng(seed)
    log = []
    for _ in range(steps):
        log.append(env.step(rng.uniform(-1.0, 1.0, 8).astype(np.float32)))
        if log[-1][2] or log[-1][3]:
            log.append(env.reset())
    return log
