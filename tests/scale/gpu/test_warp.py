"""MuJoCo Warp behind the protocol of the simulations, on a GPU or Warp's CPU device, against `mujoco.batch`.

The first run on a machine compiles the kernels, which takes about two minutes; Warp keeps them in ~/.cache/warp.
"""

import dataclasses

import mujoco
import numpy as np
import pytest
from warp_device import DEVICE

pytest.importorskip("mujoco_warp", reason="MuJoCo Warp is not installed: pip install -e '.[gpu]'")
pytestmark = pytest.mark.slow

from quadruped_env import QuadrupedError  # noqa: E402
from quadruped_env.policies import load_policy  # noqa: E402
from quadruped_env.robot import MINI_QUADRUPED  # noqa: E402
from quadruped_env.scale.gpu.warp_simulation import WarpSimulation, check_device, pinned  # noqa: E402
from quadruped_env.simulation import BatchSimulation, build_model  # noqa: E402
from quadruped_env.task import Task, TaskConfig, preset_values  # noqa: E402

OFTEN = {"push_interval": [0.2, 0.6], "push_force_interval": [0.2, 0.6], "push_force_duration": [0.1, 0.3]}
SERVOS = {"target_step": [0.0, 0.02], "backlash": [0.0, 0.02], "dead_band": [0.0, 0.01]}
HARD = TaskConfig.from_dict(
    {"randomization": {**preset_values("hard", MINI_QUADRUPED), **OFTEN, **SERVOS}, "action": {"mode": "residual"}}
)
LARGEST = {"qpos": 1e-5, "qvel": 1e-3, "observation": 1e-4, "reward": 1e-4}
"""Largest difference after one control step from the same state, in m, rad, m/s, rad/s and 1."""


def assert_same(found, expected):
    """Equal to the last bit; on a GPU, where sums have no fixed order, nearly."""
    if DEVICE == "cpu":
        np.testing.assert_array_equal(found, expected)
    else:
        np.testing.assert_allclose(found, expected, rtol=1e-2, atol=5e-3)


def everywhere(simulation):
    return np.arange(simulation.num_envs, like=simulation.sensordata)


def pair(config, n, **options):
    """Tasks on both simulations, with the same seeds."""
    model = config.compiled_model()
    tasks = (
        Task(BatchSimulation(model, n, 1), config, 60),
        Task(WarpSimulation(model, n, MINI_QUADRUPED, DEVICE, **options), config, 60),
    )
    for task in tasks:
        task.reset(everywhere(task.simulation), list(range(n)))
    return tasks


def standing(n, model=None, **options):
    """A simulation of robots in their stance, after a reset."""
    simulation = WarpSimulation(build_model() if model is None else model, n, MINI_QUADRUPED, DEVICE, **options)
    qpos = np.tile(simulation.model.qpos0, (n, 1))
    qpos[:, 2], qpos[:, 7:] = MINI_QUADRUPED.stance_height, MINI_QUADRUPED.stance
    reset(simulation, np.arange(n), qpos)
    return simulation


def reset(simulation, env_ids, qpos, qvel=None):
    velocity = np.zeros((len(qpos), simulation.model.nv)) if qvel is None else qvel
    simulation.reset(*(np.asarray(values, like=simulation.sensordata) for values in (env_ids, qpos, velocity)))


def state(simulation):
    data = simulation.data
    return np.concatenate([data.qpos.numpy(), data.qvel.numpy(), simulation.sensordata.numpy()], axis=1)


def test_reward_of_a_single_env_is_the_sum_of_its_terms():
    for task in pair(TaskConfig(), 1):
        transition = task.step(np.zeros((1, 8)))
        assert type(transition.reward) is type(transition.terms)
        assert transition.reward.tolist() == pytest.approx([sum(transition.terms.tolist()[0])])


def test_steps_from_the_same_state_agree_with_mujoco():
    """64 robots for 150 steps with all randomizations: masses, friction, motors, latency, pushes; some of them fall."""
    n, falling = 64, 12
    # Leaning robots count as fallen, so that many episodes end.
    here, there = pair(dataclasses.replace(HARD, termination=HARD.termination.replace(max_tilt=0.3)), n)
    policy = load_policy("flat")
    rng = np.random.default_rng(0)
    there.observe()
    observation, terminated, by_rounding = here.observe(), 0, 0
    largest = dict.fromkeys(LARGEST, 0.0)
    for _ in range(150):
        action = policy.predict(observation) + rng.normal(0.0, 0.05, (n, 8))
        action[:falling] = rng.uniform(-1.0, 1.0, (falling, 8))
        before = [here.simulation.get_state(env_id) for env_id in range(n)]
        there.simulation.set_states(everywhere(there.simulation), before)
        expected, found = here.step(action), there.step(action)
        own, other = here.simulation.batch, there.simulation.data
        differences = {
            "qpos": other.qpos.numpy() - own.bind("qpos"),
            "qvel": other.qvel.numpy() - own.bind("qvel"),
            "observation": found.observation.numpy() - expected.observation,
            "reward": (found.reward.numpy() - expected.reward)[:, None],
        }
        beyond = found.terminated.numpy() != expected.terminated
        for name, difference in differences.items():
            beyond |= np.abs(difference).max(axis=1) > LARGEST[name]
        for name, difference in differences.items():
            largest[name] = max(largest[name], np.abs(difference[~beyond]).max())
        for env_id in np.flatnonzero(beyond):
            # Otherwise what the task remembers of this step would differ in the next ones, too.
            by_rounding += 1
            there.set_state(env_id, here.get_state(env_id))
        np.testing.assert_array_equal(found.truncated.numpy(), expected.truncated)
        terminated += expected.terminated.sum()
        done = np.flatnonzero(here.finished)
        if len(done):
            here.reset(done)
            there.reset(np.asarray(done, np.int64, like=there.simulation.sensordata))
            np.testing.assert_allclose(there.observe().numpy()[done], here.observe()[done], atol=LARGEST["observation"])
        observation = here.observe()
    print(f"largest differences: {largest}; {by_rounding} env steps beyond them, {terminated} falls")
    assert terminated >= 15
    # Where two geoms are within a micrometre of each other, the rounding of float32 decides whether they touch.
    assert by_rounding <= 4


def test_readings_of_the_physics_steps_are_those_of_mujoco_for_any_number_of_them():
    """The numbers come back to one of before, whose kernels were captured with an array that is gone."""
    here, there = (task.simulation for task in pair(TaskConfig(), 3))
    rng = np.random.default_rng(0)
    for substeps in (4, 2, 4, 4):
        there.set_states(everywhere(there), [here.get_state(env_id) for env_id in range(3)])
        target = MINI_QUADRUPED.stance + rng.uniform(-0.1, 0.1, (3, 8))
        here.step(target, substeps)
        there.step(np.asarray(target, like=there.sensordata), substeps)
        for name, largest in (("joint_position", 1e-5), ("foot_position", 1e-5), ("foot_velocity", 1e-3)):
            expected, found = (getattr(simulation.substeps, name) for simulation in (here, there))
            assert found.shape == expected.shape
            assert found.shape[:2] == (substeps, 3)
            np.testing.assert_allclose(found.numpy(), expected, rtol=0, atol=largest)


def test_reset_of_some_worlds_leaves_others_bit_identical():
    _, task = pair(HARD, 6)
    rng = np.random.default_rng(1)
    for _ in range(20):
        task.step(rng.uniform(-0.3, 0.3, (6, 8)))
    simulation, kept = task.simulation, [0, 2, 3, 5]
    of_data = ("qpos", "qvel", "qacc_warmstart", "ctrl", "history", "xfrc_applied", "time")
    of_model = ("geom_friction", "body_mass", "body_invweight0", "dof_invweight0", "body_subtreemass")

    def values():
        found = {name: getattr(simulation.data, name).numpy().copy() for name in of_data}
        found |= {name: getattr(simulation.warp_model, name).numpy().copy() for name in of_model}
        return {**found, "sensordata": simulation.sensordata.numpy().copy()}

    before = values()
    task.reset(np.asarray([1, 4], np.int64, like=simulation.sensordata))
    for name, found in values().items():
        np.testing.assert_array_equal(found[kept], before[name][kept], err_msg=name)
        assert name == "xfrc_applied" or (found[[1, 4]] != before[name][[1, 4]]).any(), name


def test_friction_and_mass_of_each_world_equal_separately_compiled_models():
    friction, factor = np.array([0.3, 0.8, 1.2]), np.array([0.7, 1.0, 1.4])
    together = standing(3)
    together.model_field("geom_friction")[:, :, 0] = friction[:, None]
    for name in ("body_mass", "body_inertia"):
        values = together.model_field(name)
        values[:] = np.array([getattr(together.model, name) * f for f in factor])
    apart = []
    for f, mu in zip(factor, friction, strict=True):
        model = build_model()
        model.geom_friction[:, 0] = mu
        model.body_mass *= f
        model.body_inertia *= f
        mujoco.mj_setConst(model, mujoco.MjData(model))
        apart.append(standing(1, model))
    qpos = np.tile(together.data.qpos.numpy()[:1], (3, 1))
    qvel = np.zeros((3, together.model.nv))
    qvel[:, :2] = 1.0  # it slides
    reset(together, np.arange(3), qpos, qvel)
    for env_id, simulation in enumerate(apart):
        reset(simulation, [0], qpos[:1], qvel[:1])
        for name in ("body_subtreemass", "body_invweight0", "dof_invweight0"):
            own = getattr(together.warp_model, name).numpy()[env_id]
            np.testing.assert_allclose(own, getattr(simulation.model, name), rtol=1e-4, atol=1e-9, err_msg=name)
    for _ in range(25):
        target = np.tile(MINI_QUADRUPED.stance, (3, 1))
        together.step(np.asarray(target, like=together.sensordata), 4)
        for simulation in apart:
            simulation.step(np.asarray(target[:1], like=simulation.sensordata), 4)
    np.testing.assert_allclose(state(together), np.concatenate([state(s) for s in apart]), rtol=2e-3, atol=2e-3)
    moved = together.data.qpos.numpy()[:, 0]
    assert moved[0] > moved[1] > moved[2]  # less friction, longer way


def test_world_that_diverges_is_marked_and_restarts():
    simulation = standing(3)
    qpos, qvel = simulation.data.qpos.numpy()[1:2], np.full((1, simulation.model.nv), 1e9)
    target = np.asarray(np.tile(MINI_QUADRUPED.stance, (3, 1)), like=simulation.sensordata)
    alone = standing(3)
    reset(simulation, [1], qpos, qvel)
    for s in (simulation, alone):
        s.step(target, 4)
        s.step(target, 4)
    assert simulation.diverged().tolist() == [False, True, False]
    assert np.isfinite(state(simulation)).all()
    np.testing.assert_array_equal(state(simulation)[[0, 2]], state(alone)[[0, 2]])
    reset(simulation, [1], qpos)
    assert simulation.diverged().tolist() == [False, False, False]


@pytest.mark.parametrize(
    ("reserved", "message"),
    [({"constraints": 6}, r"more than 6 constraints .*constraints=12"), ({"contacts": 1}, r"more than 1 contacts")],
)
def test_overflow_is_an_error_that_names_the_fix(reserved, message):
    simulation = standing(2, **reserved)
    target = np.asarray(np.tile(MINI_QUADRUPED.stance, (2, 1)), like=simulation.sensordata)
    with pytest.raises(QuadrupedError, match=message):
        simulation.step(target, 40)


def test_reserved_memory_suffices_for_robots_that_fall():
    """A third of what is reserved is free, also where robots lie on the ground with their legs folded."""
    config = TaskConfig.from_dict({"termination": {"max_tilt": 3.0, "max_trunk_force": 1e9}})
    _, task = pair(config, 64)
    rng, rows, most = np.random.default_rng(3), 0, 0
    for _ in range(60):
        task.step(rng.uniform(-1.0, 1.0, (64, 8)))
        data = task.simulation.data
        rows = max(rows, data.nefc.numpy().max())
        of_worlds = data.contact.worldid.numpy()[: data.nacon.numpy()[0]]
        most = max(most, np.bincount(of_worlds).max(initial=0))
    assert rows <= 80, rows
    assert most <= 16, most


def test_state_can_be_restored_here_and_in_the_other_driver():
    here, there = pair(HARD, 3)
    rng = np.random.default_rng(4)
    for _ in range(10):
        there.step(rng.uniform(-0.3, 0.3, (3, 8)))
    target = there.simulation.data.ctrl.numpy().astype(np.float64)
    saved = [there.simulation.get_state(env_id) for env_id in range(3)]
    ends = []
    for _ in range(2):
        there.simulation.set_states(everywhere(there.simulation), saved)
        for _ in range(3):
            there.simulation.step(np.asarray(target, like=there.simulation.sensordata), 4)
        ends.append(state(there.simulation))
    assert_same(*ends)
    for env_id in range(3):
        here.simulation.set_state(env_id, saved[env_id])
    here.simulation.step(target, 4)
    there.simulation.set_states(everywhere(there.simulation), saved)
    there.simulation.step(np.asarray(target, like=there.simulation.sensordata), 4)
    np.testing.assert_allclose(there.simulation.data.qpos.numpy(), here.simulation.batch.bind("qpos"), atol=1e-4)


def test_pinned_model_keeps_the_cone():
    model = build_model()
    found = pinned(model).opt
    assert (found.integrator, found.solver) == (mujoco.mjtIntegrator.mjINT_IMPLICITFAST, mujoco.mjtSolver.mjSOL_NEWTON)
    assert (found.iterations, found.ls_iterations) == (20, 50)
    assert found.cone == model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC
    assert model.opt.iterations == 10  # the caller's model is unchanged


def test_what_warp_does_not_simulate_is_refused():
    config = TaskConfig.from_dict({"terrain": {"name": "rough"}})
    with pytest.raises(QuadrupedError, match=r"terrain: .*a height field, .*train on level ground, or with"):
        WarpSimulation(config.compiled_model(), 1, MINI_QUADRUPED, DEVICE)
    simulation = standing(2)
    with pytest.raises(QuadrupedError, match=r"'geom_condim' is the same in all envs .* --device cpu"):
        simulation.model_field("geom_condim")
    with pytest.raises(QuadrupedError, match="all envs advance together"):
        simulation.step(np.zeros((2, 8), like=simulation.sensordata), 4, everywhere(simulation)[:1])


@pytest.mark.parametrize(
    ("name", "available", "driver", "message"),
    [
        ("gpu", False, None, "unknown; expected cuda"),
        ("cuda", False, None, "finds no CUDA GPU .*nvidia-smi .*--device cpu"),
        ("cuda:7", False, None, "cuda:7"),
        ("cuda", True, (12, 2), r"driver is for CUDA 12\.2; expected 12\.4 or newer; update the driver"),
    ],
)
def test_device_that_cannot_be_used_is_an_error(name, available, driver, message, monkeypatch):
    monkeypatch.setattr("warp.is_cuda_available", lambda: available)
    monkeypatch.setattr("torch.cuda.is_available", lambda: available)
    monkeypatch.setattr("warp.get_cuda_driver_version", lambda: driver)
    with pytest.raises(QuadrupedError, match=message):
        check_device(name)
