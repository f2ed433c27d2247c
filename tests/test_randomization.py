"""What differs from episode to episode."""

import math

import numpy as np
import pytest
from tasks import (
    NEVER_FALLS,
    ONE_COMMAND,
    STILL_START,
    make_env,
    make_task,
)

from quadruped_env.robot import FOOT_RADIUS, STANCE
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model
from quadruped_env.task import RandomizationConfig, Task, TaskConfig


def test_starts_are_drawn_in_their_ranges():
    config = RandomizationConfig(
        start_joint_position=0.2, start_joint_velocity=0.7, start_base_velocity=0.3, start_tilt=0.15
    )
    simulation = BatchSimulation(build_model(), 5000, 1)
    starts = []
    simulation.reset = lambda env_ids, qpos, qvel: starts.append((qpos, qvel))
    Task(simulation, TaskConfig(randomization=config)).reset(np.arange(5000), range(5000))
    ((qpos, qvel),) = starts
    for values, bound in (
        (qpos[:, 7:] - STANCE, 0.2),
        (qvel[:, 6:], 0.7),
        (qvel[:, :6], 0.3),
    ):
        assert (abs(values) <= bound + 1e-12).all()
        assert (abs(values).max(axis=0) > 0.99 * bound).all()
        np.testing.assert_allclose(values.mean(axis=0), 0.0, atol=0.05 * bound)
    np.testing.assert_allclose(np.linalg.norm(qpos[:, 3:7], axis=1), 1.0)
    up = 1 - 2 * (qpos[:, 4] ** 2 + qpos[:, 5] ** 2)
    tilt = np.arccos(np.clip(up, -1, 1))
    assert 0.15 < tilt.max() <= math.sqrt(2) * 0.15 + 1e-9
    yaw = 2 * np.arctan2(qpos[:, 6], qpos[:, 3])
    assert np.ptp(yaw) > 6.0, "every heading"
    # No draw decides two things.
    correlation = np.corrcoef(np.concatenate([qpos[:, 7:], qvel], axis=1).T) - np.eye(22)
    assert abs(correlation).max() < 0.08


def test_without_randomization_every_start_is_the_stance_on_the_ground():
    task = make_task(3, randomization=STILL_START)
    state = task.simulation.readings
    np.testing.assert_allclose(state.joint_position, np.tile(STANCE, (3, 1)), atol=1e-12)
    np.testing.assert_allclose(state.linear_velocity_b, 0.0, atol=1e-12)
    np.testing.assert_allclose(state.up_b, [[0, 0, 1]] * 3, atol=1e-12)
    np.testing.assert_allclose(state.foot_position[..., 2], FOOT_RADIUS, atol=1e-6)


MODELS = RandomizationConfig(friction=(0.3, 0.9), payload=(-0.2, 1.0))


@pytest.mark.parametrize("rows", [1, 4], ids=["single", "batch"])
def test_friction_and_payload_are_in_the_model_of_the_row(rows):
    plain = build_model()
    base = plain.body("base_link").id
    model = build_model()
    simulation = SingleSimulation(model) if rows == 1 else BatchSimulation(model, rows, 1)
    task = Task(simulation, TaskConfig(randomization=MODELS))
    everything = np.arange(rows)
    frictions, payloads = [], []
    for episode in range(12):
        task.reset(everything, [100 * episode + row for row in range(rows)])
        friction, mass = simulation.model_field("geom_friction"), simulation.model_field("body_mass")
        inertia = simulation.model_field("body_inertia")
        for row in everything:
            assert len(np.unique(friction[row, :, 0])) == 1, "both sides of every contact"
            np.testing.assert_array_equal(friction[row, :, 1:], plain.geom_friction[:, 1:])
            frictions.append(friction[row, 0, 0])
            payloads.append(mass[row, base] - plain.body_mass[base])
            others = np.delete(np.arange(plain.nbody), base)
            np.testing.assert_array_equal(mass[row, others], plain.body_mass[others])
            np.testing.assert_array_equal(inertia[row, others], plain.body_inertia[others])
            share = mass[row, base] / plain.body_mass[base]
            np.testing.assert_allclose(inertia[row, base], plain.body_inertia[base] * share, rtol=1e-12)
        if rows == 1:
            # What MuJoCo derives from the mass follows.
            np.testing.assert_allclose(model.body_subtreemass[base], model.body_mass[base:].sum(), rtol=1e-12)
    assert 0.3 <= min(frictions) < max(frictions) <= 0.9
    assert -0.2 <= min(payloads) < max(payloads) <= 1.0
    assert len(set(frictions)) == len(set(payloads)) == 12 * rows


def test_a_reset_of_some_rows_leaves_the_models_of_the_others():
    task = make_task(4, randomization=MODELS)
    friction, mass = (task.simulation.model_field(name) for name in ("geom_friction", "body_mass"))
    before = friction.copy(), mass.copy()
    task.reset(np.array([1, 3]))
    for values, old in zip((friction, mass), before, strict=True):
        np.testing.assert_array_equal(values[[0, 2]], old[[0, 2]])
        assert (values[[1, 3]] != old[[1, 3]]).any(axis=tuple(range(1, values.ndim))).all()


def test_a_payload_presses_on_the_ground():
    heavy = make_task(2, randomization=STILL_START.replace(payload=(1.0, 1.0)), termination=NEVER_FALLS)
    plain = make_task(2, randomization=STILL_START, termination=NEVER_FALLS)
    for _ in range(60):
        heavy.step(np.zeros((2, 8))), plain.step(np.zeros((2, 8)))
    weight = [task.simulation.readings.foot_force.sum(axis=1) for task in (heavy, plain)]
    np.testing.assert_allclose(weight[0] - weight[1], 9.81, rtol=0.05)


def test_pushes_add_a_horizontal_velocity_at_their_intervals():
    interval, size = 0.2, 0.5
    pushed = make_env(
        command=ONE_COMMAND,
        randomization=STILL_START.replace(push_velocity=size, push_interval=(interval, interval)),
        termination=NEVER_FALLS,
    )
    still = make_env(command=ONE_COMMAND, randomization=STILL_START)
    every = round(interval / pushed.dt)
    velocities = []
    for step in range(1, 10 * every + 1):
        if step % every == 0:
            still.set_state(pushed.get_state())
        pushed.step(np.zeros(8))
        if step % every == 0:
            still.step(np.zeros(8))
            velocities.append(pushed.data.qvel[:3] - still.data.qvel[:3])
            np.testing.assert_array_equal(pushed.data.qvel[3:], still.data.qvel[3:])
            np.testing.assert_array_equal(pushed.data.qpos, still.data.qpos)
        elif step < every:
            still.step(np.zeros(8))
            np.testing.assert_array_equal(pushed.data.qvel, still.data.qvel)
    velocities = np.array(velocities)
    assert len(np.unique(velocities[:, 0])) == len(np.unique(velocities[:, 1])) == 10
    assert (abs(velocities[:, :2]) <= size).all()
    assert abs(velocities[:, :2]).max() > 0.5 * size
    np.testing.assert_array_equal(velocities[:, 2], 0.0)
