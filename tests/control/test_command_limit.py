"""Commands that are approached at a limited rate: against closed-form ramps, in the interface, envs and live."""

import gymnasium
import numpy as np
import pytest
from comparisons import random_policy

from quadruped_env import QuadrupedError
from quadruped_env.control.control_config import COMMANDS, Command, ControlConfig
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.live_controller import LiveController, Measurement, Mode, Safety
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig

DT = 0.02
RATES = np.array([1.0, 4.0])
"""Default rates, m/s^2 and rad/s^2."""
REQUESTS = [
    # Control steps, and the command that is requested at their beginning: one direction, the other one before it is
    # reached, across zero, to a point between two steps, and back to standing.
    (10, (0.5, -0.6)),
    (7, (-0.3, 0.8)),
    (40, (0.6, 0.71)),
    (3, (0.4321, -0.1234)),
    (40, (0.0, 0.0)),
]


def ramps(requests, start=(0.0, 0.0), rates=RATES):
    """The command in each control step (T, 2): it moves by rate * time towards the request and stops there."""
    commands, command = [], np.array(start)
    for steps, request in requests:
        duration = DT * np.arange(1, steps + 1)[:, None]
        way = np.array(request) - command
        part = np.sign(way) * np.minimum(abs(way), rates * duration)
        commands.append(command + part)
        command = commands[-1][-1]
    return np.concatenate(commands)


def played(control, requests):
    """Commands (T, N, 2) of an interface whose envs get the requests (N, 2) in turn."""
    found = []
    for steps, request in requests:
        control.set_command(np.arange(control.num_envs), np.atleast_2d(request).astype(float))
        for _ in range(steps):
            control.approach_requested()
            found.append(control.command.copy())
    return np.array(found)


def test_command_is_a_ramp_to_the_request_and_reaches_it_exactly():
    control = ControlInterface(MINI_QUADRUPED, ControlConfig())
    found = played(control, REQUESTS)[:, 0]
    np.testing.assert_allclose(found, ramps(REQUESTS), rtol=0, atol=1e-12)
    ends = np.cumsum([steps for steps, _ in REQUESTS]) - 1
    for end in (2, 4):
        np.testing.assert_array_equal(found[ends[end]], REQUESTS[end][1])
    # 0.6 m/s back to standing, after which nothing moves.
    assert control.moving[0] == 0.0
    assert np.abs(np.diff(found, axis=0)).max(axis=0) == pytest.approx(RATES * DT)


def test_rate_is_per_second_and_reset_sets_the_command_at_once():
    config = ControlConfig(timestep=0.01, command_rate=(0.5, 3.0), commands=(*COMMANDS, Command("height", "m", (0, 1))))
    control = ControlInterface(MINI_QUADRUPED, config, 2)
    control.reset(np.arange(2), 0.0, np.array([[0.3, 0.2, 0.1]] * 2))
    np.testing.assert_array_equal(control.command, [[0.3, 0.2]] * 2)
    control.set_command(np.array([1]), np.array([[0.6, -0.5, 0.7]]))
    assert control.command_of("height").tolist() == [0.1, 0.7], "only velocities are limited"
    np.testing.assert_array_equal(control.command, [[0.3, 0.2]] * 2)
    for _ in range(7):
        control.approach_requested()
    np.testing.assert_allclose(control.command, [[0.3, 0.2], [0.335, -0.01]], atol=1e-12)
    control.reset(np.array([1]))
    control.approach_requested()
    np.testing.assert_array_equal(control.command, [[0.3, 0.2], [0.0, 0.0]])


def test_envs_are_limited_each_by_itself_bit_for_bit():
    rng = np.random.default_rng(0)
    requests = [(int(steps), rng.uniform(-0.8, 0.8, (5, 2))) for steps in rng.integers(1, 30, 20)]
    together = played(ControlInterface(MINI_QUADRUPED, ControlConfig(), 5), requests)
    for i in range(5):
        alone = played(ControlInterface(MINI_QUADRUPED, ControlConfig()), [(n, each[i]) for n, each in requests])
        np.testing.assert_array_equal(alone[:, 0], together[:, i])


def test_random_commands_of_an_env_change_at_the_rates_of_its_config():
    config = {"command": {"resample_interval": [0.1, 0.4], "forward_acceleration": 0.7, "yaw_acceleration": 2.0}}
    env = gymnasium.make_vec("MiniQuadruped-v0", num_envs=8, config=config)
    _, info = env.reset(seed=0)
    commands = [info["command"]]
    for _ in range(200):
        _, _, terminated, truncated, info = env.step(np.zeros((8, 8), np.float32))
        commands.append(np.where((terminated | truncated)[:, None], np.nan, info["command"]))
    changes = np.abs(np.diff(commands, axis=0))
    largest = np.nanmax(changes, axis=(0, 1))
    np.testing.assert_allclose(largest, [0.7 * DT, 2.0 * DT], rtol=1e-9)
    assert (changes == 0.0).any(), "requests are reached"


def test_live_controller_approaches_its_command_at_the_policys_rates():
    policy = random_policy("residual", command=TaskConfig().command.replace(forward_acceleration=0.4))
    rates = np.array([0.4, 4.0])
    safety = Safety(min_ramp_time=0.1, settle=0.0, command_timeout=0.5, fresh_states=1)
    live = LiveController(PolicyController(policy), safety=safety)
    stance, zeros = np.array(MINI_QUADRUPED.stance), np.zeros(3)
    upright, i = np.array([1.0, 0.0, 0.0, 0.0]), 0

    def tick():
        nonlocal i
        i += 1
        live.measured(Measurement(i * 20_000_000, stance, np.zeros(8), upright, zeros), i * DT)

    while live.mode is not Mode.WALKING:
        tick()
        assert i < 500
    requests, found = [(9, (0.5, 0.6)), (30, (-0.1, -0.8))], []
    for steps, request in requests:
        for _ in range(steps):
            live.command(request, now=i * DT)
            tick()
            found.append(live._control.command[0].copy())
    # A command that expires is a request to stand, which is approached, too.
    for _ in range(40):
        tick()
        found.append(live._control.command[0].copy())
    expired = np.flatnonzero((live._control.requested == 0.0).all(axis=1))
    assert len(expired) == 1
    np.testing.assert_allclose(found[:39], ramps(requests, rates=rates), rtol=0, atol=1e-12)
    assert (np.abs(np.diff(found, axis=0)) <= rates * DT + 1e-12).all()
    np.testing.assert_array_equal(found[-1], [0.0, 0.0])


@pytest.mark.parametrize("value", [0.0, -1.0, float("inf"), "fast"])
def test_rate_that_is_not_positive_is_refused(value):
    for name in ("forward_acceleration", "yaw_acceleration"):
        for make in (TaskConfig.from_dict, lambda values: ControlConfig.of_task(values, MINI_QUADRUPED)):
            with pytest.raises(QuadrupedError, match=name):
                make({"command": {name: value}})
