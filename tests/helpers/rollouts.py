"""One rollout of 2 s with the randomization `hard`, and its hashes. As a program, it prints `prescribed`'s."""

import ctypes
import hashlib
import json
import platform

import gymnasium
import mujoco
import numpy as np
from numpy._core import _multiarray_umath as numpy_core

from quadruped_env.envs import ENV_ID
from quadruped_env.policies import load_policy

STEPS = 100


def rollout(name):
    """Results of every step of a shipped policy by quantity, in the order of their computation."""
    policy = load_policy(name)
    env = gymnasium.make(ENV_ID, config=policy.config.randomized("hard"), disable_env_checker=True).unwrapped
    observation, _ = env.reset(seed=0)
    results = {name: [] for name in ("actions", "positions", "velocities", "rewards", "observations")}
    for _ in range(STEPS):
        action = policy.predict(observation)
        observation, reward, *_ = env.step(action)
        row = action, env.data.qpos, env.data.qvel, reward, observation
        for values, value in zip(results.values(), row, strict=True):
            values.append(np.array(value))
    return {name: np.array(values) for name, values in results.items()}


def prescribed():
    """Results of 25 steps of 32 envs with prescribed actions by quantity: a policy's are products of matrices."""
    env = gymnasium.make_vec(ENV_ID, 32, config=load_policy("flat").config.randomized("hard"))
    rng = np.random.default_rng(0)
    env.reset(seed=0)
    steps = [env.step(rng.uniform(-0.5, 0.5, (32, 8)).astype(np.float32)) for _ in range(25)]
    masses = env.unwrapped._simulation.model_field("body_inertia")
    return {
        "inertia": np.array(masses),
        "rewards": np.array([step[1] for step in steps]),
        "observations": np.array([step[0] for step in steps]),
    }


def hashes(results):
    """First 16 digits of the SHA-256 of each quantity."""
    return {name: hashlib.sha256(values.tobytes()).hexdigest()[:16] for name, values in results.items()}


def first_difference(found, expected):
    """The first step and quantity with a difference, and its size; empty if there is none."""
    for step in range(STEPS):
        for name, values in found.items():
            if values[step].tobytes() != expected[name][step].tobytes():
                size = np.abs(np.float64(values[step]) - expected[name][step]).max()
                return f"{name} at step {step}, by up to {size:.1e}"
    return ""


def blas_kernel():
    """Kernel that NumPy's OpenBLAS chose for this processor; of another BLAS its name alone."""
    try:
        name = ctypes.CDLL(numpy_core.__file__).scipy_openblas_get_corename64_
    except AttributeError:
        return np.show_config(mode="dicts")["Build Dependencies"]["blas"]["name"]
    name.restype = ctypes.c_char_p
    return name().decode()


def platform_key():
    """All that decides how numbers are rounded."""
    simd = np.show_config(mode="dicts")["SIMD Extensions"].get("found", [])
    system = f"{platform.system()} {platform.machine()} {' '.join(platform.libc_ver())}"
    return f"{system}, MuJoCo {mujoco.__version__}, NumPy {np.__version__} {'+'.join(simd)}, BLAS {blas_kernel()}"


if __name__ == "__main__":
    print(json.dumps({"kernel": blas_kernel(), "hashes": hashes(prescribed())}))
