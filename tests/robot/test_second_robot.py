"""The whole path on another robot: kinematics, environments, gait, training, policies, live topics."""

import dataclasses
import json
import math
import pickle
import warnings

import gymnasium
import numpy as np
import pytest
import second_robot
import twelve_joints
from environments import assert_same, episodes, make, make_native, make_sync
from gymnasium.envs.registration import EnvSpec
from gymnasium.utils.env_checker import check_env
from live_bench import Loop
from paths import TESTS
from second_robot import DESIGN, ROBOT
from trainings import train
from waiting import wait_until

from quadruped_env import CommandedGait, QuadrupedError, SinusoidalGait
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.live_controller import LiveController
from quadruped_env.control.stand_up import StandUp
from quadruped_env.control.task_file import load_terms
from quadruped_env.policies import GaitController, PolicyController, load_policy
from quadruped_env.policies.files import read_policy
from quadruped_env.robot import MINI_QUADRUPED, QuadrupedDesign
from quadruped_env.robot.corners import corners
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model
from quadruped_env.task import BUILT_IN, Task, TaskConfig, load_task_file

FILE = TESTS / "helpers" / "second_robot.py"
CONFIG = TaskConfig().for_robot(ROBOT)


def walk(controller, commands, seconds=6.0):
    """Mean forward velocity, yaw rate and upright axis (K, 3) of a controller after two seconds."""
    simulation = BatchSimulation(build_model(robot=ROBOT), len(commands), 1, ROBOT)
    task = Task(simulation, CONFIG)
    everywhere = np.arange(len(commands))
    task.reset(everywhere, seeds=everywhere.tolist())
    for env_id, command in enumerate(commands):
        task.set_command(np.array([env_id]), command)
    found = []
    observation = task.observe()
    for _ in range(round(seconds / CONFIG.control_timestep)):
        observation = task.act(controller, observation).observation
        readings = simulation.readings
        found.append(
            np.stack([readings.linear_velocity_b[:, 0], readings.angular_velocity_b[:, 2], readings.up_b[:, 2]])
        )
    return np.mean(found[100:], axis=0).T


class TestModel:
    @pytest.mark.parametrize("kind", ["hinge", "slide"])
    def test_jacobian_is_the_derivative_of_the_feet(self, kind):
        knee = '<joint name="LF_knee_joint" '
        robot = dataclasses.replace(
            ROBOT,
            mjcf=ROBOT.mjcf.replace(knee, f'{knee}type="{kind}" '),
            **dict.fromkeys(("foot_radius", "stance_height")),
        )
        positions, step = np.add(robot.stance, [[0.1], [-0.2]]), 1e-6
        jacobian = robot.skeleton.foot_jacobians(positions)
        for joint in range(8):
            change = np.zeros(8)
            change[joint] = step
            ends = [robot.skeleton.foot_centres(positions + sign * change) for sign in (1, -1)]
            np.testing.assert_allclose(jacobian[..., joint], (ends[0] - ends[1]) / (2 * step), atol=1e-9)

    def test_masses_and_stance(self):
        assert ROBOT.total_mass == pytest.approx(3.0 + 4 * 0.6, rel=1e-12)
        height = 0.05 * math.cos(0.7) + 0.175 * math.cos(0.185) + 0.025
        assert ROBOT.stance_height == pytest.approx(height, abs=1e-7)
        np.testing.assert_allclose(ROBOT.skeleton.resting_pose(ROBOT.stance)[2], height, atol=1e-6)

    @pytest.mark.parametrize("robot", [MINI_QUADRUPED, ROBOT], ids=lambda robot: robot.name)
    def test_feet_are_within_the_footprint_also_near_the_stance(self, robot):
        near = robot.stance + np.random.default_rng(0).uniform(-0.1, 0.1, (1000, robot.num_joints))
        reach = np.linalg.norm(robot.skeleton.foot_centres(near)[..., :2], axis=-1) + robot.foot_radius
        assert 0.9 * robot.footprint < reach.max() < robot.footprint

    def test_urdf_is_the_same_robot(self, tmp_path):
        import yourdfpy

        (tmp_path / "tall.urdf").write_text(ROBOT.urdf)
        urdf = yourdfpy.URDF.load(str(tmp_path / "tall.urdf"), load_meshes=False)
        assert tuple(urdf.actuated_joint_names) == ROBOT.joint_names
        positions = ROBOT.stance + 0.2
        poses = ROBOT.forward_kinematics(positions)
        urdf.update_cfg(positions)
        for link in ROBOT.link_names:
            np.testing.assert_allclose(urdf.get_transform(link, "base_link")[:3, 3], poses[link][0], atol=1e-12)
            assert urdf.link_map[link].inertial.mass == pytest.approx(float(ROBOT.skeleton.model.body(link).mass[0]))


class TestEnv:
    @pytest.mark.parametrize("mode", ["position", "residual"])
    def test_env_passes_gymnasiums_check(self, mode):
        env = make(robot=ROBOT, action_mode=mode)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # its advice on spaces
            check_env(env.unwrapped, skip_render_check=True)
        assert env.unwrapped.model.body("base_link").mass == 3.0
        assert env.unwrapped.task.config.motor == ROBOT.motors

    @pytest.mark.parametrize("mode", ["position", "residual"])
    def test_single_and_vector_are_bit_identical(self, mode):
        kwargs = {
            "robot": ROBOT,
            "action_mode": mode,
            "config": {"randomization": {"payload": [-0.5, 1.0], "push_velocity": 1.0, "observation_noise": 1.0}},
        }
        native, sync = make_native(4, max_episode_steps=40, **kwargs), make_sync(4, max_episode_steps=40, **kwargs)
        for one, other in zip(episodes(native, 120), episodes(sync, 120), strict=True):
            assert_same(one[0], other[0])
            assert_same(one[1:-1], other[1:-1])

    def test_spec_holds_the_robot_as_json_and_pickle(self):
        for env in (make(robot=DESIGN), make(config=CONFIG), make(task_file=FILE)):
            assert env.unwrapped.task.config.robot == ROBOT
            again = gymnasium.make(EnvSpec.from_json(env.spec.to_json()))
            assert again.unwrapped.task.config.robot == ROBOT
            copied = pickle.loads(pickle.dumps(env.unwrapped))  # noqa: S301
            assert copied.task.config.robot == ROBOT
            observation = env.reset(seed=3)[0]
            assert_same(copied.reset(seed=3)[0], observation)
            assert_same(again.reset(seed=3)[0], observation)

    def test_partial_motor_config_starts_from_the_robots_motors(self):
        motor = make(robot=ROBOT, config={"motor": {"hip": {"kp": 50.0}}}).unwrapped.task.config.motor
        assert (motor.hip.kp, motor.hip.stall_torque, motor.knee) == (50.0, 14.0, ROBOT.motors.knee)
        assert TaskConfig(motor=motor).for_robot(ROBOT).motor == motor

    @pytest.mark.parametrize("robot", ["tall", 3, {"name": "tall"}])
    def test_no_robot_is_refused(self, robot):
        with pytest.raises(QuadrupedError, match="robot: expected"):
            make(robot=robot)

    def test_config_of_another_robot_is_refused(self):
        values = CONFIG.to_dict()
        assert json.loads(json.dumps(values))["robot"] == {"name": "tall", "sha256": ROBOT.sha256}
        assert TaskConfig.from_dict(values, BUILT_IN.with_robot(ROBOT)) == CONFIG
        with pytest.raises(QuadrupedError, match=r"made for the robot 'tall' .* the robot here is Robot\('mini_quad"):
            TaskConfig.from_dict(values)
        heavier = QuadrupedDesign(**{**vars(DESIGN), "base_mass": 3.5}).robot()
        with pytest.raises(QuadrupedError, match="another version of the robot 'tall'"):
            TaskConfig.from_dict(values, BUILT_IN.with_robot(heavier))

    def test_simulation_of_another_robot_is_refused(self):
        simulation = SingleSimulation(build_model(robot=ROBOT), ROBOT)
        with pytest.raises(QuadrupedError, match=r"it is for Robot\('mini_quadruped'.* simulation of Robot\('tall'"):
            Task(simulation, TaskConfig())
        with pytest.raises(QuadrupedError, match="must follow the one before it in the model"):
            SingleSimulation(build_model(robot=ROBOT), MINI_QUADRUPED)


class TestGait:
    def test_corners_and_phases_follow_the_legs(self):
        assert corners(ROBOT) == (3, 0, 2, 1)
        trot = ControlInterface(ROBOT, CONFIG.control).leg_clock()
        article, published = SinusoidalGait.preset("article"), SinusoidalGait.preset("article", ROBOT)
        assert published.phases == (4.71, 5.21, 0.0, 0.5, 1.57, 2.07, 3.14, 3.64)
        assert published.hip_amplitude == (article.hip_amplitude,) * 4
        np.testing.assert_allclose(trot, 0.0, atol=1e-12)  # all phases are 0 or half a cycle

    def test_commanded_gait_at_a_command_is_the_commanded_gait(self):
        gait, t, command = CommandedGait.preset("tuned", ROBOT), np.linspace(0.0, 1.0, 30), (0.3, 0.4)
        np.testing.assert_allclose(
            gait.at(command).positions(t),
            gait.positions(gait.angular_frequency * t, np.tile(command, (30, 1))),
            atol=1e-12,
        )

    def test_gait_turning_the_other_way_swaps_left_and_right(self):
        gait = CommandedGait.preset("tuned", ROBOT)
        for speed, rate in ((0.0, 0.5), (0.3, 0.2), (-0.2, 0.8)):
            left, right = (gait.waves(np.array([[speed, sign * rate]])) for sign in (1.0, -1.0))
            for one, other in zip(left, right, strict=True):
                np.testing.assert_allclose(one[:, ROBOT.joint_mirror], other, atol=1e-12)
            assert abs(left[0] - right[0]).max() > 0.01

    def test_tuned_gait_walks_and_turns_as_commanded(self):
        turns = [(0.0, 0.5)] * 3 + [(0.0, -0.5)] * 3
        found = walk(
            GaitController(CommandedGait.preset("tuned", ROBOT)), [(0.3, 0.0), (0.0, 0.0), *[(-0.2, 0.0)] * 3, *turns]
        )
        assert found[:, 2].min() > 0.9  # upright, though one start in three leads a turn astray
        forward = found[:, 0]
        assert 0.22 < forward[0] < 0.4
        assert -0.23 < np.median(forward[2:5]) < -0.13
        np.testing.assert_allclose(found[1, :2], 0.0, atol=0.02)
        assert 0.2 < np.median(found[5:8, 1]) < 0.65
        assert -0.65 < np.median(found[8:, 1]) < -0.2

    def test_straight_legs_are_refused(self):
        straight = QuadrupedDesign(name="straight", knee_range=(-1.0, 1.0), stance_angles=(0.0, 0.0)).robot()
        with pytest.raises(QuadrupedError, match="leg LF of 'straight' can lift its foot by 0 mm"):
            CommandedGait.preset("tuned", straight)
        make(robot=straight).reset(seed=0)  # position mode needs no gait


class TestLive:
    def test_stand_up_keeps_to_the_limits_and_ends_in_the_stance(self):
        plan = StandUp.plan(ROBOT, np.array([1.3, -0.1] * 4), 1.5, 1.0)
        assert (plan.points >= ROBOT.joint_position_low).all()
        assert (plan.points <= ROBOT.joint_position_high).all()
        np.testing.assert_allclose(plan.positions(plan.duration), ROBOT.stance, rtol=0, atol=1e-12)

    def test_live_controller_walks_the_simulated_robot(self):
        loop = Loop("crouched", robot=ROBOT)
        loop.run(4.0)
        speeds, upright = loop.run(4.0, (0.3, 0.0))
        assert upright.min() > 0.95
        assert 0.15 < speeds[-400:].mean() < 0.45

    @pytest.mark.slow
    @pytest.mark.parametrize("module", [second_robot, twelve_joints], ids=lambda module: module.ROBOT.name)
    def test_nodes_take_the_robot_from_a_file(self, module, start, nodes):
        from quadruped_env.live.messages.joint_messages import JointReader
        from quadruped_env.live.middleware.topics import CMD_VEL, JOINT_STATES, ODOMETRY, ROBOT_DESCRIPTION
        from quadruped_env.ros import Qos, cdr

        node = nodes()
        robot = module.ROBOT
        states = node.subscribe(JOINT_STATES, Qos(1000), read=JointReader(robot))
        described = node.subscribe(ROBOT_DESCRIPTION)
        odometry, ask = node.subscribe(ODOMETRY, Qos(1000)), node.publish(CMD_VEL)
        for arguments in (("sim",), ("state",), ("controller", "tuned")):
            start(*arguments, "--task", module.__file__)
        texts, speeds = [], []

        def walks():
            ask.send(cdr.message(CMD_VEL.type_name, linear={"x": 0.3}))
            texts.extend(described.decode(one).data for one in described.take())
            speeds.extend(odometry.decode(one).twist.twist.linear.x for one in odometry.take())
            return len(speeds) > 100 and np.mean(speeds[-100:]) > 0.15

        wait_until(walks, "walking", interval=0.05)
        wait_until(lambda: texts or texts.extend(described.decode(one).data for one in described.take()), "description")
        assert texts[0] == robot.description
        assert states.newest(pytest.fail)[1].positions.shape == (robot.num_joints,)


class TestTaskFile:
    def test_file_gives_the_robot_to_tasks_and_to_controllers(self):
        assert load_task_file(FILE).robot == load_terms(FILE).robot == ROBOT

    def test_two_robots_in_a_file_are_refused(self, tmp_path):
        file = tmp_path / "two.py"
        file.write_text(f"{FILE.read_text()}\nOTHER = QuadrupedDesign(name='other')\n")
        with pytest.raises(QuadrupedError, match="defines the robots 'tall' and 'other'"):
            load_task_file(file)

    def test_the_built_in_robot_may_be_imported(self, tmp_path):
        file = tmp_path / "both.py"
        file.write_text(f"from quadruped_env.robot import MINI_QUADRUPED\n{FILE.read_text()}")
        assert load_task_file(file).robot == ROBOT


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """A training of five seconds on the second robot."""
    return train(tmp_path_factory.mktemp("runs"), "--seconds", "5", "--task", FILE)


@pytest.mark.slow
class TestTraining:
    def test_policy_names_its_robot_and_runs_on_it(self, run):
        document = json.loads((run / "policy.json").read_text())
        assert document["robot"] == {"name": "tall", "sha256": ROBOT.sha256}
        policy = load_policy(run, FILE)
        assert policy.robot == ROBOT
        env = policy.make_env()
        assert env.unwrapped.task.config.robot == ROBOT
        observation, _ = env.reset(seed=0)
        for _ in range(50):
            observation, reward, *_ = env.step(policy.predict(observation))
            assert np.isfinite(reward)

    def test_policy_is_refused_on_another_robot(self, run, tmp_path):
        with pytest.raises(QuadrupedError, match=r"second_robot.py', which is not executed automatically"):
            load_policy(run)
        policy = load_policy(run, FILE)
        with pytest.raises(QuadrupedError, match="made for the robot 'tall'"):
            policy.check_env(gymnasium.make("MiniQuadruped-v0", action_mode=policy.action_mode))
        with pytest.raises(QuadrupedError, match="made for the robot 'tall'"):
            LiveController(PolicyController(policy), robot=MINI_QUADRUPED)
        with pytest.raises(QuadrupedError, match="made for the robot 'mini_quadruped'"):
            load_policy("flat", FILE)
        with pytest.raises(QuadrupedError, match="made for the robot 'mini_quadruped'"):
            load_policy("flat", robot=ROBOT)

    def test_run_is_resumed_with_its_file(self, run):
        resumed = train(run.parent, "--resume", run, "--timesteps", "2048", "--task", FILE)
        assert load_policy(resumed, FILE).robot == ROBOT

    def test_live_controller_runs_the_policy(self, run):
        policy = read_policy(run, load_terms(FILE))
        loop = Loop(controller=lambda: PolicyController(policy), robot=ROBOT)
        _, upright = loop.run(4.0)
        assert upright.min() > 0.9
