"""The two simulation drivers: identical bits, independent envs, resets, pushes and divergence."""

import contextlib
import copy
from dataclasses import fields

import mujoco
import numpy as np
import pytest
from built_in import STANCE
from drivers import (
    ALL,
    DRIVERS,
    ROWS,
    SUBSTEPS,
    diverge_by_velocity,
    draw_starts,
    draw_targets,
    physics_of,
    readings_of,
    run,
    snapshot,
    start,
)
from mujoco.batch import SimulationError

from quadruped_env.robot.readings import Readings
from quadruped_env.simulation import BatchSimulation, SingleSimulation


def eventful_run(driver, steps=150):
    """Random controls with resets and pushes of some envs in between."""
    simulation = start(driver)
    rng = np.random.default_rng(1)
    snapshots = [snapshot(simulation)]
    for step in range(steps):
        simulation.step(draw_targets(rng), 1 + step % SUBSTEPS)
        if step % 7 == 3:
            rows = np.flatnonzero(rng.random(ROWS) < 0.4)
            simulation.reset(rows, *draw_starts(rng, len(rows)))
        if step % 11 == 5:
            rows = np.flatnonzero(rng.random(ROWS) < 0.4)
            simulation.push(rows, 0.5 * rng.standard_normal((len(rows), 3)))
        snapshots.append(snapshot(simulation))
    assert not simulation.diverged().any()
    return np.array(snapshots)


def test_both_drivers_give_the_same_bits_at_any_number_of_threads():
    expected = eventful_run("singles")
    assert np.isfinite(expected).all()
    for driver in ("1 thread", "3 threads"):
        np.testing.assert_array_equal(eventful_run(driver), expected, err_msg=driver)


@pytest.mark.parametrize("driver", [SingleSimulation, lambda model: BatchSimulation(model, 1)])
@pytest.mark.parametrize("substeps", [1, SUBSTEPS])
def test_one_control_step_is_as_many_physics_steps_of_mujoco(model, driver, substeps):
    qpos, qvel = draw_starts(np.random.default_rng(0), 1)
    simulation = driver(model)
    simulation.reset(np.array([0]), qpos, qvel)
    data = mujoco.MjData(model)
    data.qpos, data.qvel, data.ctrl = qpos[0], qvel[0], qpos[0, 7:]
    mujoco.mj_forward(model, data)
    np.testing.assert_array_equal(simulation.sensordata[0], data.sensordata)
    rng = np.random.default_rng(1)
    for step in range(50):
        if step % 10 == 5:
            velocity = rng.standard_normal((1, 3))
            simulation.push(np.array([0]), velocity)
            data.qvel[:3] += velocity[0]
            np.testing.assert_array_equal(simulation.sensordata[0], data.sensordata)
        target = draw_targets(rng)[:1]
        simulation.step(target, substeps)
        data.ctrl = target[0]
        mujoco.mj_step(model, data, substeps)
        found_qpos, found_qvel = physics_of(simulation, 0)
        np.testing.assert_array_equal(found_qpos, data.qpos)
        np.testing.assert_array_equal(found_qvel, data.qvel)
        mujoco.mj_step1(model, data)  # positions and velocities at the new state; forces stay the last substep's
        np.testing.assert_array_equal(simulation.sensordata[0], data.sensordata)


def test_env_in_which_a_step_fails_counts_as_diverged_until_its_reset(model, monkeypatch):
    simulation = BatchSimulation(model, ROWS)
    starts = draw_starts(np.random.default_rng(0), ROWS)
    simulation.reset(ALL, *starts)
    step = simulation.batch.step

    def fail(*arguments, **options):
        step(*arguments, **options)
        raise SimulationError(np.array([1]), "insufficient memory")

    with monkeypatch.context() as patched:
        patched.setattr(simulation.batch, "step", fail)
        simulation.step(np.tile(STANCE, (ROWS, 1)), SUBSTEPS)
    np.testing.assert_array_equal(simulation.diverged(), ALL == 1)
    assert (simulation.readings.base_position[:, 2] != starts[0][:, 2]).all()
    simulation.reset(np.array([1]), starts[0][:1], starts[1][:1])
    assert not simulation.diverged().any()


@pytest.mark.parametrize("error", [KeyboardInterrupt, mujoco.FatalError])
def test_the_sensors_go_on_after_a_step_that_was_broken_off(model, monkeypatch, error):
    simulation = SingleSimulation(model)
    simulation.reset(np.array([0]), *draw_starts(np.random.default_rng(0), 1))
    flags = model.opt.disableflags

    def break_off(*_):
        raise error

    with monkeypatch.context() as patched:
        patched.setattr(mujoco, "mj_step2", break_off)
        with contextlib.suppress(KeyboardInterrupt):
            simulation.step(STANCE[None], SUBSTEPS)
    assert simulation.diverged()[0] == (error is mujoco.FatalError)
    assert model.opt.disableflags == flags


def test_readings_are_live_views_with_the_documented_shapes(model):
    widths = {
        "joint_position": (8,),
        "joint_velocity": (8,),
        "joint_torque": (8,),
        "orientation": (4,),
        "angular_velocity_b": (3,),
        "linear_acceleration_b": (3,),
        "foot_force": (4,),
        "trunk_force": (5,),
        "base_position": (3,),
        "up_b": (3,),
        "linear_velocity_b": (3,),
        "foot_position": (4, 3),
        "foot_velocity": (4, 3),
        "foot_angular_velocity": (4, 3),
    }
    assert {field.name for field in fields(Readings)} == set(widths)
    batch, single = BatchSimulation(model, ROWS, 1), SingleSimulation(model)
    for simulation, rows in ((batch, ROWS), (single, 1)):
        state = simulation.readings
        views = {name: getattr(state, name) for name in widths}
        simulation.reset(np.arange(rows), *draw_starts(np.random.default_rng(0), rows))
        for name, width in widths.items():
            assert views[name].shape == (rows, *width), name
        copies = {name: view.copy() for name, view in views.items()}
        simulation.step(np.tile(STANCE, (rows, 1)), 10)
        assert simulation.readings is state
        assert (views["joint_position"] != copies["joint_position"]).any()
        # Together they are all that the model senses.
        assert readings_of(state).shape[1] == model.nsensordata


def test_resetting_an_env_leaves_the_others_unchanged(driver):
    plain, disturbed = start(driver), start(driver)
    run(plain, 10, seed=1)
    run(disturbed, 10, seed=1)
    disturbed.reset(np.array([2]), *draw_starts(np.random.default_rng(9), 1))
    others = np.delete(ALL, 2)
    np.testing.assert_array_equal(snapshot(disturbed)[others], snapshot(plain)[others])
    expected, actual = run(plain, 30, seed=2), run(disturbed, 30, seed=2)
    np.testing.assert_array_equal(actual[:, others], expected[:, others])
    assert (actual[:, 2] != expected[:, 2]).any()


def test_reset_removes_every_effect_of_the_past(driver):
    fresh, used = start(driver, seed=4), start(driver, seed=5)
    run(used, 20, seed=1)
    used.reset(ALL, *draw_starts(np.random.default_rng(4), ROWS))
    np.testing.assert_array_equal(snapshot(used), snapshot(fresh))
    np.testing.assert_array_equal(run(used, 20, seed=2), run(fresh, 20, seed=2))


def test_a_step_of_some_envs_leaves_the_others_as_they_were(model):
    simulation, whole = BatchSimulation(model, ROWS), BatchSimulation(model, ROWS)
    for s in (simulation, whole):
        s.reset(ALL, *draw_starts(np.random.default_rng(0), ROWS))
        s.step(np.tile(STANCE, (ROWS, 1)), SUBSTEPS)
    before, target = readings_of(simulation.readings), draw_targets(np.random.default_rng(1))
    stepped, others = np.array([1, 3]), np.array([0, 2, 4])
    simulation.step(target, SUBSTEPS, stepped)
    whole.step(target, SUBSTEPS)
    np.testing.assert_array_equal(readings_of(simulation.readings)[others], before[others])
    np.testing.assert_array_equal(readings_of(simulation.readings)[stepped], readings_of(whole.readings)[stepped])


def test_what_the_model_switches_off_stays_off(model):
    weightless = copy.copy(model)
    weightless.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_GRAVITY
    simulation = BatchSimulation(weightless, 1)
    qpos, _ = draw_starts(np.random.default_rng(0), 1)
    qpos[:, 2] = 1.0
    simulation.reset(np.array([0]), qpos, np.zeros((1, 14)))
    for _ in range(10):
        simulation.step(qpos[:, 7:], SUBSTEPS)
    np.testing.assert_allclose(simulation.readings.base_position, qpos[:, :3], atol=1e-9)


def test_a_push_adds_world_velocity_to_the_base(driver):
    simulation = start(driver)
    run(simulation, 3, seed=1)
    before = snapshot(simulation)
    qpos, qvel = physics_of(simulation, 1)
    velocity = np.array([[0.3, -0.2, 0.1]])
    simulation.push(np.array([1]), velocity)
    others, readings = np.delete(ALL, 1), before.shape[1] - len(simulation.get_state(1).integration)
    np.testing.assert_array_equal(snapshot(simulation)[others], before[others])
    np.testing.assert_array_equal(snapshot(simulation)[:, :readings], before[:, :readings])
    pushed_qpos, pushed_qvel = physics_of(simulation, 1)
    np.testing.assert_array_equal(pushed_qpos, qpos)
    np.testing.assert_array_equal(pushed_qvel[:3], qvel[:3] + velocity[0])
    np.testing.assert_array_equal(pushed_qvel[3:], qvel[3:])


def diverge_by_nan_velocity(simulation, row):
    simulation.push(np.array([row]), np.full((1, 3), np.nan))


def diverge_by_nan_start(simulation, row):
    qpos, qvel = draw_starts(np.random.default_rng(0), 1)
    qpos[0, 9] = np.nan
    simulation.reset(np.array([row]), qpos, qvel)


@pytest.mark.parametrize("diverge", [diverge_by_velocity, diverge_by_nan_velocity, diverge_by_nan_start])
def test_divergence_is_reported_for_its_env_until_its_reset(driver, diverge):
    plain, disturbed = start(driver), start(driver)
    run(plain, 3, seed=1)
    run(disturbed, 3, seed=1)
    diverge(disturbed, 3)
    expected, actual = run(plain, 5, seed=2), run(disturbed, 5, seed=2)
    others = np.delete(ALL, 3)
    np.testing.assert_array_equal(actual[:, others], expected[:, others])
    assert not plain.diverged().any()
    np.testing.assert_array_equal(disturbed.diverged(), ALL == 3)

    disturbed.reset(np.array([0]), *draw_starts(np.random.default_rng(8), 1))
    np.testing.assert_array_equal(disturbed.diverged(), ALL == 3)
    disturbed.reset(np.array([3]), *draw_starts(np.random.default_rng(8), 1))
    assert not disturbed.diverged().any()
    assert np.isfinite(run(disturbed, 5, seed=3)[:, 3]).all()
    assert not disturbed.diverged().any()


@pytest.mark.parametrize("diverge", [diverge_by_velocity, diverge_by_nan_velocity, diverge_by_nan_start])
def test_both_drivers_continue_identically_after_a_divergence(diverge):
    results = []
    for driver in DRIVERS:
        simulation = start(driver)
        run(simulation, 3, seed=1)
        diverge(simulation, 3)
        results.append(run(simulation, 10, seed=2))
    for result in results[1:]:
        np.testing.assert_array_equal(result, results[0])
