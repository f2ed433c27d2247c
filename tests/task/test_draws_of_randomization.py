"""Every draw of the model's, the sensors' and the forces' randomizations: its law, and its independence of the others.

Read from outside, as in test_draws.py: from what an env returns, and from MuJoCo's own model and state.
"""

import math

import gymnasium
import numpy as np
import pytest
from laws import NEIGHBOURS, assert_equally_likely, assert_independent, assert_uniform, share
from scipy.spatial.transform import Rotation
from settings import settings

from quadruped_env.envs import ENV_ID
from quadruped_env.task import BUILT_IN

BASE, LINKS, JOINTS = 1, slice(1, 10), slice(6, 14)
STANCE = np.array([0.6, -0.72] * 4)
FACTOR = [0.6, 1.5]
FACTORS = (
    "link_mass",
    "link_inertia",
    "motor_strength",
    "supply_voltage",
    "position_gain",
    "velocity_gain",
    "joint_damping",
    "rotor_inertia",
)
RANGES = {
    **dict.fromkeys(FACTORS, FACTOR),
    "friction": [0.2, 1.4],
    "contact_time_constant": [0.01, 0.04],
    "contact_damping_ratio": [0.3, 1.5],
    "base_com": 0.03,
    "joint_friction": [0.1, 0.4],
    "encoder_offset": 0.05,
    "imu_mounting": 0.2,
    "action_latency": [0.01, 0.06],
    "observation_latency": [0.0, 0.02],
}
SERVOS = {"target_step": [0.01, 0.03], "backlash": [0.0, 0.02], "dead_band": [0.0, 0.01]}
RANGES |= SERVOS
ENVS, EPISODES = 16, 48


def columns(name, values):
    """Columns (..., K) as separate draws."""
    return {f"{name} {i}": values[..., i] for i in range(values.shape[-1])}


def model_values(model, plain):
    """Drawn values of one env's model, by name: (K,) each."""
    mass = model.body_mass[LINKS] / plain.body_mass[LINKS]
    voltage = model.actuator_gainprm[:1, 7] / plain.actuator_gainprm[:1, 7]
    return {
        "friction": model.geom_friction[:1, 0],
        "contact_time_constant": model.geom_solref[:1, 0],
        "contact_damping_ratio": model.geom_solref[:1, 1],
        "link_mass": mass,
        "link_inertia": model.body_inertia[LINKS, 0] / plain.body_inertia[LINKS, 0] / mass,
        "base_com": model.body_ipos[BASE] - plain.body_ipos[BASE],
        "motor_strength": model.actuator_forcerange[:, 1] / plain.actuator_forcerange[:, 1] / voltage,
        "supply_voltage": voltage,
        "position_gain": model.actuator_gainprm[:, 4] / plain.actuator_gainprm[:, 4],
        "velocity_gain": model.actuator_gainprm[:, 6] / plain.actuator_gainprm[:, 6],
        "joint_friction": model.dof_frictionloss[JOINTS],
        "joint_damping": model.dof_damping[JOINTS] / plain.dof_damping[JOINTS],
        "rotor_inertia": model.dof_armature[JOINTS] / plain.dof_armature[JOINTS],
        "encoder_offset": plain.actuator_ctrlrange[:, 0] - model.actuator_ctrlrange[:, 0],
        "action_latency": model.actuator_delay[:1],
    }


def as_shares(name, values):
    """Values as shares of their range, by their law."""
    setting = RANGES[name]
    low, high = setting if isinstance(setting, list) else (-setting, setting)
    if next(entry for entry in BUILT_IN.randomizations if entry.name == name).law == "log_uniform":
        return share(np.log(values), math.log(low), math.log(high))
    return share(values, low, high)


def mounting(observation, data):
    """Roll, pitch and yaw of the IMU from gravity and rates, of which the true ones are known."""
    base = Rotation.from_quat(data.qpos[3:7], scalar_first=True)
    true = np.array([base.inv().apply([0.0, 0.0, -1.0]), data.qvel[3:6]])
    seen = np.array([observation[:3], observation[3:6] / 0.25], dtype=np.float64)
    length = np.linalg.norm(true, axis=1, keepdims=True)
    turn, _ = Rotation.align_vectors(true / length, seen / length, weights=[1e4, 1.0])
    return turn.as_euler("xyz")


@pytest.fixture(scope="module")
def starts():
    """Everything that is drawn at a reset: name -> share of its range (episodes, envs)."""
    config = settings(fast_control=True, never_ends=True, randomization=RANGES)
    envs = gymnasium.make_vec(ENV_ID, num_envs=ENVS, config=config, vectorization_mode="sync")
    singles = [env.unwrapped for env in envs.envs]
    plain = gymnasium.make(ENV_ID).unwrapped.model
    episodes = []
    for episode in range(EPISODES):
        first, _ = envs.reset(seed=7 if episode == 0 else None)
        values = [model_values(env.model, plain) for env in singles]
        record = {name: np.array([one[name] for one in values]) for name in values[0]}
        record["imu_mounting"] = np.array(
            [mounting(*pair) for pair in zip(first, (e.data for e in singles), strict=True)]
        )
        states = [env.get_state()["servos"] for env in singles]
        record |= {name: np.array([state[name] for state in states]) for name in SERVOS}
        record["target_step"] = record["target_step"][:, :1]  # one for all joints
        episodes.append({name: as_shares(name, entry) for name, entry in record.items()})
    return {
        name: values
        for quantity in episodes[0]
        for name, values in columns(quantity, np.array([episode[quantity] for episode in episodes])).items()
    }


def test_starts_every_quantity_follows_its_law_over_its_whole_range(starts):
    assert len(starts) == 85 + 17
    assert_uniform(starts)


def test_starts_no_two_quantities_of_an_episode_are_related(starts):
    assert_independent(starts)


def test_starts_neighbouring_envs_and_episodes_are_unrelated(starts):
    some = {name: values for name, values in starts.items() if name.endswith((" 0", " 1"))}
    assert_independent(some, NEIGHBOURS)


def test_payloads_and_their_positions_are_uniform_and_independent():
    low, high, size = 0.2, 1.0, 0.06
    config = settings(randomization={"payload": [low, high], "payload_position": size})
    envs = gymnasium.make_vec(ENV_ID, num_envs=ENVS, config=config, vectorization_mode="sync")
    record = []
    for episode in range(EPISODES):
        envs.reset(seed=11 if episode == 0 else None)
        models = [env.unwrapped.model for env in envs.envs]
        mass = np.array([model.body_mass[BASE] for model in models]) - 2.2
        centre = np.array([model.body_ipos[BASE] for model in models])
        position = centre * ((2.2 + mass) / mass)[:, None]
        record.append(np.column_stack([share(mass, low, high), share(position, -size, size)]))
    draws = columns("payload", np.array(record))
    assert_uniform(draws)
    assert_independent(draws, ((0, 0), *NEIGHBOURS))


def test_latency_of_readings_is_uniform_and_independent_of_that_of_actions():
    """A reading between the first two is at the share of a control step that the latency is."""
    step = 0.005
    config = settings(
        fast_control=True,
        randomization={"observation_latency": [0.0, step], "action_latency": [0.0, step], "encoder_offset": 0.0},
    )
    envs = gymnasium.make_vec(ENV_ID, num_envs=ENVS, config=config, vectorization_mode="sync")
    record = []
    for episode in range(EPISODES):
        _, info = envs.reset(seed=2 if episode == 0 else None)
        before = info["joint_position"]
        observation, *_, info = envs.step(np.zeros((ENVS, 8), dtype=np.float32))
        late = observation[:, 6:14] + STANCE
        after = info["joint_position"]
        # The joint that moved most tells the latency best.
        best = abs(after - before).argmax(axis=1)[:, None]
        at = [np.take_along_axis(values, best, axis=1)[:, 0] for values in (before, late, after)]
        delay = [env.unwrapped.model.actuator_delay[0] / step for env in envs.envs]
        record.append(np.column_stack([(at[2] - at[1]) / (at[2] - at[0]), delay]))
    draws = columns("latency", np.array(record))
    assert_uniform({name: np.clip(values, 0.0, 1.0) for name, values in draws.items()})
    assert_independent(draws, ((0, 0), *NEIGHBOURS))


def forces(env, steps):
    """Horizontal force on the base before each of some steps (T, 2), N."""
    trace = []
    for _ in range(steps):
        trace.append(env.unwrapped.data.xfrc_applied[BASE, :2].copy())
        env.step(np.zeros(8, dtype=np.float32))
    return np.array(trace)


def test_forces_are_uniform_in_size_direction_duration_and_interval_and_independent():
    step, size, envs, count = 0.005, (2.0, 5.0), 4, 40
    config = settings(
        fast_control=True,
        never_ends=True,
        randomization={
            "push_force": list(size),
            "push_force_interval": [7.5 * step, 11.5 * step],
            "push_force_duration": [2.5 * step, 6.5 * step],
        },
    )
    drawn = np.zeros((count, envs, 4))
    for i in range(envs):
        env = gymnasium.make(ENV_ID, config=config, max_episode_steps=10**6)
        env.reset(seed=i)
        trace = forces(env, 11 * count + 12)
        lengths = np.hypot(*trace.T)
        np.testing.assert_array_equal(env.unwrapped.data.xfrc_applied[BASE, 2:], 0.0)
        begins = np.flatnonzero((lengths > 0.0) & (np.concatenate([[0.0], lengths[:-1]]) == 0.0))
        ends = np.flatnonzero((lengths == 0.0) & (np.concatenate([[0.0], lengths[:-1]]) > 0.0))
        # What is applied after a step acts from the next one on.
        intervals = np.diff(begins, prepend=0)
        for k in range(count):
            direction = np.arctan2(trace[begins[k], 1], trace[begins[k], 0])
            drawn[k, i] = lengths[begins[k]], direction, ends[k] - begins[k], intervals[k]
    assert_equally_likely(np.bincount(drawn[..., 2].astype(int).ravel())[3:], "durations of 3 to 6 steps")
    assert_equally_likely(np.bincount(drawn[..., 3].astype(int).ravel())[8:], "intervals of 8 to 11 steps")
    draws = {"size": share(drawn[..., 0], *size), "direction": share(drawn[..., 1], -math.pi, math.pi)}
    assert_uniform(draws)
    times = {"duration": share(drawn[..., 2], 2.5, 6.5), "interval": share(drawn[..., 3], 7.5, 11.5)}
    assert_independent({**draws, **times}, ((0, 0), *NEIGHBOURS, (2, 0)))


def test_speeds_of_pushes_are_uniform_in_size_and_direction_and_independent():
    envs, count, size = 128, 12, (0.2, 0.8)
    ranges = {"push_speed": list(size), "push_interval": [0.02, 0.02]}
    env, quiet = (
        gymnasium.make_vec(ENV_ID, num_envs=envs, config=settings(never_ends=True, start_tilt=0.0, randomization=own))
        for own in (ranges, {})
    )
    drawn = []
    for episode in range(count):
        infos = []
        for e in (env, quiet):
            e.reset(seed=1 if episode == 0 else None)
            e.step(np.zeros((envs, 8), dtype=np.float32))
            infos.append(e.task.simulation.batch.bind("qvel")[:, :2].copy())
        push = infos[0] - infos[1]
        drawn.append([share(np.hypot(*push.T), *size), share(np.arctan2(push[:, 1], push[:, 0]), -math.pi, math.pi)])
    draws = {name: np.array(drawn)[:, i] for i, name in enumerate(("size", "direction"))}
    assert_uniform(draws)
    assert_independent(draws, ((0, 0), *NEIGHBOURS))
