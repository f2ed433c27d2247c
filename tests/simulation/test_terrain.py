"""Ground of the simulation: heights, the model, contacts, closed forms on a slope, and all that runs on it."""

import copy
import dataclasses
import json
import math
import pickle
import subprocess
import sys

import gymnasium
import mujoco
import numpy as np
import pytest
from built_in import FOOT_RADIUS, STANCE, STANCE_HEIGHT, TOTAL_MASS
from environments import ROUGH, assert_same, episodes, make, make_native, make_sync

from quadruped_env import QuadrupedError
from quadruped_env.envs import ENV_ID, make_sb3_vec_env
from quadruped_env.envs.arguments import task_config
from quadruped_env.policies import CommandedGaitController, PolicyController, load_policy
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model, find_terrain
from quadruped_env.simulation import model as model_module
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.simulation.terrain import MAX_POINTS, hills, rough
from quadruped_env.task import Task, TaskConfig, TerrainConfig, load_task_file, terrain

UNEVEN = ("rough", "hills")
_GROUND_ONLY = np.array([1, 0, 0, 0, 0, 0], np.uint8)
ENV = np.zeros(1, dtype=np.intp)
_FRICTION = [0.8, 0.0, 0.0]


@terrain(size=8.0)
def slope(grid, angle: float = 0.2, direction: float = 0.0):
    """Plane that rises at an angle (rad) towards a direction (rad)."""
    return math.tan(angle) * (grid.x * math.cos(direction) + grid.y * math.sin(direction))


@terrain(size=8.0)
def level_field(grid):
    """Level ground, but for one corner, so that it is a height field."""
    heights = np.zeros_like(grid.x)
    heights[0, 0] = 0.01
    return heights


def ray_heights(model, points):
    """Height of the ground at points (N, 2), from rays."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    geom = np.zeros((1, 1), dtype=np.int32)
    down = [0.0, 0.0, -1.0]
    return [3.0 - mujoco.mj_ray(model, data, [*point, 3.0], down, _GROUND_ONLY, 1, -1, geom, None) for point in points]


# --- heights


@pytest.mark.parametrize("shape", [rough, hills], ids=lambda one: one.name)
def test_built_in_terrain_repeats_with_its_seed_and_is_level_at_start_and_edge(shape):
    heights = shape.variant(3).heights()
    np.testing.assert_array_equal(heights, shape.variant(3).heights())
    assert not np.array_equal(heights, shape.variant(4).heights())
    middle = len(heights) // 2
    assert not heights[middle - 2 : middle + 3, middle - 2 : middle + 3].any()
    assert not np.concatenate([heights[[0, -1]].ravel(), heights[:, [0, -1]].ravel()]).any()
    top = shape.parameters["height"][1]
    assert 0.8 * top < heights.max() <= top
    assert heights.min() >= 0.0
    np.testing.assert_allclose(shape.variant(3, height=2.0 * top).heights(), 2.0 * heights)


@pytest.mark.parametrize(
    "shape", [rough, hills.variant(5), slope.variant(angle=0.3, direction=1.0)], ids=lambda shape: shape.name
)
def test_height_field_lookup_equals_mujocos_rays_inside_and_outside(shape):
    model = build_model(terrain=shape)
    field = HeightField.of(model)
    points = np.random.default_rng(0).uniform(-0.52 * shape.size, 0.52 * shape.size, (2000, 2))
    np.testing.assert_allclose(field.at(points), ray_heights(model, points), atol=1e-12)
    outside = np.abs(points).max(axis=1) > 0.5 * shape.size
    assert 50 < outside.sum() < 500
    np.testing.assert_allclose(field.at(points[outside]), shape.heights().min() - 0.01, atol=1e-9)


def test_height_field_lookup_at_grid_points_equals_the_terrains_heights():
    shape = hills.variant(2)
    grid = np.linspace(-0.5 * shape.size, 0.5 * shape.size, len(shape.heights()))
    x, y = np.meshgrid(grid, grid)
    # MuJoCo stores heights as float32.
    np.testing.assert_allclose(
        HeightField.of(build_model(terrain=shape)).at(np.stack([x, y], -1)), shape.heights(), atol=1e-8
    )


def test_height_field_lookup_of_a_point_does_not_depend_on_the_others():
    field = HeightField.of(build_model(terrain=rough))
    points = np.random.default_rng(1).uniform(-21.0, 21.0, (100, 4, 3))
    together, highest = field.at(points), field.highest(points)
    for i, j in np.ndindex(100, 4):
        assert field.at(points[i, j]) == together[i, j]
        assert field.highest(points[i : i + 1, j])[0] == highest[i, j]
    assert np.isfinite(field.at(np.full((2, 3), np.nan))).all()


def test_highest_ground_bounds_the_ground_around_a_point():
    field = HeightField.of(build_model(terrain=hills))
    rng = np.random.default_rng(2)
    for point in rng.uniform(-15.0, 15.0, (50, 2)):
        around = point + rng.uniform(-0.25, 0.25, (500, 2))
        nearby = point + rng.uniform(-0.45, 0.45, (5000, 2))
        assert field.at(around).max() <= field.highest(point) <= field.at(nearby).max() + 0.003


def test_flat_model_is_a_plane_without_height_field():
    model = build_model()
    assert HeightField.of(model) is None
    assert model.nhfield == 0
    assert model.geom("ground").type == mujoco.mjtGeom.mjGEOM_PLANE
    assert model.opt.cone == mujoco.mjtCone.mjCONE_PYRAMIDAL


REFUSED = {
    "shape": (lambda grid: grid.x[0], r"terrain shape: expected finite heights of shape \(401, 401\).*\(401,\)"),
    "infinite": (lambda grid: grid.x / 0.0, r"terrain infinite: expected finite heights.*found a height that is not"),
    "failure": (lambda grid: grid.z, r"terrain failure: AttributeError: .*'z'"),
}


@pytest.mark.parametrize(("function", "message"), REFUSED.values(), ids=REFUSED)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_terrain_with_invalid_heights_is_refused_with_its_name(function, message, request):
    function.__name__ = function.__qualname__ = request.node.callspec.id
    with pytest.raises(QuadrupedError, match=message):
        build_model(terrain=terrain(function))


def test_terrain_with_an_invalid_size_or_parameter_is_refused():
    with pytest.raises(QuadrupedError, match=f"1 to {MAX_POINTS - 1} cells per side; found size=40, cell=0.001"):
        dataclasses.replace(rough, cell=0.001)
    with pytest.raises(QuadrupedError, match=r"terrain rough: unknown parameter 'depth'.*: height, distance"):
        rough.variant(depth=1.0)
    with pytest.raises(QuadrupedError, match=r"terrain rough: distance must be at least 0.2 \(m\); found 0.0"):
        rough.variant(distance=0.0)
    with pytest.raises(QuadrupedError, match="'seed' is a field of every terrain"):
        terrain(lambda grid, seed=1: grid.x)


# --- contacts


def standing(model, seconds=1.5, yaw=0.4):
    """A simulation of a robot that has stood for a while, away from grid points."""
    simulation = SingleSimulation(model)
    qpos = np.array([0.027, 0.017, STANCE_HEIGHT, math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2), *STANCE])
    simulation.reset(ENV, qpos[None], np.zeros((1, 14)))
    simulation.step(STANCE[None], round(seconds / model.opt.timestep))
    return simulation


def test_robot_beyond_the_edge_of_the_field_stands_on_the_plane_around_it():
    simulation = SingleSimulation(build_model(terrain=hills))
    qpos = np.array([25.0, 3.0, STANCE_HEIGHT, 1.0, 0.0, 0.0, 0.0, *STANCE])
    simulation.reset(ENV, qpos[None], np.zeros((1, 14)))
    simulation.step(STANCE[None], 400)
    assert touched(simulation) == {"surroundings"}
    height = simulation.readings.base_position[0, 2] - simulation.height_field.at(simulation.readings.base_position)[0]
    assert height == pytest.approx(STANCE_HEIGHT, abs=1e-3)


def test_walking_robot_leaves_the_field_without_falling():
    """Down the step at the edge."""
    small = dataclasses.replace(hills, size=3.0)
    controller = PolicyController(load_policy("flat"))
    task = Task(BatchSimulation(build_model(terrain=small), 6), controller.policy.config)
    task.reset(np.arange(6), seeds=list(range(6)), command=(0.5, 0.0))
    observation, fallen = task.observe(), np.zeros(6, dtype=bool)
    for _ in range(350):
        transition = task.act(controller, observation)
        observation, fallen = transition.observation, fallen | transition.terminated
    outside = np.abs(task.simulation.readings.base_position[:, :2]).max(axis=1) > 1.75
    assert outside.all()
    assert not fallen.any()


def plane_beside_the_field(spec, heights, size):
    """The arrangement that doubled the contacts: the plane stays where it was."""
    lay(spec, heights, size)
    spec.geom("surroundings").pos = [0.0, 0.0, 0.0]


lay = model_module._lay


@pytest.fixture
def doubled(monkeypatch):
    """A level height field with the plane at the same height."""
    monkeypatch.setattr(model_module, "_lay", plane_beside_the_field)
    return build_model(terrain=dataclasses.replace(level_field, name="doubled"))


def touched(simulation):
    """Names of the fixed geoms in contact with the robot."""
    model, data = simulation.model, simulation.data
    mujoco.mj_forward(model, data)
    return {model.geom(geom).name for contact in data.contact for geom in contact.geom if not model.geom_bodyid[geom]}


def test_robot_on_a_level_height_field_stands_as_on_the_plane():
    plane, field = standing(build_model()), standing(build_model(terrain=level_field))
    assert touched(field) == {"ground"}
    for simulation in (plane, field):
        assert simulation.readings.foot_force.sum() == pytest.approx(9.81 * TOTAL_MASS, rel=1e-3)
    np.testing.assert_allclose(field.readings.base_position, plane.readings.base_position, atol=2e-4)
    np.testing.assert_allclose(field.readings.orientation, plane.readings.orientation, atol=5e-4)


def test_plane_at_the_height_of_the_field_would_double_the_contacts(doubled):
    """The test above finds it."""
    assert touched(standing(doubled)) == {"ground", "surroundings"}


def turning_rate(model, controller, num_envs=16, seconds=5.0):
    """Mean yaw rate of a controller that turns on the spot at 0.5 rad/s, with random headings."""
    config = task_config(controller.action_mode, getattr(getattr(controller, "policy", None), "config", None))
    task = Task(BatchSimulation(model, num_envs), config)
    task.reset(np.arange(num_envs), seeds=list(range(num_envs)), command=(0.0, 0.5))
    observation, rates = task.observe(), []
    for _ in range(round(seconds / config.control_timestep)):
        observation = task.act(controller, observation).observation
        rates.append(task.simulation.readings.angular_velocity_b[:, 2].mean())
    return np.mean(rates[len(rates) // 4 :])


@pytest.mark.parametrize("make_controller", [lambda: PolicyController(load_policy("flat")), CommandedGaitController])
def test_robot_on_a_level_height_field_turns_as_on_a_plane_with_the_same_friction_cone(make_controller):
    plane, field = build_model(), build_model(terrain=level_field)
    plane.opt.cone = field.opt.cone
    controller = make_controller()
    assert turning_rate(field, controller) == pytest.approx(turning_rate(plane, controller), rel=0.05)


# --- closed forms on a slope


def body_on_slope(shape, *geoms):
    """A single body of geoms on a slope, without the robot: model and data."""
    spec = mujoco.MjSpec()
    spec.option.timestep, spec.option.impratio = 0.002, 100.0
    spec.worldbody.add_geom(name="ground", type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0, 0, 0.05], friction=_FRICTION)
    model_module._lay(spec, shape.heights(), shape.size)
    body = spec.worldbody.add_body()
    body.add_freejoint()
    for geom in geoms:
        body.add_geom(friction=_FRICTION, **geom)
    model = spec.compile()
    return model, mujoco.MjData(model)


def slid(angle, direction):
    """Distance that a sled of four balls slides on a slope in 1 s, m."""
    corners = [(x, y, 0.0) for x in (-0.1, 0.1) for y in (-0.1, 0.1)]
    balls = [{"type": mujoco.mjtGeom.mjGEOM_SPHERE, "size": [0.02, 0, 0], "pos": corner} for corner in corners]
    model, data = body_on_slope(slope.variant(angle=angle, direction=direction), *balls)
    uphill = np.array([math.cos(direction), math.sin(direction)])
    data.qpos[:3] = 0.0199 * normal_of(angle, direction)
    data.qpos[3:7] = tilted(angle, direction)
    start = data.qpos[:2].copy()
    mujoco.mj_step(model, data, 500)
    return (start - data.qpos[:2]) @ uphill / math.cos(angle)


@pytest.mark.parametrize("direction", [0.0, math.pi / 4, 1.0])
def test_friction_on_a_height_field_does_not_depend_on_the_direction(direction):
    """With MuJoCo's friction pyramid the sled slides along the diagonal where it should stand."""
    threshold = math.atan(_FRICTION[0])
    assert slid(threshold - 0.03, direction) == pytest.approx(0.0, abs=1e-3)
    angle = threshold + 0.03
    acceleration = 9.81 * (math.sin(angle) - _FRICTION[0] * math.cos(angle))
    assert slid(angle, direction) == pytest.approx(0.5 * acceleration, rel=0.1)


def normal_of(angle, direction):
    """Unit normal of a slope."""
    return np.array([-math.sin(angle) * math.cos(direction), -math.sin(angle) * math.sin(direction), math.cos(angle)])


def tilted(angle, direction):
    """Quaternion of a body that lies on a slope."""
    axis = np.array([math.sin(direction), -math.cos(direction), 0.0])
    return np.concatenate([[math.cos(angle / 2)], math.sin(angle / 2) * axis])


def test_ball_that_falls_on_a_slope_touches_the_height_of_the_lookup():
    shape, radius = slope.variant(angle=0.3), 0.02
    model, data = body_on_slope(shape, {"type": mujoco.mjtGeom.mjGEOM_SPHERE, "size": [radius, 0, 0]})
    field = HeightField.of(model)
    data.qpos[:3] = 0.63, -0.41, 0.5
    fallen = 0
    while not data.ncon:
        mujoco.mj_step(model, data)
        fallen += 1
    vertical = data.qpos[2] - field.at(data.qpos[:2])
    assert vertical == pytest.approx(radius / math.cos(0.3), abs=9.81 * fallen * 0.002**2 * 1.5)
    height = 0.5 - math.tan(0.3) * 0.63 - radius / math.cos(0.3)
    assert fallen * 0.002 == pytest.approx(math.sqrt(2.0 * height / 9.81), abs=0.005)


@pytest.mark.parametrize("direction", [0.0, math.pi, 2.0])
def test_robot_that_stands_on_a_slope_is_tilted_by_its_angle(direction):
    angle = 0.15
    simulation = SingleSimulation(build_model(terrain=slope.variant(angle=angle, direction=direction)))
    qpos = np.zeros(15)
    qpos[3:7], qpos[7:] = tilted(angle, direction), STANCE
    qpos[:3] = STANCE_HEIGHT * normal_of(angle, direction)
    simulation.reset(ENV, qpos[None], np.zeros((1, 14)))
    simulation.step(STANCE[None], 300)
    assert math.acos(simulation.readings.up_b[0, 2]) == pytest.approx(angle, abs=0.02)
    over_ground = simulation.readings.foot_position[0, :, 2] - simulation.height_field.at(
        simulation.readings.foot_position[0]
    )
    np.testing.assert_allclose(over_ground, FOOT_RADIUS / math.cos(angle), atol=5e-4)
    assert simulation.readings.foot_force.sum() == pytest.approx(9.81 * TOTAL_MASS * math.cos(angle), rel=0.02)


# --- the task


def test_heights_of_the_task_are_over_the_ground_below():
    task = make_native(6, terrain="hills").task
    task.reset(np.arange(6), list(range(6)))
    simulation, field = task.simulation, task.simulation.height_field
    qpos = np.tile([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, *STANCE], (6, 1))
    qpos[:, :2] = np.random.default_rng(0).uniform(-10.0, 10.0, (6, 2))
    qpos[:, 2] = STANCE_HEIGHT + field.at(qpos)
    simulation.reset(np.arange(6), qpos, np.zeros((6, 14)))
    assert np.ptp(simulation.readings.base_position[:, 2]) > 0.02
    np.testing.assert_allclose(task.context.base_height, STANCE_HEIGHT, atol=1e-9)
    feet = simulation.readings.foot_position
    ground = np.reshape(ray_heights(simulation.model, feet[..., :2].reshape(-1, 2)), (6, 4))
    expected = feet[..., 2] - FOOT_RADIUS - ground
    np.testing.assert_allclose(task.context.sole_height, expected, atol=1e-9)
    np.testing.assert_allclose(task.context.ground_height(feet), field.at(feet))
    assert not make_native(2).task.context.ground_height(feet[:2]).any()


def test_start_is_over_the_highest_ground_below_the_robot():
    config = TaskConfig.from_dict({"randomization": {"start_joint_position": 0.0, "start_tilt": 0.0}})
    for shape in (hills, slope, slope.variant(angle=0.4, direction=1.0)):
        task = Task(BatchSimulation(build_model(terrain=shape), 4), config)
        task.reset(np.arange(4), list(range(4)))
        expected = STANCE_HEIGHT + task.simulation.height_field.highest(np.zeros(2))
        np.testing.assert_allclose(task.simulation.readings.base_position[:, 2], expected)
        assert (task.context.sole_height > -1e-9).all()
        assert (expected > STANCE_HEIGHT + 0.01) == (shape is not hills)


@pytest.mark.parametrize("name", UNEVEN)
def test_single_and_vector_environment_on_a_terrain_are_bit_identical(name):
    kwargs = {"config": ROUGH | {"terrain": {"name": name, "seed": 3}}, "max_episode_steps": 60}
    expected = episodes(make_sync(3, **kwargs), 150)
    for threads in (1, 2):
        assert_same(episodes(make_native(3, num_threads=threads, **kwargs), 150), expected)


def walk(env, steps):
    """Rewards of an env that walks by the scripted gait, from its present state."""
    return [float(env.step(np.zeros(8, np.float32))[1]) for _ in range(steps)]


def test_copied_and_pickled_env_on_a_terrain_continues_identically():
    env = make(action_mode="residual", terrain="hills")
    env.reset(seed=1, options={"command": (0.5, 0.0)})
    walk(env, 150)
    state, copied, pickled = env.unwrapped.get_state(), copy.deepcopy(env), pickle.loads(pickle.dumps(env))  # noqa: S301
    other = make(action_mode="residual", terrain="hills")
    other.reset(seed=5)
    other.unwrapped.set_state(state)
    expected = walk(env, 50)
    task = env.unwrapped.task
    assert np.abs(task.context.ground_height(task.simulation.readings.foot_position)).max() > 0.0
    for again in (copied, pickled, other):
        assert walk(again, 50) == expected
    np.testing.assert_array_equal(pickled.unwrapped.task.context.base_height, task.context.base_height)


def test_env_on_a_terrain_is_made_again_from_its_spec_and_in_workers():
    env = gymnasium.make(ENV_ID, terrain="rough", config={"terrain": {"seed": 2}})
    again = gymnasium.make(gymnasium.envs.registration.EnvSpec.from_json(env.spec.to_json()))
    for one in (env, again):
        assert dict(one.unwrapped.task.config.terrain) == {"name": "rough", "seed": 2, "height": 0.01, "distance": 0.2}
    np.testing.assert_array_equal(again.unwrapped.model.hfield_data, env.unwrapped.model.hfield_data)
    # Not forked: other tests leave threads in this process.
    vector_kwargs = {"context": "spawn"}
    workers = gymnasium.make_vec(
        ENV_ID, num_envs=2, vectorization_mode="async", vector_kwargs=vector_kwargs, terrain="rough"
    )
    try:
        native = make_native(2, terrain="rough")
        np.testing.assert_array_equal(workers.reset(seed=0)[0], native.reset(seed=0)[0])
        action = np.full((2, 8), 0.3, np.float32)
        for _ in range(30):
            np.testing.assert_array_equal(workers.step(action)[0], native.step(action)[0])
    finally:
        workers.close()


def test_sb3_env_and_native_vector_env_share_the_ground():
    pytest.importorskip("stable_baselines3")
    env = make_sb3_vec_env(2, seed=0, terrain="hills")
    native = make_native(2, terrain="hills")
    np.testing.assert_array_equal(env.env.task.simulation.model.hfield_data, native.task.simulation.model.hfield_data)


# --- the config


def test_terrain_of_a_config_is_saved_and_validated():
    config = TaskConfig.from_dict({"terrain": {"name": "hills", "height": np.float32(0.5), "seed": 7}})
    document = json.loads(json.dumps(config.to_dict()))
    assert document["terrain"] == {"name": "hills", "seed": 7, "height": 0.5, "distance": 2.5}
    assert TaskConfig.from_dict(document) == config == pickle.loads(pickle.dumps(config))  # noqa: S301
    assert config.ground == hills.variant(7, height=0.5)
    assert config.on_terrain("hills") == config
    assert config.on_terrain("rough").ground == rough.variant(7)
    assert config.on_terrain("hills", 1).ground == hills.variant(1, height=0.5)
    assert "name='hills'" in repr(config.terrain)
    assert TaskConfig().ground == find_terrain("flat")


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"name": "moon"}, "terrain: 'moon' is unknown; there are flat, rough, hills"),
        ({"name": ["rough"]}, r"terrain: \['rough'\] is unknown"),
        ({"height": 0.1}, "config.terrain: unknown field 'height'; valid fields are name, seed"),
        ({"name": "rough", "height": -1.0}, r"terrain.height must be at least 0 \(m\); found -1.0"),
        ({"seed": -1}, "terrain.seed must be a whole number, 0 or more; found -1"),
        ("rough", "config.terrain: expected a mapping of fields; found 'rough'"),
    ],
)
def test_invalid_terrain_of_a_config_is_refused_with_the_valid_values(values, message):
    with pytest.raises(QuadrupedError, match=message):
        gymnasium.make(ENV_ID, config={"terrain": values})


def test_section_of_one_terrain_does_not_become_another_ones():
    with pytest.raises(QuadrupedError, match=r"terrain.name: this section is for 'rough'; found 'hills'"):
        TerrainConfig(name="rough").replace(name="hills")


OWN = """
import numpy as np
from quadruped_env.task import terrain

@terrain(size=6.0, cell=0.05)
def steps(grid, height: float = 0.02):
    "Steps of 0.5 m."
    return height * (grid.x // 0.5)
"""
STEP = """
import pickle, sys
env = pickle.load(open(sys.argv[1], "rb"))
print(float(env.step([0.1] * 8)[1]).hex())
"""


def test_terrain_of_a_users_file_is_chosen_by_name_and_pickled(tmp_path):
    file = tmp_path / "own.py"
    file.write_text(OWN)
    env = gymnasium.make(ENV_ID, task_file=file, config={"terrain": {"name": "steps", "height": 0.05}})
    env.reset(seed=0)
    field = env.unwrapped.task.simulation.height_field
    assert field.heights.shape == (121, 121)
    assert field.at(np.array([0.75, 0.3])) == pytest.approx(0.05)
    assert gymnasium.make(ENV_ID, task_file=file).unwrapped.model.nhfield == 0
    config = env.unwrapped.task.config
    assert TaskConfig.from_dict(config.to_dict(), load_task_file(file)) == config
    pickled = tmp_path / "env.pickle"
    pickled.write_bytes(pickle.dumps(env))
    expected = float(env.step(np.full(8, 0.1))[1]).hex()
    done = subprocess.run([sys.executable, "-c", STEP, pickled], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == expected
    with pytest.raises(QuadrupedError, match="'steps' is unknown; there are flat, rough, hills"):
        gymnasium.make(ENV_ID, terrain="steps")
