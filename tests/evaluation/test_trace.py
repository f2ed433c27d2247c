"""Traces of a robot, against hand-made arrays: views, joint states, shapes, and the recorder."""

import dataclasses

import numpy as np
import pytest
from tasks import random_readings

from quadruped_env import JOINT_NAMES, QuadrupedError
from quadruped_env.evaluation.trace import Recorder, Trace
from quadruped_env.robot import MINI_QUADRUPED

STEPS, ENVS, JOINTS, LEGS, TERMS = 5, 3, 8, 4, 2


@dataclasses.dataclass(frozen=True, kw_only=True, eq=False)
class Scored(Trace):
    """A trace with two quantities of its own, and one that is always known."""

    velocity: np.ndarray = dataclasses.field()
    valid: np.ndarray
    scores: np.ndarray
    """(T, N, K)"""
    label: str = ""


def numbers(*shape):
    """Different numbers of a shape: the place of each in the array."""
    return np.arange(np.prod(shape), dtype=np.float64).reshape(shape)


def samples(trace):
    """Single samples of a trace of one env, as they come from a robot."""
    arrays = trace.quantities().items()
    return [
        dataclasses.replace(trace, **{name: np.array(array[i]) for name, array in arrays}) for i in range(len(trace))
    ]


@pytest.fixture
def trace():
    return Scored(
        robot=MINI_QUADRUPED,
        timestep=0.02,
        base_pose=numbers(STEPS, ENVS, 7),
        joint_position=numbers(STEPS, ENVS, JOINTS),
        joint_velocity=-numbers(STEPS, ENVS, JOINTS),
        velocity=numbers(STEPS, ENVS, 2),
        contact=numbers(STEPS, ENVS, LEGS) % 2 == 0,
        valid=numbers(STEPS, ENVS) < 10,
        scores=numbers(STEPS, ENVS, TERMS),
        first_stamp=1_000,
        label="kept",
    )


class TestViews:
    def test_base_pose_is_position_and_quaternion(self, trace):
        # Pose i of the trace, counted over samples and envs, holds the numbers from 7 i.
        np.testing.assert_array_equal(trace.base_position[2, 1], [49.0, 50.0, 51.0])
        np.testing.assert_array_equal(trace.orientation[2, 1], [52.0, 53.0, 54.0, 55.0])

    def test_env_has_the_samples_of_one_env_without_its_axis(self, trace):
        one = trace.env(1)
        np.testing.assert_array_equal(one.base_pose[:, 0], [7.0, 28.0, 49.0, 70.0, 91.0])
        np.testing.assert_array_equal(one.joint_velocity[3], -np.arange(80.0, 88.0))
        np.testing.assert_array_equal(one.valid, [True, True, True, False, False])
        np.testing.assert_array_equal(one.scores, [[2.0, 3.0], [8.0, 9.0], [14.0, 15.0], [20.0, 21.0], [26.0, 27.0]])
        assert one.contact.shape == (STEPS, LEGS)
        assert one.joint_torque is None
        assert (one.label, one.first_stamp, one.robot) == ("kept", 1_000, MINI_QUADRUPED)

    @pytest.mark.parametrize("envs", [[2, 0], np.array([2, 0]), np.array([True, False, True])], ids=str)
    def test_select_keeps_the_axis_of_envs_in_the_order_asked_for(self, trace, envs):
        some = trace.select(envs)
        order = np.arange(ENVS)[envs]
        assert some.scores.shape == (STEPS, 2, TERMS)
        for place, env in enumerate(order):
            np.testing.assert_array_equal(some.joint_position[:, place], numbers(STEPS, ENVS, JOINTS)[:, env])
            np.testing.assert_array_equal(some.contact[:, place], trace.contact[:, env])

    def test_window_starts_at_the_timestamp_of_its_first_sample(self, trace):
        part = trace.window(1, 4)
        np.testing.assert_array_equal(part.scores[:, 0], [[6.0, 7.0], [12.0, 13.0], [18.0, 19.0]])
        np.testing.assert_array_equal(part.valid[:, 2], [True, True, False])
        assert part.first_stamp == 20_001_000
        assert trace.window().first_stamp == 1_000
        assert (len(trace.window(-2)), trace.window(-2).first_stamp) == (2, 60_001_000)

    def test_stack_of_samples_is_a_trace_again(self, trace):
        one = trace.env(0)
        again = Scored.stack(samples(one))
        for name, array in one.quantities().items():
            np.testing.assert_array_equal(getattr(again, name), array)
        assert (again.timestep, again.label) == (0.02, "kept")

    def test_stack_of_every_second_sample_keeps_the_last(self, trace):
        one = trace.env(0)
        thinned = Scored.stack(samples(one.window(stop=4)), every=2)
        np.testing.assert_array_equal(thinned.scores, [[6.0, 7.0], [18.0, 19.0]])
        assert thinned.timestep == pytest.approx(0.04)


class TestJoints:
    def test_joint_states_have_the_timestamps_and_order_of_the_robot(self, trace):
        joints = trace.env(2).joints
        assert joints.names == JOINT_NAMES
        np.testing.assert_array_equal(joints.stamps, 1_000 + 20_000_000 * np.arange(STEPS))
        np.testing.assert_array_equal(joints.positions, trace.joint_position[:, 2])
        np.testing.assert_array_equal(joints.velocities, trace.joint_velocity[:, 2])
        assert joints.efforts is None

    def test_timestamps_are_the_nearest_nanoseconds(self, trace):
        joints = dataclasses.replace(trace, timestep=1 / 30).env(0).joints
        np.testing.assert_array_equal(joints.stamps - 1_000, [0, 33_333_333, 66_666_667, 100_000_000, 133_333_333])

    def test_joints_of_several_envs_are_refused(self, trace):
        with pytest.raises(QuadrupedError, match=r"shape \(5, 3, 8\); take one env with env\(index\)"):
            _ = trace.joints


class TestShapes:
    @pytest.mark.parametrize(
        ("name", "shape", "message"),
        [
            ("joint_position", (STEPS, ENVS, 7), r"joint_position must have shape \(5, 3, 8\); found \(5, 3, 7\)"),
            ("joint_torque", (STEPS, 2, JOINTS), r"joint_torque must have the axes \(5, 3\) .*; found \(5, 2, 8\)"),
            ("contact", (ENVS, LEGS), r"contact must have the axes \(5, 3\) of base_pose first; found \(3, 4\)"),
            ("scores", (STEPS,), r"scores must have the axes \(5, 3\) .*; found \(5,\)"),
        ],
    )
    def test_array_of_another_shape_is_refused(self, trace, name, shape, message):
        with pytest.raises(QuadrupedError, match=message):
            dataclasses.replace(trace, **{name: numbers(*shape)})


class TestRecorder:
    @pytest.fixture
    def readings(self):
        rng = np.random.default_rng(0)
        return [random_readings(rng, ENVS) for _ in range(2)]

    @staticmethod
    def extras(sample):
        return {"valid": np.full(ENVS, sample == 0), "scores": sample + numbers(ENVS, TERMS)}

    @pytest.mark.parametrize("dtype", [np.float32, np.float64])
    def test_trace_holds_the_readings_in_the_type_asked_for(self, readings, dtype):
        recorder = Recorder(MINI_QUADRUPED, 3, dtype)
        for sample, reading in enumerate(readings):
            recorder.write(reading, **self.extras(sample))
        assert recorder.written == 2
        trace = Scored(robot=MINI_QUADRUPED, timestep=0.02, label="recorded", **recorder.arrays())
        for t, reading in enumerate(readings):
            np.testing.assert_array_equal(trace.base_position[t], reading.base_position.astype(dtype))
            np.testing.assert_array_equal(trace.orientation[t], reading.orientation.astype(dtype))
            np.testing.assert_array_equal(trace.velocity[t, :, 0], reading.linear_velocity_b[:, 0].astype(dtype))
            np.testing.assert_array_equal(trace.velocity[t, :, 1], reading.angular_velocity_b[:, 2].astype(dtype))
            for name in ("joint_position", "joint_velocity", "joint_torque"):
                np.testing.assert_array_equal(getattr(trace, name)[t], getattr(reading, name).astype(dtype))
        np.testing.assert_array_equal(trace.valid[:, 0], [True, False, False])
        np.testing.assert_array_equal(trace.scores[:, 1], [[2.0, 3.0], [3.0, 4.0], [0.0, 0.0]])
        assert {getattr(trace, name).dtype for name in ("base_pose", "joint_torque", "scores")} == {np.dtype(dtype)}
        assert trace.valid.dtype == np.bool_
        assert trace.contact is trace.command is None
        assert trace.label == "recorded"

    def test_samples_are_copies_of_the_live_readings(self, readings):
        recorder = Recorder(MINI_QUADRUPED, 1)
        before = readings[0].joint_position.copy()
        recorder.write(readings[0])
        readings[0].joint_position[:] = 0.0
        np.testing.assert_array_equal(recorder.arrays()["joint_position"][0], before)

    def test_quantity_that_is_always_known_is_required(self):
        # `Scored` requires `velocity`, which `Trace` may leave out.
        poses = {"base_pose": numbers(2, 1, 7), "joint_position": numbers(2, 1, JOINTS)}
        assert Trace(robot=MINI_QUADRUPED, timestep=0.02, **poses).velocity is None
        with pytest.raises(TypeError, match="velocity"):
            Scored(robot=MINI_QUADRUPED, timestep=0.02, valid=np.ones((2, 1), bool), scores=numbers(2, 1, 1), **poses)
