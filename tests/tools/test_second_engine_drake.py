"""The robot in Drake against closed forms and against MuJoCo; skipped without Drake."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest
import twelve_joints
from second_robot import DESIGN

import sim2sim
from quadruped_env import QuadrupedError
from quadruped_env.evaluation.measures import mean_velocities
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.policies import GaitController
from quadruped_env.robot import MINI_QUADRUPED, JointMotor, MotorConfig
from quadruped_env.task import Task, TaskConfig
from second_engine.engines import Drake, MuJoCo

pytest.importorskip("pydrake", reason="Drake is not installed: pip install -r tools/second_engine/requirements.txt")
pytestmark = pytest.mark.slow

ENV = np.zeros(1, dtype=np.intp)
FINE = TaskConfig(physics_timestep=0.0005, decimation=40)
"""Small steps, so that the errors of both integrators are small."""
IN_DRAKE = Drake(max_timestep=0.0005)
OTHER_MOTORS = MotorConfig(
    hip=JointMotor(stall_torque=7.0, kp=30.0, kd=0.6, damping=0.2, friction_loss=0.3, armature=0.02),
    knee=JointMotor(stall_torque=12.0, no_load_speed=8.0, kp=55.0, kd=1.4, friction_loss=0.1, armature=0.005),
    delay=0.0125,
)
CASES = {
    "built-in": FINE,
    "other motors": dataclasses.replace(FINE, motor=OTHER_MOTORS),
    "other robot": FINE.for_robot(DESIGN.robot()),
    "three joints": FINE.for_robot(twelve_joints.ROBOT),
}


def start(robot, height=5.0, seed=0):
    """A random state in the air: qpos (1, 15) and qvel (1, 14) as in MuJoCo."""
    rng = np.random.default_rng(seed)
    quaternion = rng.standard_normal(4)
    position = 0.5 * (robot.stance + rng.uniform(robot.joint_position_low, robot.joint_position_high))
    qpos = np.concatenate([[0.3, -0.2, height], quaternion / np.linalg.norm(quaternion), position])
    return qpos[None], rng.normal(0.0, 1.0, (1, robot.num_velocities))


def both(config, qpos, qvel, there=IN_DRAKE):
    simulations = MuJoCo()(config, 1), there(config, 1)
    for simulation in simulations:
        simulation.reset(ENV, qpos, qvel)
    return simulations


MOTION = (
    "joint_position",
    "joint_velocity",
    "orientation",
    "up_b",
    "base_position",
    "linear_velocity_b",
    "angular_velocity_b",
    "foot_position",
    "foot_velocity",
    "foot_angular_velocity",
)


@pytest.mark.parametrize("name", CASES)
def test_readings_of_motion_are_equal_in_the_same_state(name):
    config = CASES[name]
    for seed in range(5):
        here, there = both(config, *start(config.robot, seed=seed))
        for field in MOTION:
            found, expected = getattr(there.readings, field), getattr(here.readings, field)
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9, err_msg=field)


def test_observations_are_equal_in_the_same_episode_starts():
    config = TaskConfig()
    tasks = [Task(engine(config, 6), config) for engine in (MuJoCo(), Drake())]
    for task in tasks:
        task.reset(np.arange(6), seeds=list(range(6)))
    here, there = (task.observe() for task in tasks)
    assert np.ptp(here, axis=0).max() > 0.5, "the starts differ"
    np.testing.assert_allclose(there, here, rtol=0, atol=1e-6)
    np.testing.assert_array_equal(tasks[0].command, tasks[1].command)


@pytest.mark.parametrize("name", CASES)
def test_robot_in_the_air_follows_steps_of_its_joints_as_in_mujoco(name):
    config = CASES[name]
    robot = config.robot
    qpos, qvel = start(robot)
    here, there = both(config, qpos, qvel)
    rng = np.random.default_rng(1)
    farthest = 0.0
    for _ in range(3):
        target = rng.uniform(robot.joint_position_low + 0.2, robot.joint_position_high - 0.2)[None]
        for _ in range(10):
            before = here.readings.joint_position.copy()
            for simulation in (here, there):
                simulation.step(target, config.decimation)
            farthest = max(farthest, np.abs(here.readings.joint_position - before).max())
            for field, tolerance in (("joint_position", 0.012), ("base_position", 5e-4), ("up_b", 2e-3)):
                found, expected = getattr(there.readings, field), getattr(here.readings, field)
                np.testing.assert_allclose(found, expected, rtol=0, atol=tolerance, err_msg=field)
    assert farthest > 0.05, "the joints move fast"


def momentum(robot):
    """Centre of mass, linear momentum, and angular momentum about the centre of mass of a robot in Drake."""
    centre = robot.plant.CalcCenterOfMassPositionInWorld(robot.context)
    found = robot.plant.CalcSpatialMomentumInWorldAboutPoint(robot.context, centre)
    return centre, found.translational(), found.rotational()


def test_momentum_in_the_air_changes_by_gravity_alone():
    qpos, qvel = start(MINI_QUADRUPED)
    simulation = IN_DRAKE(FINE, 1)
    simulation.reset(ENV, qpos, qvel)
    mass, gravity = MINI_QUADRUPED.total_mass, np.array([0.0, 0.0, -9.81])

    centre, linear, angular = momentum(simulation.robots[0])
    for step in range(1, 26):
        simulation.step(MINI_QUADRUPED.stance[None], FINE.decimation)
        seconds = step * FINE.control_timestep
        fallen, now, turning = momentum(simulation.robots[0])
        np.testing.assert_allclose(now, linear + mass * gravity * seconds, rtol=0, atol=5e-3 * mass)
        expected = centre + linear / mass * seconds + 0.5 * gravity * seconds**2
        np.testing.assert_allclose(fallen, expected, rtol=0, atol=2e-3)
        np.testing.assert_allclose(turning, angular, rtol=0, atol=0.02 * np.linalg.norm(angular))
        assert not simulation.readings.foot_force.any()


def test_standing_robot_presses_with_its_weight_on_its_feet_and_measures_gravity():
    config = TaskConfig()
    simulation = Drake()(config, 1)
    robot = config.robot
    qpos = np.concatenate([[0.0, 0.0, robot.stance_height, 1.0, 0.0, 0.0, 0.0], robot.stance])[None]
    simulation.reset(ENV, qpos, np.zeros((1, robot.num_velocities)))
    for _ in range(100):
        simulation.step(robot.stance[None], config.decimation)
    readings = simulation.readings
    assert readings.foot_force.sum() == pytest.approx(robot.total_mass * 9.81, rel=1e-3)
    assert np.ptp(readings.foot_force) < 0.5
    assert not readings.trunk_force.any()
    np.testing.assert_allclose(readings.linear_acceleration_b[0], [0.0, 0.0, 9.81], atol=0.02)
    assert readings.base_position[0, 2] == pytest.approx(robot.stance_height, abs=1e-3)
    # As on the robot's page.
    np.testing.assert_allclose(np.abs(readings.joint_torque[0, 1::2]), 0.15, atol=0.02)


def test_robot_with_three_joints_per_leg_stands_as_in_mujoco():
    """It sinks by 4 to 5 mm and leans back, so that its hind feet carry more."""
    config = TaskConfig().for_robot(twelve_joints.ROBOT)
    robot = config.robot
    qpos = np.concatenate([[0.0, 0.0, robot.stance_height, 1.0, 0.0, 0.0, 0.0], robot.stance])[None]
    simulations = both(config, qpos, np.zeros((1, robot.num_velocities)), Drake())
    for simulation in simulations:
        for _ in range(100):
            simulation.step(robot.stance[None], config.decimation)
    here, there = (simulation.readings for simulation in simulations)
    assert there.foot_force.sum() == pytest.approx(robot.total_mass * 9.81, rel=1e-3)
    assert not there.trunk_force.any()
    np.testing.assert_allclose(there.foot_force, here.foot_force, atol=0.5)
    # Static friction leaves the forces between the feet open, and so the torques of the sideways joints.
    np.testing.assert_allclose(there.joint_torque[:, 2::3], here.joint_torque[:, 2::3], atol=0.3)
    np.testing.assert_allclose(there.base_position[0, 2], here.base_position[0, 2], atol=2e-3)


def test_trot_with_three_joints_per_leg_moves_as_in_mujoco():
    """Forwards, in a turn, sideways and backwards: alike in both where MuJoCo has small steps and stiff contacts.

    The robot's rotors are light for its gains, and at 5 ms it turns faster by a fifth.
    """
    here = FINE.for_robot(twelve_joints.ROBOT), MuJoCo(cone="elliptic", time_constant=0.001)
    there = TaskConfig().for_robot(twelve_joints.ROBOT), Drake()
    commands = [(0.3, 0.0, 0.0), (0.0, 0.5, 0.0), (0.0, 0.0, 0.15), (-0.2, 0.0, 0.0)]
    found = []
    for config, engine in (here, there):
        rollout = roll_out(GaitController(), commands, [1000], 6.0, config, engine=engine)
        assert not rollout.fallen.any()
        found.append(mean_velocities(rollout))
    asked = [abs(velocities[[0, 1, 2, 3], [0, 1, 2, 0]]) for velocities in found]
    np.testing.assert_allclose(asked, [[0.3, 0.5, 0.15, 0.2]] * 2, rtol=0.25)
    np.testing.assert_allclose(asked[1], asked[0], rtol=0.08)


def on_its_belly():
    """qpos (1, 15) of the built-in robot on its base, with its legs behind it in the air."""
    return np.concatenate([[0.0, 0.0, 0.04, 1.0, 0.0, 0.0, 0.0], np.tile([1.5, 0.0], 4)])[None]


def test_robot_on_its_belly_presses_with_its_trunk_and_is_terminated():
    config = TaskConfig()
    task = Task(Drake()(config, 1), config)
    task.reset(ENV, seeds=[0])
    qpos = on_its_belly()
    task.simulation.reset(ENV, qpos, np.zeros((1, 14)))
    forces = []
    for _ in range(25):
        task.simulation.step(qpos[:, 7:], config.decimation)
        forces.append(task.simulation.readings.trunk_force[0].copy())
    assert 0.5 * 39.2 < np.mean(forces, axis=0)[0] < 1.5 * 39.2, "the base carries the weight"
    assert not np.any(forces, axis=0)[1:].any(), "the hips do not touch"
    assert not task.simulation.readings.foot_force.any()
    # The box rocks on its corners, so that it does not touch the ground at every step.
    holding = SimpleNamespace(act=lambda observation, control: qpos[:, 7:])
    assert any(task.act(holding, task.observe()).terminated[0] for _ in range(25))


def test_sliding_body_decelerates_by_friction():
    config = TaskConfig()
    mu, mass = 0.3, config.robot.total_mass
    simulation = Drake(friction=mu)(config, 1)
    qpos, qvel = on_its_belly(), np.zeros((1, config.robot.num_velocities))
    qvel[0, 0] = 3.0
    simulation.reset(ENV, qpos, qvel)
    for _ in range(25):
        simulation.step(qpos[:, 7:], config.decimation)
    _, linear, _ = momentum(simulation.robots[0])
    assert linear[0] == pytest.approx(mass * (3.0 - mu * 9.81 * 0.5), rel=0.05)


@pytest.mark.parametrize("approximation", ["sap", "lagged", "similar"])
def test_sliding_feet_brake_the_robot_by_friction(approximation):
    config = TaskConfig()
    robot, mu = config.robot, 0.1
    simulation = Drake(approximation, friction=mu)(config, 1)
    qpos = np.concatenate([[0.0, 0.0, robot.stance_height, 1.0, 0.0, 0.0, 0.0], robot.stance])[None]
    simulation.reset(ENV, qpos, np.zeros((1, robot.num_velocities)))
    for _ in range(25):
        simulation.step(robot.stance[None], config.decimation)
    simulation.push(ENV, np.array([[1.0, 0.0, 0.0]]))
    for _ in range(20):
        simulation.step(robot.stance[None], config.decimation)
    lost = robot.total_mass * 1.0 - momentum(simulation.robots[0])[1][0]
    assert lost == pytest.approx(mu * robot.total_mass * 9.81 * 20 * config.control_timestep, rel=0.05)


def test_push_adds_its_velocity_and_a_force_accelerates_the_robot():
    config = TaskConfig()
    simulation = Drake()(config, 2)
    qpos, _ = start(config.robot)
    qpos[0, 3:7] = 1.0, 0.0, 0.0, 0.0
    simulation.reset(np.arange(2), np.tile(qpos, (2, 1)), np.zeros((2, 14)))
    simulation.push(np.array([1]), np.array([[0.5, -0.2, 0.1]]))
    _, linear, _ = momentum(simulation.robots[1])
    np.testing.assert_allclose(linear / config.robot.total_mass, [0.5, -0.2, 0.1], atol=1e-9)
    simulation.set_force(np.array([0]), np.array([[8.0, 0.0, 0.0]]))
    for _ in range(10):
        simulation.step(qpos[:, 7:].repeat(2, axis=0), config.decimation)
    assert momentum(simulation.robots[0])[1][0] == pytest.approx(8.0 * 0.2, rel=0.01)
    assert momentum(simulation.robots[1])[1][0] == pytest.approx(4.0 * 0.5, rel=0.01)


def test_robot_whose_solver_fails_is_terminated_and_the_others_go_on(monkeypatch):
    config = TaskConfig()
    task = Task(Drake()(config, 2), config)
    task.reset(np.arange(2), seeds=[0, 1])

    def fail(torque, friction=None):
        raise RuntimeError("the solver has not converged")

    monkeypatch.setattr(task.simulation.robots[0], "step", fail)
    for _ in range(2):
        transition = task.step(np.zeros((2, 8)))
        np.testing.assert_array_equal(transition.diverged, [True, False])
        np.testing.assert_array_equal(transition.terminated, [True, False])
    task.reset(np.array([0]), seeds=[0])
    assert not task.step(np.zeros((2, 8))).terminated.any()


def test_ground_randomization_and_states_that_drake_does_not_have_are_errors():
    with pytest.raises(QuadrupedError, match=r"terrain 'steps'.*on_terrain"):
        Drake()(TaskConfig().on_terrain("steps"), 1)
    config = TaskConfig().randomized("moderate")
    with pytest.raises(QuadrupedError, match=r"does not reach the robot in Drake.*randomized\('none'\)"):
        Task(Drake()(config, 1), config)
    with pytest.raises(QuadrupedError, match="states"):
        Drake()(TaskConfig(), 1).get_state(0)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("<transmission", "<other", "no actuator for the joint 'LF_hip_joint'.*<transmission>"),
        ("LF_knee_joint", "knee", "no joint 'LF_knee_joint'.*<joint>"),
        ("LF_leg", "shank", "no link 'LF_leg'.*<link>"),
        ('type="revolute"', 'type="odd"', "Drake cannot read its URDF"),
    ],
)
def test_urdf_that_is_not_the_robots_is_an_error_that_names_the_part(old, new, message):
    urdf = MINI_QUADRUPED.urdf.replace(old, new).replace(
        "</transmission", "</other" if "other" in new else "</transmission"
    )
    robot = dataclasses.replace(MINI_QUADRUPED, urdf=urdf)
    with pytest.raises(QuadrupedError, match=message):
        Drake()(TaskConfig().for_robot(robot), 1)


def test_program_runs_both_engines_and_the_shipped_policy_walks_in_drake(capsys):
    assert sim2sim.main(["flat", "--seeds", "1", "--seconds", "3", "--command", "0.3", "0", "--command", "0", "0"]) == 0
    printed = capsys.readouterr().out
    rows = [line.split() for line in printed.split("Scripted gait")[0].splitlines()]
    walking, standing = ([float(cell) for cell in row[2:4]] for row in rows if row[:1] in (["0.3,"], ["0,"]))
    assert walking == pytest.approx([0.30, 0.30], abs=0.05), "it walks in Drake"
    assert standing == pytest.approx([0.0, 0.0], abs=0.01), "it stands"
    assert "Falls in 2 episodes: 0 in MuJoCo, 0 in Drake." in printed


@pytest.mark.parametrize(
    ("arguments", "message"),
    [(["--friction", "-1"], "friction must be 0 or more"), (["--command", "nan", "0"], "command: expected")],
)
def test_program_with_bad_input_is_an_error(arguments, message, capsys):
    assert sim2sim.main(["flat", *arguments]) == 2
    assert message in capsys.readouterr().err
