"""Fields of the model with a value of its own in each env: friction, payload."""

import numpy as np
from built_in import STANCE
from drivers import ALL, DRIVERS, ROWS, SUBSTEPS, draw_starts, run, start


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
