"""Uneven ground in evaluation, pictures, viewer, live nodes and programs: the same as in the env."""

import argparse
import dataclasses
import hashlib
import json

import numpy as np
import pytest
from built_in import STANCE_HEIGHT
from viewing import robot

from quadruped_env import QuadrupedError
from quadruped_env.cli.common_options import add_evaluation_options, named_terrain
from quadruped_env.cli.main import main
from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.recorded_episode import record
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.evaluation.trace import Trace
from quadruped_env.live.__main__ import make_parser
from quadruped_env.live.node_options import chosen_terrain, robot_of
from quadruped_env.live.simulated import SimulatedRobot
from quadruped_env.policies import GaitController, ZeroController, find_controllers, load_policy
from quadruped_env.report.films.film import Camera, size_of
from quadruped_env.report.ground_mesh import ground_mesh
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import build_model, find_terrain
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.task import TaskConfig, load_task_file, terrain
from quadruped_env.viewer import ViewController
from quadruped_env.viewer.viewed_robot import LANE

HILLS = TaskConfig().on_terrain("hills", 2)
FIELD = HeightField.of(build_model(terrain=HILLS.ground))


STEPS = """
from quadruped_env.task import terrain

@terrain(size=8.0)
def ridges(grid, height: float = 0.02):
    return height * (grid.x // 0.4 % 2)
"""


@terrain(size=10.0)
def ramp(grid):
    """Slope of 0.1 along x."""
    return 0.1 * grid.x


def test_rollout_on_a_terrain_measures_clearance_over_it():
    config = TaskConfig.from_dict({"terrain": {"name": "hills", "seed": 2}, "action": {"mode": "residual"}})
    rollout = roll_out(GaitController(), [(0.3, 0.0)], [1, 2], 6.0, config, physics=True)
    assert rollout.terrain == HILLS.ground == rollout.select([1]).terrain
    assert not rollout.fallen.any()
    on_ground = rollout.physics.height[-200:][rollout.physics.force[-200:] > 1.0]
    assert np.abs(on_ground).max() < 0.01
    ground = FIELD.at(rollout.base_position[-50:].astype(float))
    assert ground.max() > 0.03, "the robot has left the level ground of the start"
    np.testing.assert_allclose(rollout.base_position[-50:, :, 2] - ground, STANCE_HEIGHT, atol=0.02)


def test_recording_on_a_terrain_starts_over_the_highest_ground():
    config = TaskConfig()
    flat = record(ZeroController(), 0.1, config=config)
    hills = record(ZeroController(), 0.1, config=HILLS)
    assert flat.base_pose[0, 2] == STANCE_HEIGHT
    assert hills.base_pose[0, 2] == pytest.approx(STANCE_HEIGHT + FIELD.highest(np.zeros(2), MINI_QUADRUPED.footprint))
    assert hills.terrain == HILLS.ground


def test_comparison_on_a_terrain_puts_all_controllers_on_it():
    comparison = compare(load_policy("flat"), 1, 2.0, [(0.4, 0.0)], terrain="rough")
    assert {rollout.terrain for rollout in comparison.rollouts.values()} == {find_terrain("rough")}
    assert comparison.config.terrain.name == "rough"
    with pytest.raises(QuadrupedError, match="terrain: 'swamp' is unknown; there are flat, rough, hills"):
        compare(load_policy("flat"), 1, 2.0, [(0.4, 0.0)], terrain="swamp")


def test_built_in_policy_is_compared_on_a_terrain_of_a_file(tmp_path):
    file = tmp_path / "my_terrain.py"
    file.write_text(STEPS)
    arguments = ["evaluate", "flat", "--task", str(file), "--terrain", "ridges"]
    parser = argparse.ArgumentParser()
    add_evaluation_options(parser, "")
    ridges = named_terrain(parser.parse_args(arguments[2:]))
    assert ridges == find_terrain("ridges", load_task_file(file).terrains)
    comparison = compare(find_policy("flat", None, file).policy, 1, 2.0, [(0.4, 0.0)], terrain=ridges)
    assert {rollout.terrain for rollout in comparison.rollouts.values()} == {ridges}
    assert comparison.config.terrain.name == "ridges"
    assert comparison.config.to_dict()["terrain_file"] == load_task_file(file).file.to_dict()
    arguments[-1] = "swamp"
    with pytest.raises(QuadrupedError, match=r"terrain: 'swamp' is unknown; there are flat, rough, .*, ridges$"):
        named_terrain(parser.parse_args(arguments[2:]))


def test_policy_that_was_trained_with_a_curriculum_is_compared_on_random_tiles():
    policy = load_policy("flat")
    on_tiles = policy.config.on_terrain("tiles")
    curriculum = dataclasses.replace(on_tiles, terrain=on_tiles.terrain.replace(curriculum=True, levels=3))
    trained = policy.for_task(policy.weights, policy.biases, policy.activation, curriculum, policy.card)
    comparison = compare(trained, 6, 2.0, [(0.4, 0.0)])
    assert comparison.config.terrain.to_dict() == curriculum.terrain.to_dict() | {"curriculum": False}
    starts = {name: rollout.base_position[0, :, :2] for name, rollout in comparison.rollouts.items()}
    centres = curriculum.ground.centres().reshape(-1, 2)
    nearest = {name: np.abs(centres[:, None] - start).max(-1).argmin(0) for name, start in starts.items()}
    assert len(set(nearest["policy"])) > 3
    for name, start in starts.items():
        np.testing.assert_array_equal(nearest[name], nearest["policy"], err_msg="the seed gives the tile")
        np.testing.assert_allclose(start, centres[nearest[name]], atol=0.05)


# --- pictures


def test_camera_shows_the_ground_of_each_clip(opengl):
    high = find_terrain("hills").variant(2, height=0.5)
    pose = np.array([[3.0, 1.0, STANCE_HEIGHT, 1.0, 0.0, 0.0, 0.0]])
    raised = pose.copy()
    raised[:, 2] += FIELD.at(pose) * 0.5 / 0.08
    joints = np.tile([0.6, -0.72], (1, 4))
    on_level = Trace(robot=MINI_QUADRUPED, timestep=0.02, base_pose=pose, joint_position=joints)
    on_hill = dataclasses.replace(on_level, base_pose=raised, terrain=high)
    with Camera(MINI_QUADRUPED) as camera:
        level = camera.picture(on_level, 0)
        uneven = camera.picture(on_hill, 0)
        again = camera.picture(on_level, 0)
    np.testing.assert_array_equal(again, level)
    assert not np.array_equal(uneven, level)
    # The camera rises with the ground, by 0.2 m here, so that the robot stays where it was in the picture.
    assert raised[0, 2] > STANCE_HEIGHT + 0.15
    np.testing.assert_allclose(hips(uneven), hips(level), atol=3.0)


def hips(picture):
    """Row and column of the middle of the hips: nothing else in the scene is that blue."""
    red, green, blue = np.moveaxis(picture.astype(int), -1, 0)
    return np.argwhere((blue > 1.8 * red) & (blue > 1.8 * green)).mean(axis=0)


def test_ground_mesh_is_the_height_field_and_faces_up():
    pytest.importorskip("trimesh")
    around = np.array([[1.0, 2.0], [3.0, -1.0]])
    part, whole = ground_mesh(FIELD, around, margin=1.0), ground_mesh(FIELD)
    for mesh in (part, whole):
        np.testing.assert_allclose(mesh.vertices[:, 2], FIELD.at(np.array(mesh.vertices)), atol=1e-9)
        assert (mesh.face_normals[:, 2] > 0.5).all()
        middles = np.array(mesh.triangles_center)
        np.testing.assert_allclose(middles[:, 2], FIELD.at(middles), atol=1e-9)
    np.testing.assert_allclose(part.bounds[:, :2], [[0.0, -2.0], [4.0, 3.0]], atol=0.1)
    np.testing.assert_allclose(whole.bounds[:, :2], [[-20.0, -20.0], [20.0, 20.0]])


# --- the viewer


def test_viewer_shows_a_level_and_the_tiles_of_a_policy(tmp_path, monkeypatch):
    sources, _ = find_controllers(runs=tmp_path)
    stairs = find_terrain("stairs").variant(level=4)
    controller = ViewController(sources, ["policy flat"], tmp_path / "results", terrain=stairs)
    assert robot(controller, 0).terrain == stairs
    np.testing.assert_array_equal(controller.model().hfield_data, build_model(terrain=stairs).hfield_data)
    controller.close()
    on_tiles = TaskConfig().on_terrain("tiles")
    monkeypatch.setattr("quadruped_env.viewer.viewed_robot.task_of", lambda *_: on_tiles)
    controller = ViewController(sources, ["policy flat"], tmp_path / "results")
    controller.set_source(1, "stand still")
    places = [robot(controller, i).data.qpos[:2].copy() for i in range(2)]
    np.testing.assert_allclose(places[1] - places[0], [0.0, LANE * size_of(MINI_QUADRUPED)])
    assert np.abs(on_tiles.ground.centres() - places[0]).max(-1).min() < 1e-9
    controller.close()
    # On other ground a robot does not start where one of its tiles would be.
    controller = ViewController(sources, ["policy flat"], tmp_path / "results", terrain=HILLS.ground)
    np.testing.assert_array_equal(robot(controller, 0).data.qpos[:2], [0.0, 0.0])
    controller.close()


def test_viewer_without_a_named_terrain_takes_that_of_the_first_robots_task(tmp_path, monkeypatch):
    monkeypatch.setattr("quadruped_env.viewer.viewed_robot.task_of", lambda *_: HILLS)
    sources, _ = find_controllers(runs=tmp_path)
    controller = ViewController(sources, ["policy flat"], tmp_path / "results")
    monkeypatch.setattr("quadruped_env.viewer.viewed_robot.task_of", lambda *_: TaskConfig())
    controller.set_source(1, "stand still")
    assert {robot(controller, i).terrain for i in range(2)} == {HILLS.ground}
    controller.close()


# --- live nodes and programs


def test_live_nodes_take_the_terrain_of_a_file(tmp_path, capsys):
    file = tmp_path / "my_terrain.py"
    file.write_text(STEPS)
    typed = ["sim", "--task", str(file), "--terrain", "ridges", "--seed", "3"]
    arguments = make_parser(only="sim").parse_args(typed)
    ridges = find_terrain("ridges", load_task_file(file).terrains)
    assert chosen_terrain(arguments) == ridges.variant(3)
    simulated = SimulatedRobot(3, chosen_terrain(arguments), robot_of(arguments))
    expected = HeightField.of(build_model(terrain=ridges)).highest(np.zeros(2), MINI_QUADRUPED.footprint)
    assert simulated.state.base_position[0, 2] == pytest.approx(STANCE_HEIGHT + expected)
    assert main(["live", "walk", "--task", str(file), "--terrain", "swamp"]) == 2
    assert (
        "terrain: 'swamp' is unknown; there are flat, rough, hills, slope, steps, stairs, gaps, wave, tiles, ridges"
        in capsys.readouterr().err
    )


@pytest.mark.parametrize("name", ["steps", "stairs", "gaps", "tiles"])
def test_simulated_robot_stands_on_a_terrain_with_edges(name):
    shape = find_terrain(name)
    simulated = SimulatedRobot(1, shape if shape.hardest is None else shape.variant(level=10))
    for _ in range(200):
        simulated.step()
    assert simulated.state.base_position[0, 2] == pytest.approx(STANCE_HEIGHT, abs=3e-3)
    assert simulated.state.up_b[0, 2] > 0.9999


def test_simulated_robot_starts_and_is_picked_up_over_the_highest_ground():
    simulated = SimulatedRobot(3, ramp)
    field, footprint = HeightField.of(build_model(terrain=ramp)), MINI_QUADRUPED.footprint
    assert simulated.state.base_position[0, 2] == pytest.approx(STANCE_HEIGHT + field.highest(np.zeros(2), footprint))
    for _ in range(200):
        simulated.step()
    simulated.push(np.array([2.0, 0.0, 1.0]))
    for _ in range(200):
        simulated.step()
    place = simulated.state.base_position[0, :2].copy()
    simulated.pick_up()
    assert simulated.state.base_position[0, 2] == pytest.approx(STANCE_HEIGHT + field.highest(place, footprint))


def test_baseline_and_replay_take_the_terrain_of_a_file(tmp_path):
    file = tmp_path / "my_terrain.py"
    file.write_text(STEPS)
    ground = ["--task", str(file), "--terrain", "ridges"]
    tiny = ["baseline", *ground, "--seconds", "0.5", "--episodes", "1"]
    assert main([*tiny, "-o", str(tmp_path / "walk.csv")]) == 0
    assert main([*tiny, "--commands", "-o", str(tmp_path / "commands.csv")]) == 0
    origin = {"name": "my_terrain.py", "sha256": hashlib.sha256(STEPS.encode()).hexdigest()}
    replayed = tmp_path / "replay"
    assert main(["replay", str(tmp_path / "commands.csv"), *ground, "-o", str(replayed)]) == 0
    assert (replayed / "joint_states.csv").read_bytes() == (tmp_path / "walk.csv").read_bytes()
    motion = json.loads((replayed / "tracking.json").read_text())["motion"]
    assert (motion["terrain"], motion["terrain_file"]) == ("ridges", origin)
