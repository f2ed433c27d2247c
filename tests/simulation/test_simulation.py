"""The two simulation drivers: identical bits, independent envs, and states that can be saved and restored."""

import copy
import pickle
from dataclasses import fields

import mujoco
import numpy as np
import pytest
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE, STANCE_HEIGHT

from quadruped_env.readings import Readings
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model

ROWS = 5
ALL = np.arange(ROWS)
SUBSTEPS = 4


class Singles:
    """Several `SingleSimulation`s behind the interface of one simulation with as many envs."""

    def __init__(self, model, num_envs):
        # One model each: a single simulation writes the model fields of its env into its own.
        self.singles = [SingleSimulation(copy.copy(model)) for _ in range(num_envs)]

    def step(self, joint_target, substeps):
        for single, target in zip(self.singles, joint_target, strict=True):
            single.step(target[None], substeps)

    def reset(self, rows, qpos, qvel):
        for i, row in enumerate(rows):
            self.singles[row].reset(np.array([0]), qpos[i : i + 1], qvel[i : i + 1])

    def push(self, rows, velocity):
        for i, row in enumerate(rows):
            self.singles[row].push(np.array([0]), velocity[i : i + 1])

    def write_model_field(self, name, values):
        for single, value in zip(self.singles, values, strict=True):
            single.model_field(name)[0] = value

    def diverged(self):
        return np.concatenate([single.diverged() for single in self.singles])

    def get_state(self, row):
        return self.singles[row].get_state(0)

    def set_state(self, row, state):
        self.singles[row].set_state(0, state)

    def reading(self, name):
        return np.concatenate([getattr(single.readings, name) for single in self.singles])


class Batched(BatchSimulation):
    """`BatchSimulation` with the two helpers that `Singles` has."""

    def write_model_field(self, name, values):
        self.model_field(name)[:] = values

    def reading(self, name):
        return getattr(self.readings, name).copy()


DRIVERS = {
    "singles": Singles,
    "1 thread": lambda model, rows: Batched(model, rows, 1),
    "2 threads": lambda model, rows: Batched(model, rows, 2),
    "3 threads": lambda model, rows: Batched(model, rows, 3),
}


READINGS = tuple(field.name for field in fields(Readings))


def side_by_side(columns):
    return np.concatenate([np.reshape(column, (len(column), -1)) for column in columns], axis=1)


def readings_of(state):
    """Every reading of a `Readings` side by side (N, ...), a copy."""
    return side_by_side([getattr(state, name) for name in READINGS])


def snapshot(simulation):
    """Readings and full state of every env, side by side."""
    states = np.array([simulation.get_state(row).integration for row in ALL])
    return side_by_side([*(simulation.reading(name) for name in READINGS), states])


def physics_of(simulation, row):
    """qpos (15,) and qvel (14,) of an env, from its state, in which time comes first."""
    state = simulation.get_state(row).integration
    return state[1:16], state[16:30]


def draw_starts(rng, rows):
    """Random starts (R, 15), (R, 14) a little over the ground."""
    qpos = np.zeros((rows, 15))
    qpos[:, 2] = STANCE_HEIGHT + rng.uniform(0.0, 0.1, rows)
    qpos[:, 3] = 1.0
    qpos[:, 4:7] = 0.1 * rng.standard_normal((rows, 3))
    qpos[:, 3:7] /= np.linalg.norm(qpos[:, 3:7], axis=1, keepdims=True)
    qpos[:, 7:] = STANCE + 0.1 * rng.standard_normal((rows, 8))
    return qpos, 0.3 * rng.standard_normal((rows, 14))


def draw_targets(rng):
    return rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH, (ROWS, 8))


def start(driver, seed=0, model=None):
    simulation = DRIVERS[driver](model or build_model(), ROWS)
    simulation.reset(ALL, *draw_starts(np.random.default_rng(seed), ROWS))
    return simulation


def run(simulation, steps, seed):
    """Random controls for some steps; the snapshots after each, (steps, N, ...)."""
    rng = np.random.default_rng(seed)
    snapshots = []
    for _ in range(steps):
        simulation.step(draw_targets(rng), SUBSTEPS)
        snapshots.append(snapshot(simulation))
    return np.array(snapshots)


@pytest.fixture(params=["singles", "2 threads"])
def driver(request):
    return request.param


def eventful_run(driver, steps=300):
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
    for driver in ("1 thread", "2 threads", "3 threads"):
        np.testing.assert_array_equal(eventful_run(driver), expected, err_msg=driver)


def test_one_control_step_is_as_many_physics_steps_of_mujoco(model):
    qpos, qvel = draw_starts(np.random.default_rng(0), 1)
    simulation = SingleSimulation(model)
    simulation.reset(np.array([0]), qpos, qvel)
    data = mujoco.MjData(model)
    data.qpos, data.qvel = qpos[0], qvel[0]
    mujoco.mj_forward(model, data)
    rng = np.random.default_rng(1)
    for _ in range(50):
        target = draw_targets(rng)[:1]
        simulation.step(target, SUBSTEPS)
        data.ctrl = target[0]
        mujoco.mj_step(model, data, SUBSTEPS)
        np.testing.assert_array_equal(simulation.data.qpos, data.qpos)
        np.testing.assert_array_equal(simulation.data.qvel, data.qvel)


def test_positions_and_velocities_are_current_after_a_step(driver):
    simulation = start(driver)
    run(simulation, 5, seed=1)
    for row in ALL:
        qpos, qvel = physics_of(simulation, row)
        np.testing.assert_array_equal(simulation.reading("joint_position")[row], qpos[7:])
        np.testing.assert_array_equal(simulation.reading("joint_velocity")[row], qvel[6:])
        np.testing.assert_array_equal(simulation.reading("base_position")[row], qpos[:3])


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


def test_reset_of_no_envs_changes_nothing(driver):
    simulation = start(driver)
    before = snapshot(simulation)
    none = np.array([], dtype=np.intp)
    simulation.reset(none, np.zeros((0, 15)), np.zeros((0, 14)))
    simulation.push(none, np.zeros((0, 3)))
    np.testing.assert_array_equal(snapshot(simulation), before)


def diverge_by_velocity(simulation, row):
    simulation.push(np.array([row]), np.full((1, 3), 1e12))


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


def test_a_state_moves_between_drivers():
    source = start("singles")
    run(source, 10, seed=1)
    expected, states = snapshot(source), [source.get_state(row) for row in ALL]
    target = start("2 threads", seed=7)
    run(target, 3, seed=3)
    for row in ALL:
        target.set_state(row, states[row])
    np.testing.assert_array_equal(snapshot(target), expected)
    np.testing.assert_array_equal(run(target, 20, seed=2), run(source, 20, seed=2))


def test_a_push_right_after_restoring_keeps_the_restored_forces(driver):
    simulation = start(driver)
    run(simulation, 10, seed=1)
    state = simulation.get_state(0)
    run(simulation, 10, seed=2)
    simulation.set_state(0, state)
    forces = ("joint_torque", "foot_force", "trunk_force", "linear_acceleration_b")
    before = [simulation.reading(name) for name in forces]
    simulation.push(np.array([0]), np.array([[1.0, 0.0, 0.0]]))
    for name, expected in zip(forces, before, strict=True):
        np.testing.assert_array_equal(simulation.reading(name), expected, err_msg=name)


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
def test_a_copied_single_simulation_continues_identically(model, duplicate):
    rng = np.random.default_rng(0)
    original = SingleSimulation(copy.copy(model))
    original.model_field("geom_friction")[:, :, 0] = 0.6
    original.reset(np.array([0]), *draw_starts(rng, 1))
    for _ in range(20):
        original.step(draw_targets(rng)[:1], SUBSTEPS)
    duplicates = [duplicate(original), duplicate(duplicate(original))]
    for _ in range(30):
        target = draw_targets(rng)[:1]
        for simulation in (original, *duplicates):
            simulation.step(target, SUBSTEPS)
        expected = original.get_state(0)
        for simulation in duplicates:
            np.testing.assert_array_equal(readings_of(simulation.readings), readings_of(original.readings))
            np.testing.assert_array_equal(simulation.get_state(0).integration, expected.integration)
    # Nothing is shared: a reset of the original and its new friction do not affect the copies.
    before = readings_of(duplicates[0].readings)
    original.model_field("geom_friction")[:] = 0.1
    original.reset(np.array([0]), *draw_starts(rng, 1))
    np.testing.assert_array_equal(readings_of(duplicates[0].readings), before)
    assert duplicates[0].model.geom_friction[0, 0] == 0.6


def vary_models(simulation, model, rows_friction, rows_payload):
    base = model.body("base_link").id
    friction = np.tile(model.geom_friction, (ROWS, 1, 1))
    friction[:, :, 0] = rows_friction[:, None]
    mass = np.tile(model.body_mass, (ROWS, 1))
    mass[:, base] += rows_payload
    simulation.write_model_field("geom_friction", friction)
    simulation.write_model_field("body_mass", mass)


def test_model_field_belongs_to_its_env(model):
    friction, payload = np.full(ROWS, 0.8), np.zeros(ROWS)
    friction[1], payload[3] = 0.2, 1.0
    results = {}
    for driver, make in DRIVERS.items():
        simulation = make(model, ROWS)
        vary_models(simulation, model, friction, payload)
        simulation.reset(ALL, *draw_starts(np.random.default_rng(0), ROWS))
        results[driver] = run(simulation, 40, seed=1)
    for driver, result in results.items():
        np.testing.assert_array_equal(result, results["singles"], err_msg=driver)
    plain = run(start("singles"), 40, seed=1)
    same = (results["singles"] == plain).all(axis=(0, 2))
    np.testing.assert_array_equal(same, [True, False, True, False, True])
    assert model.geom_friction[0, 0] == 0.8, "the caller's model must not change"


def test_a_payload_weighs_on_the_feet(driver, model):
    simulation = DRIVERS[driver](model, ROWS)
    payload = np.linspace(0.0, 1.0, ROWS)
    vary_models(simulation, model, np.full(ROWS, 0.8), payload)
    qpos = np.tile(model.key("home").qpos, (ROWS, 1))
    simulation.reset(ALL, qpos, np.zeros((ROWS, 14)))
    for _ in range(150):
        simulation.step(np.tile(STANCE, (ROWS, 1)), SUBSTEPS)
    force = simulation.reading("foot_force").sum(axis=1)
    np.testing.assert_allclose(force, (4.0 + payload) * 9.81, rtol=0.01)


def test_a_state_carries_its_model_fields(driver, model):
    source, target = DRIVERS[driver](model, ROWS), start(driver, seed=3)
    vary_models(source, model, np.linspace(0.2, 1.0, ROWS), np.linspace(0.0, 1.0, ROWS))
    source.reset(ALL, *draw_starts(np.random.default_rng(0), ROWS))
    run(source, 5, seed=1)
    for row in ALL:
        target.set_state(row, source.get_state(row))
    np.testing.assert_array_equal(run(target, 20, seed=2), run(source, 20, seed=2))


def test_a_push_adds_world_velocity_to_the_base(driver):
    simulation = start(driver)
    run(simulation, 3, seed=1)
    before = snapshot(simulation)
    qpos, qvel = physics_of(simulation, 1)
    velocity = np.array([[0.3, -0.2, 0.1]])
    simulation.push(np.array([1]), velocity)
    others = np.delete(ALL, 1)
    np.testing.assert_array_equal(snapshot(simulation)[others], before[others])
    pushed_qpos, pushed_qvel = physics_of(simulation, 1)
    np.testing.assert_array_equal(pushed_qpos, qpos)
    np.testing.assert_array_equal(pushed_qvel[:3], qvel[:3] + velocity[0])
    np.testing.assert_array_equal(pushed_qvel[3:], qvel[3:])


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


def test_renderers_copy_of_an_env_equals_that_env(model):
    simulation = BatchSimulation(model, ROWS, 1)
    simulation.reset(ALL, *draw_starts(np.random.default_rng(0), ROWS))
    simulation.step(np.tile(STANCE, (ROWS, 1)), SUBSTEPS)
    data = simulation.copy_data(3)
    qpos, qvel = physics_of(simulation, 3)
    np.testing.assert_array_equal(data.qpos, qpos)
    np.testing.assert_array_equal(data.qvel, qvel)
    data.qpos[:] = 0.0
    np.testing.assert_array_equal(physics_of(simulation, 3)[0], qpos)
