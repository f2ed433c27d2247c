"""Every random draw of the task: its law, and its independence of all the others.

Read from outside: from what an env returns, and from MuJoCo's own state and model.
"""

import math

import gymnasium
import mujoco
import numpy as np
import pytest
from laws import (
    NEIGHBOURS,
    assert_equally_likely,
    assert_independent,
    assert_probability,
    assert_uniform,
    assert_unrelated,
    share,
)
from settings import PHYSICS_TIMESTEP, settings

from quadruped_env.envs import ENV_ID

STANCE = (0.6, -0.72) * 4
FRICTION, PAYLOAD = (0.3, 0.9), (-0.4, 1.0)
# Never near zero, so that the gait clock is always observed.
FORWARD, YAW_RATE = (0.1, 0.6), (-0.8, 0.8)
CLOCK = slice(32, 34)


def make_vec(num_envs, config, **kwargs):
    return gymnasium.make_vec(ENV_ID, num_envs=num_envs, config=config, **kwargs)


def zeros(env):
    return np.zeros(env.action_space.shape, dtype=np.float32)


def phases(observation):
    """Phase of the gait clock, as a share of its cycle."""
    sine, cosine = np.moveaxis(observation[..., CLOCK].astype(np.float64), -1, 0)
    return np.arctan2(sine, cosine) / math.tau % 1.0


def joint_draws(info):
    """Start positions and velocities of the joints, which are 0.1 rad and 0.5 rad/s around the stance at rest."""
    positions = share(info["joint_position"] - STANCE, -0.1, 0.1)
    velocities = share(info["joint_velocity"], -0.5, 0.5)
    return {f"joint position {i}": positions[..., i] for i in range(8)} | {
        f"joint velocity {i}": velocities[..., i] for i in range(8)
    }


def command_draws(command):
    return {"forward velocity": share(command[..., 0], *FORWARD), "yaw rate": share(command[..., 1], *YAW_RATE)}


# --- the start of an episode ---


def attitude(quaternion):
    """Roll, pitch and yaw in rad of quaternions wxyz (..., 4): turned by yaw, then pitch, then roll."""
    w, x, y, z = np.moveaxis(quaternion, -1, 0)
    roll = np.arctan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    pitch = np.arcsin(2 * (w * y - z * x))
    yaw = np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    return roll, pitch, yaw


@pytest.fixture(scope="module")
def starts():
    """All that is drawn at a reset: name -> share of its range (episodes, envs)."""
    config = settings(
        friction=FRICTION, payload=PAYLOAD, forward_velocity=FORWARD, yaw_rate=YAW_RATE, shares=(0.0, 0.0)
    )
    envs = make_vec(16, config, vectorization_mode="sync")
    singles = [env.unwrapped for env in envs.envs]
    base = singles[0].model.body("base_link").id
    plain_mass = gymnasium.make(ENV_ID).unwrapped.model.body_mass[base]
    episodes = []
    for episode in range(64):
        observation, info = envs.reset(seed=5 if episode == 0 else None)
        episodes.append(
            {
                "observation": observation,
                "joint_position": np.array(info["joint_position"]),
                "joint_velocity": np.array(info["joint_velocity"]),
                "command": np.array(info["command"]),
                "qpos": np.array([env.data.qpos for env in singles]),
                "qvel": np.array([env.data.qvel for env in singles]),
                "friction": np.array([env.model.geom("ground").friction[0] for env in singles]),
                "mass": np.array([env.model.body_mass[base] for env in singles]),
            }
        )
    record = {name: np.array([episode[name] for episode in episodes]) for name in episodes[0]}
    roll, pitch, yaw = attitude(record["qpos"][..., 3:7])
    base_velocity = share(record["qvel"][..., :6], -0.2, 0.2)
    return {
        **joint_draws(record),
        **{f"base velocity {i}": base_velocity[..., i] for i in range(6)},
        "roll": share(roll, -0.05, 0.05),
        "pitch": share(pitch, -0.05, 0.05),
        "yaw": share(yaw, -math.pi, math.pi),
        "gait phase": phases(record["observation"]),
        "friction": share(record["friction"], *FRICTION),
        "payload": share(record["mass"] - plain_mass, *PAYLOAD),
        **command_draws(record["command"]),
    }


def test_starts_every_quantity_is_uniform_over_its_whole_range(starts):
    assert_uniform(starts)


def test_starts_no_two_quantities_of_an_episode_are_related(starts):
    assert_independent(starts)


def test_starts_neighbouring_envs_and_episodes_are_unrelated(starts):
    assert_independent(starts, NEIGHBOURS)


def test_starts_after_an_autoreset_have_the_same_laws():
    config = settings(forward_velocity=FORWARD, yaw_rate=YAW_RATE, shares=(0.0, 0.0), fast_control=True)
    env = make_vec(128, config, max_episode_steps=1)
    env.reset(seed=3)
    episodes = []
    for _ in range(16):
        observation, _, _, truncated, info = env.step(zeros(env))
        assert truncated.all()
        episodes.append(joint_draws(info) | command_draws(info["command"]) | {"gait phase": phases(observation)})
    draws = {name: np.array([episode[name] for episode in episodes]) for name in episodes[0]}
    assert_uniform(draws)
    assert_independent(draws, ((0, 0), *NEIGHBOURS))


# --- commands ---


@pytest.fixture(scope="module", params=["first of an episode", "resampled within an episode"])
def commands(request):
    """Commands of the default law (A, envs, 2)."""
    if request.param.startswith("first"):
        env = make_vec(512, {})
        return np.array([env.reset(seed=1 if episode == 0 else None)[1]["command"] for episode in range(10)])
    config = settings(resample=(PHYSICS_TIMESTEP,) * 2, sudden=True, fast_control=True, never_ends=True)
    env = make_vec(512, config)
    env.reset(seed=1)
    # That of the first step is the first of the episode.
    return np.array([env.step(zeros(env))[4]["command"] for _ in range(11)])[1:]


def kinds(commands):
    """The kind of each command: standing, straight ahead, turning in place, or a curve."""
    ahead, turned = commands[..., 0] != 0, commands[..., 1] != 0
    return ~ahead & ~turned, ahead & ~turned, ~ahead & turned, ahead & turned


def test_commands_stand_go_straight_and_turn_in_place_in_their_shares(commands):
    standing, straight, in_place, _ = kinds(commands)
    assert_probability(standing, 0.1, "standing commands")
    assert_probability(straight, 0.25, "straight commands")
    assert_probability(in_place, 0.15, "commands to turn in place")


def test_commands_are_uniform_and_independent_whatever_their_kind(commands):
    _, straight, in_place, curve = kinds(commands)
    forward, yaw_rate = share(commands[..., 0], -0.3, 0.6), share(commands[..., 1], -0.8, 0.8)
    assert_uniform(
        {
            "forward velocity going straight": forward[straight],
            "forward velocity on a curve": forward[curve],
            "yaw rate on a curve": yaw_rate[curve],
            "yaw rate turning in place": yaw_rate[in_place],
        }
    )
    assert_unrelated({"forward velocity": forward[curve]}, {"yaw rate": yaw_rate[curve]})


def test_commands_are_unrelated_to_their_neighbours(commands):
    standing, straight, in_place, curve = kinds(commands)
    draws = {
        "standing": np.where(standing, 1.0, 0.5),
        "straight": np.where(straight, 1.0, 0.5),
        "in place": np.where(in_place, 1.0, 0.5),
        "forward velocity": np.where(straight | curve, share(commands[..., 0], -0.3, 0.6), 0.5),
        "yaw rate": np.where(in_place | curve, share(commands[..., 1], -0.8, 0.8), 0.5),
    }
    assert_independent(draws, NEIGHBOURS)


def test_resampling_intervals_are_uniform_and_independent_of_commands_and_starts():
    envs, count = 256, 8
    # 2.5 to 12.5 control steps: 3 to 12 are equally likely once rounded.
    interval = (2.5 * PHYSICS_TIMESTEP, 12.5 * PHYSICS_TIMESTEP)
    config = settings(
        resample=interval,
        sudden=True,
        forward_velocity=FORWARD,
        yaw_rate=YAW_RATE,
        shares=(0.0, 0.0),
        fast_control=True,
        never_ends=True,
    )
    env = make_vec(envs, config)
    observation, info = env.reset(seed=2)
    start = joint_draws(info) | {"gait phase": phases(observation)}
    history = [info["command"]]
    for _ in range(12 * count + 1):
        history.append(env.step(zeros(env))[4]["command"])
    history = np.array(history)
    changed = (history[1:] != history[:-1]).all(axis=-1)
    np.testing.assert_array_equal(changed, (history[1:] != history[:-1]).any(axis=-1))
    lengths, values = [], []
    for i in range(envs):
        times = np.flatnonzero(changed[:, i]) + 1
        assert len(times) >= count
        lengths.append(np.diff(times[:count], prepend=0))
        values.append(history[[0, *times[: count - 1]], i])
    lengths, values = np.array(lengths).T, np.array(values).swapaxes(0, 1)
    assert lengths.min() == 3
    assert lengths.max() == 12
    assert_equally_likely(np.bincount(lengths.ravel())[3:], "intervals of 3 to 12 steps")
    assert_equally_likely(np.bincount(lengths[0])[3:], "first intervals of 3 to 12 steps")
    draws = {"interval": share(lengths, 2.5, 12.5), **command_draws(values)}
    assert_independent(draws, ((0, 0), *NEIGHBOURS, (2, 0)))
    for place in range(3):
        assert_unrelated(start, {f"{name}, number {place}": values[place] for name, values in draws.items()})


# --- pushes ---


def test_pushes_are_uniform_in_size_and_time_and_independent():
    envs, count, size, turn = 4, 40, 0.5, 0.9
    config = settings(
        push_velocity=size,
        randomization={"push_rotation": turn},
        push_interval=(2.5 * PHYSICS_TIMESTEP, 6.5 * PHYSICS_TIMESTEP),
        fast_control=True,
        never_ends=True,
    )
    # Of the base's velocity, and of its rotation, which have times of their own.
    pushes, lengths = np.zeros((2, count, envs, 3)), np.zeros((2, count, envs), dtype=int)
    for i in range(envs):
        env = gymnasium.make(ENV_ID, config=config, max_episode_steps=10**6)
        robot = env.unwrapped
        # The same state and targets, stepped by MuJoCo alone.
        alone = mujoco.MjData(robot.model)
        env.reset(seed=i)
        action, found, since = np.zeros(8, dtype=np.float32), [0, 0], [0, 0]
        for _ in range(8 * count):  # intervals have 6 steps or fewer
            mujoco.mj_copyData(alone, robot.model, robot.data)
            env.step(action)
            alone.ctrl = robot.data.ctrl
            mujoco.mj_step(robot.model, alone)
            push = robot.data.qvel - alone.qvel
            np.testing.assert_allclose(push[6:], 0.0, atol=1e-12)
            for kind, part in enumerate((push[:3], push[3:6])):
                since[kind] += 1
                if abs(part).max() > 1e-9:
                    if found[kind] < count:
                        pushes[kind, found[kind], i], lengths[kind, found[kind], i] = part, since[kind]
                    found[kind], since[kind] = found[kind] + 1, 0
            if min(found) >= count:
                break
        assert min(found) >= count
    draws = {}
    for kind, largest in enumerate((size, turn)):
        assert_equally_likely(np.bincount(lengths[kind].ravel())[3:], "push intervals of 3 to 6 steps")
        assert set(lengths[kind, 0]) <= {3, 4, 5, 6}
        draws |= {f"push {kind} {i}": share(pushes[kind, ..., i], -largest, largest) for i in range(3)}
    assert_uniform(draws)
    times = {f"push interval {kind}": share(lengths[kind], 2.5, 6.5) for kind in range(2)}
    assert_independent({**draws, **times}, ((0, 0), *NEIGHBOURS, (2, 0)))


# --- observation noise ---

NOISE = {"projected gravity": 0.02, "angular velocity": 0.1 * 0.25, "joint position": 0.01, "joint velocity": 0.3 * 0.2}
"""Amplitudes in the observation's units: the readings' amplitudes times their scales."""
NOISY_COLUMNS = [
    (f"{name} {i}", amplitude)
    for (name, amplitude), width in zip(NOISE.items(), (3, 3, 8, 8), strict=True)
    for i in range(width)
]
UPRIGHT = 0.975
"""Projected gravity beyond which its noise would meet the observation's bound of 1."""


@pytest.fixture(scope="module")
def noise():
    """Noise (episodes, steps, envs, columns) as shares of its range; tilted envs; draws of starts (episodes, envs)."""
    common = {
        "fast_control": True,
        "never_ends": True,
        "start_tilt": 0.6,
        "forward_velocity": FORWARD,
        "shares": (0.0, 0.0),
    }
    noisy, quiet = (make_vec(200, settings(noise=amount, **common)) for amount in (1.0, 0.0))
    differences, readings, starts = [], [], []
    for episode in range(4):
        seed = 11 if episode == 0 else None
        observations = [env.reset(seed=seed) for env in (noisy, quiet)]
        starts.append(joint_draws(observations[1][1]) | {"gait phase": phases(observations[1][0])})
        for step in range(5):
            if step:
                observations = [env.step(zeros(env)) for env in (noisy, quiet)]
            one, other = (results[0].astype(np.float64) for results in observations)
            differences.append(one - other)
            readings.append(other)
    differences, readings = (np.array(x).reshape(4, 5, 200, -1)[..., :34] for x in (differences, readings))
    tilted = (abs(readings[..., 2]) < UPRIGHT).all(axis=(0, 1))
    amplitude = np.array([amplitude for _, amplitude in NOISY_COLUMNS])
    np.testing.assert_array_equal(differences[..., len(amplitude) :], 0.0)
    start = {name: np.array([start[name] for start in starts]) for name in starts[0]}
    return share(differences[..., : len(amplitude)], -amplitude, amplitude), tilted, start


def test_noise_of_every_column_is_uniform_within_its_amplitude(noise):
    values, tilted, _ = noise
    assert tilted.sum() > 20
    draws = {name: values[..., i] for i, (name, _) in enumerate(NOISY_COLUMNS)}
    draws["projected gravity 2"] = draws["projected gravity 2"][..., tilted]
    assert_uniform(draws)


def test_noise_is_unrelated_to_other_columns_steps_envs_and_episodes(noise):
    values, _, start = noise
    columns = [i for i, (name, _) in enumerate(NOISY_COLUMNS) if name != "projected gravity 2"]
    by_step = {NOISY_COLUMNS[i][0]: values[..., i].reshape(-1, 200) for i in columns}
    assert_independent(by_step, ((0, 0), *NEIGHBOURS))
    by_episode = {name: column.reshape(4, -1) for name, column in by_step.items()}
    assert_independent(by_episode, ((1, 0),))
    first = {name: column.reshape(4, 5, 200)[:, 0].ravel() for name, column in by_step.items()}
    assert_unrelated(first, {name: column.ravel() for name, column in start.items()})
