"""States of an env that are saved and restored, and copies of a simulation: both continue identically."""

import copy
import pickle

import numpy as np
import pytest
from built_in import STANCE
from drivers import (
    ALL,
    ROWS,
    SUBSTEPS,
    diverge_by_velocity,
    draw_starts,
    draw_targets,
    physics_of,
    run,
    snapshot,
    start,
)

from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model


def test_a_restored_state_has_the_same_future(driver):
    simulation = start(driver)
    run(simulation, 10, seed=1)
    states, before = [simulation.get_state(row) for row in ALL], snapshot(simulation)
    expected = run(simulation, 20, seed=2)
    for row in (1, 4):
        simulation.set_state(row, states[row])
    np.testing.assert_array_equal(snapshot(simulation)[[1, 4]], before[[1, 4]])
    np.testing.assert_array_equal(snapshot(simulation)[[0, 2, 3]], expected[-1][[0, 2, 3]])
    for row in ALL:
        simulation.set_state(row, states[row])
    np.testing.assert_array_equal(run(simulation, 20, seed=2), expected)


@pytest.mark.parametrize("duplicate", [False, True])
def test_a_restored_single_env_is_ready_to_be_rendered(model, duplicate):
    simulation = SingleSimulation(copy.copy(model))
    simulation.reset(np.array([0]), *draw_starts(np.random.default_rng(0), 1))
    state, foot = simulation.get_state(0), simulation.readings.foot_position[0, 0].copy()
    for _ in range(10):
        simulation.step(draw_targets(np.random.default_rng(1))[:1], SUBSTEPS)
    simulation.set_state(0, state)
    shown = through_pickle(simulation) if duplicate else simulation
    np.testing.assert_array_equal(shown.data.site("LF_foot").xpos, foot)


def test_restored_env_is_diverged_if_it_was_when_saved(driver):
    simulation = start(driver)
    run(simulation, 3, seed=1)
    healthy = simulation.get_state(2)
    diverge_by_velocity(simulation, 2)
    run(simulation, 2, seed=2)
    diverged = simulation.get_state(2)
    simulation.set_state(2, healthy)
    assert not simulation.diverged().any()
    simulation.set_state(2, diverged)
    np.testing.assert_array_equal(simulation.diverged(), ALL == 2)


def through_pickle(simulation):
    return pickle.loads(pickle.dumps(simulation))  # noqa: S301


@pytest.mark.parametrize("duplicate", [copy.deepcopy, through_pickle])
def test_a_copy_has_the_same_future_also_with_changed_fields_of_the_model(driver, duplicate):
    simulation = start(driver)
    masses = np.tile(build_model().body_mass, (ROWS, 1))
    simulation.write_model_field("body_mass", masses * (1.0 + 0.1 * ALL[:, None]))
    simulation.reset(ALL, *draw_starts(np.random.default_rng(3), ROWS))
    run(simulation, 10, seed=1)
    copied = duplicate(simulation)
    np.testing.assert_array_equal(run(copied, 20, seed=2), run(simulation, 20, seed=2))
    for each in (simulation, copied):
        for part in getattr(each, "singles", [each]):
            part.restore_model_fields(np.arange(part.num_envs))
        each.reset(ALL, *draw_starts(np.random.default_rng(4), ROWS))
    np.testing.assert_array_equal(run(copied, 5, seed=5), run(simulation, 5, seed=5))


def test_renderers_copy_of_an_env_equals_that_env(model):
    simulation = BatchSimulation(model, ROWS, 1)
    simulation.reset(ALL, *draw_starts(np.random.default_rng(0), ROWS))
    simulation.step(np.tile(STANCE, (ROWS, 1)), SUBSTEPS)
    data = simulation.copy_data(3)
    qpos, qvel = physics_of(simulation, 3)
    np.testing.assert_array_equal(data.qpos, qpos)
    np.testing.assert_array_equal(data.qvel, qvel)
    columns = simulation.sensor_columns["foot_position"]
    np.testing.assert_array_equal(data.site("LF_foot").xpos, simulation.readings.foot_position[3, 0])
    np.testing.assert_array_equal(data.sensordata[columns], simulation.sensordata[3, columns])
    assert data.ncon > 0
    data.qpos[:] = 0.0
    np.testing.assert_array_equal(physics_of(simulation, 3)[0], qpos)
