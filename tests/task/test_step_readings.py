"""One control step, recomputed from MuJoCo's own data: joint targets, every reward term, the fall, the observation.

The package is used only through what an env returns. MuJoCo steps a copy of the robot on its own, and the formulas of
the env's docstring give the rest of its state.
"""

import math
from dataclasses import dataclass, field

import gymnasium
import mujoco
import numpy as np
import pytest
from robot_alone import LEGS, RobotAlone, rotation
from settings import CLOCK_FREQUENCY, PHYSICS_TIMESTEP, REWARD_PARAMETERS, REWARD_WEIGHTS, settings

from quadruped_env.envs import ENV_ID

LEG_PHASES = (0.0, math.pi, math.pi, 0.0)
"""A trot: the diagonal legs swing together."""
STANCE = np.array([0.6, -0.72] * 4)
LOW, HIGH = np.array([-1.5, -2.0] * 4), np.array([1.5, 0.0] * 4)
RADIUS = 0.02
DT = 4 * PHYSICS_TIMESTEP
CLOCK_RATE = math.tau * CLOCK_FREQUENCY
MOVING = 0.02
"""Threshold of moving, m/s and rad/s; a command below both stands still."""

WEIGHTS = REWARD_WEIGHTS | {"steady_error": -4.0}
"""Every term counts."""
LEG_LENGTH, HALF_TRACK = 0.03 * math.cos(0.6) + 0.14 * math.cos(0.12) + RADIUS, 0.1


# --- the task by its docstring ---


@dataclass
class Memory:
    """State of the task between two steps."""

    command: np.ndarray
    """Command in force during the latest step, m/s and rad/s."""
    phase: float | None
    """Phase of the gait clock in that step, rad; None until the clock was observed."""
    last_action: np.ndarray = field(default_factory=lambda: np.zeros(8))
    average: list[float] = field(default_factory=lambda: [0.0, 0.0])
    """Forward velocity and yaw rate over about a gait cycle."""
    bias: list[float] = field(default_factory=lambda: [0.0, 0.0])
    """Their errors over about two seconds."""
    airborne: np.ndarray = field(default_factory=lambda: np.zeros(4, dtype=bool))
    """Feet that were in the air in the physics step before."""


def moves(command):
    return max(abs(command)) > MOVING


def observed_phase(observation):
    """Phase of the clock in an observation; None at a standing command, which shows none."""
    sine, cosine = map(float, observation[32:34])
    return None if sine == cosine == 0.0 else math.atan2(sine, cosine)


def joint_target(mode, action, memory):
    """Joint targets (8,) of an action."""
    clipped = np.clip(action.astype(np.float64), -1.0, 1.0)
    if mode == "position":
        target = STANCE + 0.6 * clipped
    elif not any(memory.command):
        target = STANCE + 0.4 * clipped
    else:
        target = gait(memory.command, memory.phase) + 0.4 * clipped
    return np.clip(target, LOW, HIGH)


def gait(command, phase):
    """The trot in closed form: joint positions (8,) at a phase."""
    forward, yaw_rate = command
    turn = math.copysign(math.sqrt(0.8 * min(0.8, abs(yaw_rate))), yaw_rate)
    size = min(1.0, max(abs(forward) / 0.05, abs(yaw_rate) / 0.15))
    joints = []
    for leg, start in enumerate(LEG_PHASES):
        velocity = forward + 4.0 * HALF_TRACK * turn * (1.0 if leg % 2 else -1.0)
        sine, cosine = math.sin(phase + start), math.cos(phase + start)
        stride = velocity / (2.8 * CLOCK_FREQUENCY * LEG_LENGTH)
        joints += [0.2 / math.tau + stride * cosine + 0.2 / 4.0 * sine, -0.2 / math.pi - 0.2 / 2.0 * sine]
    return STANCE + size * np.array(joints)


def share(velocity, command, smallest):
    """Progress towards a command, in [-1, 1]."""
    size = max(abs(command), smallest)
    reached, whole = velocity * np.sign(command) / size, abs(command) / size
    return max(-1.0, reached - 2.0 * max(0.0, reached - whole))


def kernel(error, std):
    return math.exp(-((error / REWARD_PARAMETERS[std]) ** 2))


def reward_terms(robot, action, memory, fallen):
    """Unweighted terms after a step; `memory` has the action and the feet before it, phase and average of after it.

    It then has the feet of after it.
    """
    forward, yaw_rate = memory.command
    moving, on_ground = moves(memory.command), robot.foot_force() > REWARD_PARAMETERS["contact_threshold"]
    clock = contact = 0.0
    for leg in range(4):
        missing = min(1.0, abs(1.0 - (robot.foot(leg)[0][2] - RADIUS) / REWARD_PARAMETERS["foot_lift"]))
        if moving:
            sine = math.sin(memory.phase + LEG_PHASES[leg])
            clock += sine * (1.0 - 2.0 * missing**2) / 4.0
            contact += sine * (-1.0 if on_ground[leg] else 1.0) / 4.0
    power = slip = 0.0
    landing = np.zeros(4)
    for torque, speeds, force, feet in robot.substeps:
        power += sum(max(0.0, t * w) + 0.5 * t**2 for t, w in zip(torque, speeds, strict=True)) / 4.0
        for leg, (velocity, spin) in enumerate(feet):
            touching = force[leg] > REWARD_PARAMETERS["contact_threshold"]
            sole = velocity + np.cross(spin, [0.0, 0.0, -RADIUS])
            slip += touching * (sole[0] ** 2 + sole[1] ** 2) / 4.0
            if touching and memory.airborne[leg]:
                landing[leg] = max(landing[leg], -velocity[2])
            memory.airborne[leg] = not touching
    return {
        "track_forward_velocity": kernel(memory.average[0] - forward, "forward_velocity_std"),
        "track_yaw_rate": kernel(memory.average[1] - yaw_rate, "yaw_rate_std"),
        "forward_progress": share(memory.average[0], forward, 0.1),
        "turn_progress": share(memory.average[1], yaw_rate, 0.2),
        "steady_error": abs(memory.bias[0]) / 0.1 + abs(memory.bias[1]) / 0.2,
        "gait_clock": clock,
        "contact_clock": contact,
        "upright": robot.up[0] ** 2 + robot.up[1] ** 2,
        "base_motion": robot.velocity[1] ** 2
        + robot.velocity[2] ** 2
        + REWARD_PARAMETERS["base_arm"] ** 2 * (robot.rates[0] ** 2 + robot.rates[1] ** 2),
        "action_rate": sum((np.clip(action, -1.0, 1.0) - memory.last_action) ** 2),
        "electrical_power": power,
        "foot_slip": slip,
        "landing": sum(landing**2) / DT,
        "stand_still": 0.0 if moving else sum((robot.joints - STANCE) ** 2),
        "fall": float(fallen),
    }


def observation_of(data, action, command, phase):
    """Name -> columns, from MuJoCo's data after a step."""
    moving = moves(command)
    return {
        "projected_gravity": -rotation(data.qpos[3:7])[2],
        "angular_velocity": np.clip(0.25 * data.qvel[3:6], -4.0, 4.0),
        "joint_position": data.qpos[7:] - STANCE,
        "joint_velocity": np.clip(0.2 * data.qvel[6:], -3.0, 3.0),
        "last_action": np.clip(action, -1.0, 1.0),
        "command": 4.0 * command,
        "gait_clock": [math.sin(phase), math.cos(phase)] if moving else [0.0, 0.0],
    }


# --- episodes ---


def still(rng):
    return np.zeros(8, dtype=np.float32)


def noisy(rng):
    return rng.normal(0.0, 0.3, 8).astype(np.float32)


def wild(rng):
    return rng.uniform(-1.5, 1.5, 8).astype(np.float32)


def squatting(rng):
    return np.array([-1.0, -1.0] * 2 + [1.0, 1.0] * 2, dtype=np.float32)


@dataclass
class Episode:
    mode: str
    action: object
    command: tuple[float, float] | None = None
    config: dict = field(default_factory=dict)
    steps: int = 40
    seed: int = 0


# Either zero or well over the threshold of moving: under it the gait continues with a clock that is not observed.
CHANGING = {"sudden": True, "resample": (0.05, 0.2), "shares": (0.3, 0.2), "forward_velocity": (0.1, 0.6)}
HARD_PUSHES = {"push_velocity": 4.0, "push_interval": (0.1, 0.2)}
EPISODES = {
    "gait forward": Episode("residual", still, (0.4, 0.0)),
    "gait forward, turning left": Episode("residual", noisy, (0.2, 0.6)),
    "gait backward, turning right": Episode("residual", noisy, (-0.2, -0.4)),
    "gait, slow": Episode("residual", still, (0.05, -0.1)),
    "gait, standing": Episode("residual", noisy, (0.0, 0.0)),
    "gait, changing commands": Episode("residual", noisy, None, CHANGING, 60, 3),
    "gait, changing commands and pushes": Episode(
        "residual", still, None, {**CHANGING, "push_velocity": 0.6, "push_interval": (0.1, 0.3)}, 60, 4
    ),
    "gait, slippery and loaded": Episode("residual", wild, (0.3, 0.3), {"friction": (0.1, 0.2), "payload": (0.5, 1.0)}),
    "joints, command just under the threshold": Episode("position", noisy, (0.018, -0.018)),
    "joints, command just over the threshold": Episode("position", noisy, (0.0, -0.022)),
    "joints squatting": Episode("position", squatting, (0.0, 0.0)),
    "joints standing": Episode("position", still, (0.0, 0.0)),
    "joints at random": Episode("position", wild, (0.3, -0.5), {"max_tilt": 3.0}),
    "joints at random, changing commands": Episode("position", noisy, None, CHANGING, 60, 5),
    "joints pushed until they lean too far": Episode(
        "position", wild, (0.2, 0.0), {**HARD_PUSHES, "max_tilt": 0.5}, 100
    ),
    **{
        f"joints pushed until they lie, seed {seed}": Episode(
            "position", still, (0.0, 0.3), {**HARD_PUSHES, "max_tilt": math.pi}, 100, seed
        )
        for seed in (1, 2)
    },
}


@dataclass
class Step:
    """Expected results of a step, and those that the env gave."""

    terms: dict
    reward: float
    info: dict
    fallen: bool
    terminated: bool
    targets: tuple
    readings: dict
    observed: dict
    observation: np.ndarray
    command: np.ndarray
    phase: float | None
    on_ground: np.ndarray
    trunk_force: list[float]


def play(episode):
    config = settings(**episode.config) | {"reward": {"weights": {"steady_error": WEIGHTS["steady_error"]}}}
    env = gymnasium.make(ENV_ID, action_mode=episode.mode, config=config)
    options = None if episode.command is None else {"command": episode.command}
    observation, info = env.reset(seed=episode.seed, options=options)
    rng = np.random.default_rng(episode.seed)
    data, robot = env.unwrapped.data, RobotAlone(env.unwrapped.model)
    before = mujoco.MjData(robot.model)
    memory = Memory(info["command"], observed_phase(observation))
    filtered = 1.0 - math.exp(-DT / REWARD_PARAMETERS["velocity_time_constant"])
    steps = []
    for _ in range(episode.steps):
        action = episode.action(rng)
        mujoco.mj_copyData(before, robot.model, data)
        observation, reward, terminated, _, info = env.step(action)
        # A clock that was never observed has its first phase from this observation.
        phase = observed_phase(observation) if memory.phase is None else memory.phase + CLOCK_RATE * DT
        memory.phase = phase
        target = joint_target(episode.mode, action, memory)
        robot.step(before, target)
        for i, value in enumerate((robot.velocity[0], robot.rates[2])):
            memory.average[i] += filtered * (value - memory.average[i])
            memory.bias[i] += (1.0 - math.exp(-DT / 2.0)) * (value - memory.command[i] - memory.bias[i])
        fallen = math.acos(robot.up[2]) > (episode.config.get("max_tilt") or 1.0) or max(robot.trunk_force()) > 1.0
        steps.append(
            Step(
                terms=reward_terms(robot, action, memory, fallen),
                reward=reward,
                info=info,
                fallen=fallen,
                terminated=terminated,
                targets=(target, data.ctrl.copy()),
                readings={
                    "base_position": data.qpos[:3].copy(),
                    "base_linear_velocity": robot.velocity,
                    "base_angular_velocity": data.qvel[3:6].copy(),
                    "joint_position": robot.joints,
                    "joint_velocity": robot.speeds,
                    "joint_torque": robot.torque,
                    "foot_force": robot.foot_force(),
                    "foot_contact": robot.foot_force() > 1.0,
                },
                observed=observation_of(data, action, info["command"], phase or 0.0),
                observation=observation,
                command=memory.command,
                phase=memory.phase,
                on_ground=robot.foot_force() > 1.0,
                trunk_force=robot.trunk_force(),
            )
        )
        memory.last_action, memory.command = np.clip(action, -1.0, 1.0), info["command"]
        if terminated:
            break
    return steps


@pytest.fixture(scope="module")
def played():
    """Name -> steps of every episode."""
    return {name: play(episode) for name, episode in EPISODES.items()}


def all_steps(played):
    return [(f"{name}, step {i}", step) for name, steps in played.items() for i, step in enumerate(steps, 1)]


def test_episodes_cover_falls_commands_and_contacts(played):
    steps = [step for _, step in all_steps(played)]
    lying = [step for step in steps if step.terminated and max(step.trunk_force) > 1.0]
    leaning = [step for step in steps if step.terminated and max(step.trunk_force) <= 1.0]
    assert lying
    assert leaning
    changes = [
        (step.command != step.info["command"]).any() and moves(step.command) != moves(step.info["command"])
        for step in steps
    ]
    assert sum(changes) >= 3, "commands change between standing and moving"
    contacts = np.array([step.on_ground for step in steps])
    assert (contacts.mean(axis=0) > 0.2).all()
    assert (contacts.mean(axis=0) < 0.95).all()


def test_reward_terms_are_their_formulas_on_mujocos_readings(played):
    steps = all_steps(played)
    for term, weight in WEIGHTS.items():
        values = np.array([step.terms[term] for _, step in steps])
        found = [step.info[f"reward_{term}"] for _, step in steps]
        np.testing.assert_allclose(found, weight * DT * values, rtol=1e-5, atol=1e-7, err_msg=term)
        assert np.ptp(values) > 1e-4, f"{term} must vary over the episodes"


def test_reward_is_the_sum_of_exactly_these_terms(played):
    for name, step in all_steps(played):
        terms = {key.removeprefix("reward_"): value for key, value in step.info.items() if key.startswith("reward_")}
        assert terms.keys() == REWARD_WEIGHTS.keys(), name
        assert abs(step.reward - sum(terms.values())) < 1e-12, name


def test_termination_is_a_tilt_or_a_trunk_on_the_ground(played):
    for name, step in all_steps(played):
        assert step.terminated == step.fallen, name


def test_joint_targets_follow_action_command_and_clock(played):
    for name, step in all_steps(played):
        expected, found = step.targets
        np.testing.assert_allclose(found, expected, atol=1e-6, err_msg=name)


def test_info_readings_are_mujocos(played):
    for name, step in all_steps(played):
        for reading, expected in step.readings.items():
            # The motors turn a difference of targets in the seventh digit into some of the torques and forces.
            np.testing.assert_allclose(step.info[reading], expected, rtol=1e-4, atol=1e-4, err_msg=f"{name}: {reading}")


def test_observation_is_mujocos_readings_scaled(played):
    for name, step in all_steps(played):
        np.testing.assert_allclose(
            step.observation[:34], np.hstack(list(step.observed.values())), atol=2e-6, err_msg=name
        )


def test_gait_clock_pays_for_lifting_the_feet_that_swing(played):
    """The scripted gait walks by the clock, so a clock with another sign or another foot order pays it less."""
    steps = played["gait forward"][10:]
    assert np.mean([step.info["reward_gait_clock"] for step in steps]) > 0.05 * REWARD_WEIGHTS["gait_clock"] * DT
    for leg in range(4):
        sine = np.array([math.sin(step.phase + LEG_PHASES[leg]) for step in steps])
        contact = np.array([step.on_ground[leg] for step in steps])
        assert contact[sine > 0.5].mean() < contact[sine < -0.5].mean(), LEGS[leg]
