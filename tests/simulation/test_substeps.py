"""Readings at the beginning of each physics step: identical in both drivers, and equal to steps taken one by one."""

import pickle

import numpy as np
import pytest
from drivers import ALL, READINGS, ROWS, SUBSTEPS, draw_starts, draw_targets, start

from quadruped_env.simulation import BatchSimulation, SingleSimulation

OF_FORCES = ("joint_torque", "linear_acceleration_b", "foot_force", "trunk_force")
"""Readings that MuJoCo computes within a physics step."""
OF_THE_STATE = tuple(name for name in READINGS if name not in OF_FORCES)


def substeps_of(simulation):
    """Name -> readings of the physics steps (S, N, ...), a copy."""
    if hasattr(simulation, "singles"):
        parts = [single.substeps for single in simulation.singles]
        return {name: np.concatenate([getattr(part, name) for part in parts], axis=1) for name in READINGS}
    return {name: getattr(simulation.substeps, name).copy() for name in READINGS}


def test_entries_are_the_readings_before_each_physics_step(driver):
    """The first one shows the end of the control step before; forces are those that act in the physics step."""
    simulation, one_by_one = start(driver), start(driver)
    rng = np.random.default_rng(2)
    for _ in range(10):
        target = draw_targets(rng)
        before = [{name: one_by_one.reading(name) for name in OF_THE_STATE}]
        forces = []
        for _ in range(SUBSTEPS):
            one_by_one.step(target, 1)
            before.append({name: one_by_one.reading(name) for name in OF_THE_STATE})
            forces.append({name: one_by_one.reading(name) for name in OF_FORCES})
        at_the_end = {name: simulation.reading(name) for name in OF_THE_STATE}
        simulation.step(target, SUBSTEPS)
        found = substeps_of(simulation)
        for name in OF_THE_STATE:
            np.testing.assert_array_equal(found[name][0], at_the_end[name], err_msg=name)
            np.testing.assert_array_equal(found[name], [entry[name] for entry in before[:-1]], err_msg=name)
        for name in OF_FORCES:
            np.testing.assert_array_equal(found[name], [entry[name] for entry in forces], err_msg=name)
            np.testing.assert_array_equal(found[name][-1], simulation.reading(name), err_msg=name)
        assert found["foot_force"].shape == (SUBSTEPS, ROWS, 4)


def test_push_of_six_components_is_in_the_velocities_of_the_next_physics_step(driver):
    simulation, rng = start(driver), np.random.default_rng(3)
    for _ in range(3):
        simulation.step(draw_targets(rng), SUBSTEPS)
    spin, others = simulation.reading("angular_velocity_b"), np.array([0, 3, 4])
    state = [simulation.get_state(row).integration[16:30] for row in ALL]  # qvel
    push = np.array([[0.3, -0.2, 0.1, 0.7, -0.5, 0.4], [-0.1, 0.4, -0.3, -0.9, 0.2, 1.1]])
    simulation.push(np.array([1, 2]), push)
    for row in ALL:
        added = np.zeros(14)
        if row in (1, 2):
            added[:6] = push[row - 1]
        np.testing.assert_array_equal(simulation.get_state(row).integration[16:30], state[row] + added)
    np.testing.assert_array_equal(simulation.reading("angular_velocity_b"), spin)
    simulation.step(draw_targets(rng), SUBSTEPS)
    found = substeps_of(simulation)["angular_velocity_b"][0]
    np.testing.assert_allclose(found[[1, 2]], spin[[1, 2]] + push[:, 3:], rtol=0, atol=1e-12)
    np.testing.assert_array_equal(found[others], spin[others])


@pytest.mark.parametrize("make", [SingleSimulation, lambda model: BatchSimulation(model, 2, 1)])
def test_step_of_no_env_leaves_room_for_the_readings(make, model):
    simulation = make(model)
    everything = np.arange(simulation.num_envs)
    simulation.reset(everything, *draw_starts(np.random.default_rng(0), simulation.num_envs))
    simulation.step(np.zeros((simulation.num_envs, 8)), SUBSTEPS, np.array([], dtype=int))
    assert simulation.substeps.foot_force.shape == (SUBSTEPS, simulation.num_envs, 4)


def test_restored_state_of_a_pushed_robot_has_the_push_in_the_next_physics_step_and_not_in_its_readings():
    found = []
    for driver in ("singles", "1 thread"):
        pushed, restored, rng = start(driver), start(driver, seed=7), np.random.default_rng(4)
        pushed.step(draw_targets(rng), SUBSTEPS)
        pushed.push(np.array([1]), np.array([[0.5, 0.3, -0.4, 1.0, 2.0, 3.0]]))
        restored.set_state(1, pushed.get_state(1))
        simulations = [pushed, restored]
        if driver == "singles":
            pickled = pickle.loads(pickle.dumps(pushed.singles[1]))  # noqa: S301
            for name in READINGS:
                np.testing.assert_array_equal(getattr(pickled.readings, name)[0], pushed.reading(name)[1], err_msg=name)
        for name in READINGS:
            np.testing.assert_array_equal(restored.reading(name)[1], pushed.reading(name)[1], err_msg=name)
        target = draw_targets(rng)
        for simulation in simulations:
            simulation.step(target, SUBSTEPS)
            found.append({name: values[:, 1] for name, values in substeps_of(simulation).items()})
        if driver == "singles":
            pickled.step(target[1:2], SUBSTEPS)
            found.append({name: getattr(pickled.substeps, name)[:, 0] for name in READINGS})
    for record in found[1:]:
        for name in READINGS:
            np.testing.assert_array_equal(record[name], found[0][name], err_msg=name)
