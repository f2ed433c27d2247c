"""The task: terminations, commands, actions and memory."""

import dataclasses
import math

import numpy as np
import pytest
import twelve_joints
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE
from tasks import ACTION_WIDTH, NEVER_FALLS, Terms, column, make_env, make_task, random_readings

from quadruped_env import CommandedGait, QuadrupedError
from quadruped_env.control.control_config import COMMANDS
from quadruped_env.control.velocity_command import check_command
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model
from quadruped_env.task import ActionConfig, CommandConfig, Task, TaskConfig, terminations
from quadruped_env.task.command_sampling import CommandSampler

# --- terminations ---


def terms_on(**readings):
    """The task's context on readings of which some are given."""
    count = len(next(iter(readings.values())))
    return Terms(dataclasses.replace(random_readings(np.random.default_rng(0), count), **readings)).context


def test_tilted_is_an_angle_between_the_up_axes():
    angles = np.array([0.0, 0.5, 0.999, 1.001, 2.0, math.pi])
    context = terms_on(up_b=np.stack([np.sin(angles), np.zeros(6), np.cos(angles)], axis=1))
    np.testing.assert_array_equal(terminations.tilted(context, max_tilt=1.0), angles > 1.0)


def test_trunk_contact_is_more_than_a_force_on_any_part():
    force = np.zeros((4, 5))
    force[1, 0], force[2, 4], force[3] = 1.5, 1.0, 0.5
    context = terms_on(trunk_force=force)
    ended = terminations.trunk_contact(context, max_trunk_force=1.0)
    np.testing.assert_array_equal(ended, [False, True, False, False])


def test_episode_is_truncated_after_its_maximum_of_steps():
    task = make_task(2, max_episode_steps=5, termination=NEVER_FALLS)
    ends = []
    for step in range(8):
        if step == 3:
            task.reset(np.array([1]))
        transition = task.step(np.zeros((2, 8)))
        ends.append(transition.truncated.tolist())
        assert not transition.terminated.any()
    assert [end[0] for end in ends] == [False] * 4 + [True] * 4, "truncated until it is reset"
    assert [end[1] for end in ends] == [False] * 7 + [True]
    assert task.finished.all()
    task.reset(np.array([1]))
    assert task.finished.tolist() == [True, False]


# --- commands ---


def test_kind_of_a_command_changes_exactly_at_the_sums_of_the_shares():
    config = CommandConfig(standing_fraction=0.125, straight_fraction=0.25, turning_fraction=0.5)
    kinds = np.array([0.0, below(0.125), 0.125, below(0.375), 0.375, below(0.875), 0.875, below(1.0)])
    draws = np.column_stack([kinds, np.full((8, 2), 0.75), np.zeros(8)])
    command, interval = CommandSampler(COMMANDS, config).sample(draws)
    forward, yaw_rate = -0.3 + 0.9 * 0.75, -0.8 + 1.6 * 0.75
    expected = [(0.0, 0.0), (forward, 0.0), (0.0, yaw_rate), (forward, yaw_rate)]
    np.testing.assert_allclose(command, np.repeat(expected, 2, axis=0), rtol=1e-12)
    assert (interval == config.resample_interval[0]).all(), "of any kind"


def test_robots_that_move_sideways_have_commands_for_it():
    """None of the velocities, each of them alone, or all."""
    task = TaskConfig().for_robot(twelve_joints.ROBOT)
    shares = {
        "standing_fraction": 0.125,
        "straight_fraction": 0.25,
        "turning_fraction": 0.25,
        "sideways_fraction": 0.25,
    }
    kinds = np.array([below(0.125), 0.125, below(0.625), 0.625, below(0.875), 0.875])
    draws = np.column_stack([kinds, np.ones((6, 3)), np.zeros(6)])
    command, _ = CommandSampler(task.commands, task.command.replace(**shares)).sample(draws)
    v, w, u = (entry.range[1] for entry in task.commands)
    np.testing.assert_array_equal(command, [(0, 0, 0), (v, 0, 0), (0, w, 0), (0, 0, u), (0, 0, u), (v, w, u)])
    with pytest.raises(QuadrupedError, match=r"command.standing_fraction \+ .* \+ sideways_fraction must be at most 1"):
        task.command.replace(sideways_fraction=0.6)


def below(value):
    return math.nextafter(value, -1.0)


def test_a_fixed_command_is_not_replaced():
    task = make_task(fixed_command=(0.25, 0.125), command=CommandConfig(resample_interval=(0.02, 0.02)))
    task.reset(np.array([1]))
    for _ in range(10):
        task.step(np.zeros((3, 8)))
        np.testing.assert_array_equal(task.command[[0, 2]], [[0.25, 0.125]] * 2)
    assert (task.control.requested[1] != [0.25, 0.125]).any()


@pytest.mark.parametrize("command", [(9.0, 0.0), (0.0, math.nan), (0.1,), "x"])
def test_a_bad_command_is_refused_by_name(command):
    with pytest.raises(QuadrupedError, match=r"options\['command'\]"):
        check_command(command, COMMANDS)


# --- actions ---


@pytest.mark.parametrize(
    ("name", "command"), [("tuned", (0.0, 0.0)), ("low", (0.3, 0.0)), ("fast", (-0.2, 0.3)), ("tuned", (0.1, -0.5))]
)
def test_a_zero_action_in_residual_mode_is_exactly_the_scripted_gait(name, command):
    action = ActionConfig(mode="residual", gait=name)
    env = make_env(fixed_command=command, action=action, termination=NEVER_FALLS)
    gait = CommandedGait.preset(name)
    targets = []
    for _ in range(40):
        env.step(np.zeros(8))
        expected = gait.positions(env.task.control.phase, env.task.command)[0]
        np.testing.assert_array_equal(env.data.ctrl, np.clip(expected, JOINT_POSITION_LOW, JOINT_POSITION_HIGH))
        targets.append(expected)
    swing = np.ptp(targets, axis=0)
    assert (swing == 0.0).all() if command == (0.0, 0.0) else swing.max() > 0.05


@pytest.mark.parametrize("mode", ["position", "residual"])
def test_joint_targets_never_leave_the_limits(mode):
    env = make_env(action=ActionConfig(mode=mode, position_scale=3.0, residual_scale=3.0), termination=NEVER_FALLS)
    rng = np.random.default_rng(0)
    at_limit = 0
    for _ in range(50):
        env.step(rng.uniform(-1, 1, 8))
        assert (env.data.ctrl >= JOINT_POSITION_LOW).all()
        assert (env.data.ctrl <= JOINT_POSITION_HIGH).all()
        at_limit += (env.data.ctrl == JOINT_POSITION_LOW).sum() + (env.data.ctrl == JOINT_POSITION_HIGH).sum()
    assert at_limit > 0


class HoldController:
    """A controller of one constant joint target."""

    def __init__(self, target):
        self.target = target

    def act(self, observation, control):
        return self.target


def test_joint_target_of_a_controller_reaches_the_motors_unchanged_and_counts_as_no_action():
    env = make_env(termination=NEVER_FALLS)
    env.step(np.full(8, 0.5))
    target = STANCE + 0.1
    transition = env.task.act(HoldController(target[None]), None)
    np.testing.assert_array_equal(env.data.ctrl, target)
    np.testing.assert_array_equal(column("last_action", transition.observation), 0.0)
    env.task.act(HoldController(np.full((1, 8), 9.0)), None)
    np.testing.assert_array_equal(env.data.ctrl, JOINT_POSITION_HIGH)
    with pytest.raises(QuadrupedError, match=r"joint target: expected shape \(1, 8\).*found \(8,\)"):
        env.task.act(HoldController(target), None)


# --- memory ---


def test_tasks_of_one_config_share_no_arrays():
    config = TaskConfig()
    tasks = [Task(BatchSimulation(build_model(), 2, 1), config) for _ in range(2)]
    arrays = [
        {
            f"{part}.{name}": value
            for part in (task, task.control, task.context)
            for name, value in vars(part).items()
            if isinstance(value, np.ndarray) and value.flags.writeable and value.shape[:1] == (2,)
        }
        for task in tasks
    ]
    assert len(arrays[0]) > 10
    for name, array in arrays[0].items():
        for other in arrays[1].values():
            assert not np.shares_memory(array, other), name


def test_a_transition_is_not_overwritten_by_the_next_step():
    task = make_task()
    first = task.step(np.full((3, 8), 0.3))
    copies = {f.name: getattr(first, f.name).copy() for f in dataclasses.fields(first)}
    task.step(np.full((3, ACTION_WIDTH), -0.3))
    task.reset(np.arange(3))
    for name, value in copies.items():
        np.testing.assert_array_equal(getattr(first, name), value, err_msg=name)


def test_action_of_an_env_that_restarts_is_ignored():
    ignored, zero = make_task(2), make_task(2)
    for _ in range(4):
        for task in (ignored, zero):
            task.step(np.full((2, 8), 0.5))
    action = np.array([[0.5] * 8, [np.nan] * 8])
    with pytest.raises(QuadrupedError, match="action"):
        ignored.step(action)
    restart = np.array([False, True])
    one, other = ignored.step(action, restart), zero.step(np.nan_to_num(action), restart)
    np.testing.assert_array_equal(one.observation, other.observation)
    assert ignored.control.steps.tolist() == [5, 0]
    assert not one.reward[1]
    assert one.reward[0]


def test_reset_clears_the_memory_of_its_envs_only():
    task = make_task(3, termination=NEVER_FALLS)
    for _ in range(5):
        task.step(np.full((3, 8), 0.3))
    before = [task.get_state(row) for row in (0, 2)]
    task.reset(np.array([1]))
    fresh, others = task.get_state(1), [task.get_state(row) for row in (0, 2)]
    np.testing.assert_array_equal(fresh["control"]["action"], 0.0)
    np.testing.assert_array_equal(fresh["terms"]["smooth_velocity"], 0.0)
    np.testing.assert_array_equal(task.control.steps, [5, 0, 5])
    for old, new in zip(before, others, strict=True):
        assert old["generator"] == new["generator"]
        np.testing.assert_array_equal(new["simulation"].integration, old["simulation"].integration)
        for part in ("episode", "control", "terms", "randomizer", "draws"):
            for name, value in old[part].items():
                np.testing.assert_array_equal(new[part][name], value, err_msg=name)


def test_a_command_set_within_an_episode_stays_and_is_followed(model):
    sudden = {"resample_interval": [0.02, 0.02], "forward_acceleration": 1e6, "yaw_acceleration": 1e6}
    config = TaskConfig.from_dict({"action": {"mode": "residual"}, "command": sudden})
    changed = Task(SingleSimulation(model), config)
    row = np.zeros(1, dtype=np.intp)
    changed.reset(row, seeds=[3], command=(0.0, 0.0))
    changed.set_command(row, (0.4, 0.2))
    for _ in range(50):
        observation = changed.step(np.zeros((1, 8))).observation
        np.testing.assert_array_equal(changed.command, [[0.4, 0.2]])
        observed = changed.control.layout.slices["command"]
        np.testing.assert_allclose(observation[0, observed], np.array([1.6, 0.8]), atol=1e-6)
    assert changed.context.smooth_velocity[0, 0] > 0.15
    with pytest.raises(QuadrupedError, match="forward_velocity = 9 is outside"):
        changed.set_command(row, (9.0, 0.0))
    np.testing.assert_array_equal(changed.command, [[0.4, 0.2]])
