import math
import signal
import subprocess
import sys
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from paths import importing
from waiting import killed_on_failure, output_of

from benchmarks import env_speed, learning_speed, shipping, terrain_speed, throughput
from benchmarks.shipping import acceptance
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.policies import Policy, load_policy
from quadruped_env.policies.files import SHIPPED
from quadruped_env.task import RandomizationConfig


def test_the_shipped_policy_meets_more_commands_than_its_gait():
    policy = load_policy("flat")
    still = replace(
        policy,
        weights=(*policy.weights[:-1], 0.0 * policy.weights[-1]),
        biases=(*policy.biases[:-1], 0.0 * policy.biases[-1]),
    )
    commands = replace(learning_speed.COMMANDS, points=40, seconds=4.0)
    learned, gait = (learning_speed.results_of(one, 7, commands) for one in (policy, still))
    assert learned.met > gait.met + 0.2
    assert learned.yaw_rate_error < 0.5 * gait.yaw_rate_error
    assert (learned.seed, learned.timesteps) == (7, policy.card["timesteps"])


@pytest.mark.slow
def test_checkpoints_of_one_training_are_tested_at_their_times():
    lines = []
    settings = {"num_envs": 16, "batch_size": 64, "seed": 3}
    commands = replace(learning_speed.COMMANDS, points=2, seconds=2.0)
    first, last = learning_speed.learning_curve([1.0, 3.0], settings, lines.append, commands)
    assert 1.0 <= first.seconds < 3.0 <= last.seconds
    assert 0 < first.timesteps < last.timesteps
    assert [line.startswith("seed 3, ") for line in lines] == [True, True]


def test_learning_curves_are_summed_up_by_medians_over_the_seeds():
    points = [
        learning_speed.Point(seed, 60.0 + seed, 1000 * seed, met, 0.1 * met, 0.2, 0.0)
        for seed, met in enumerate((0.9, 0.2, 0.4))
    ]
    *_, row = learning_speed.summary([[point] for point in points]).splitlines()
    assert row == "| 61 | 1,000 | 40% | 90%, 20%, 40% | 0.040 | 0.200 | 0.0% |"


def test_a_shipped_policys_command_names_no_directory_of_the_machine():
    for command in (
        "train.py --seed 0 -o /tmp/runs/x",
        "train.py -o/tmp/x --seed 0",
        "train.py --output /tmp/x --seed 0",
        "train.py --seed 0 --output=/x",
    ):
        assert shipping.without_output(command) == "train.py --seed 0"
    for name in SHIPPED:
        command = load_policy(name).card["command"]
        assert shipping.without_output(command) == command


@pytest.mark.slow
def test_the_shipped_policy_is_accepted():
    found = acceptance(load_policy("flat"))
    assert found["accepted"]
    assert found["episodes"] == 300
    assert max(found["forward_velocity_error"].values()) <= 0.10


def test_acceptance_is_on_the_same_ground_for_every_policy_and_disturbance_is_not(monkeypatch):
    seen = []

    def watched(controller, commands, seeds, config, progress):
        seen.append(config)
        return roll_out(controller, commands, seeds[:2], 3.0, config, progress)

    monkeypatch.setattr(shipping, "roll_out", watched)
    monkeypatch.setattr(shipping, "ACCEPTANCE_EPISODES", 2)
    flat = load_policy("flat")
    config = flat.config.on_terrain("rough").randomized("moderate")
    on_hills = Policy.for_task(flat.weights, flat.biases, flat.activation, config, {})
    for policy in (flat, on_hills):
        shipping.acceptance(policy)
        found = shipping.disturbed(policy, episodes=2)
    plain = RandomizationConfig(friction=(0.6, 1.0))
    assert [config.randomization for config in seen] == [plain, RandomizationConfig(preset="hard")] * 2
    assert {config.terrain.name for config in seen} == {"flat"}
    assert found["episodes"] == 10
    assert np.mean(list(found["fall_rate_by_command"].values())) == pytest.approx(found["fall_rate"])


def turned(angle, axis):
    """Orientation wxyz after a turn about an axis (1, 2 or 3 for x, y or z)."""
    quaternion = np.zeros(4)
    quaternion[[0, axis]] = math.cos(angle / 2), math.sin(angle / 2)
    return quaternion


def test_time_in_which_a_robot_sits_is_counted_until_it_falls(monkeypatch):
    orientation, valid = np.zeros((200, 2, 4)), np.ones((200, 2), dtype=bool)
    # Both lean a little too little to count, then the first sits for a second, and the second until it falls.
    orientation[...] = turned(0.29, 1)
    orientation[100:150, 0] = orientation[100:, 1] = turned(0.31, 2)
    valid[150:, 1] = False

    rollout = SimpleNamespace(orientation=orientation, valid=valid, fallen=~valid[-1], timestep=0.02)
    monkeypatch.setattr(shipping, "roll_out", lambda *arguments, **options: rollout)
    monkeypatch.setattr(shipping, "DISTURBED_COMMANDS", ((0.0, 0.0),))
    found = shipping.disturbed(load_policy("flat"), episodes=2)
    assert found["tilted_share"] == pytest.approx((50 + 50) / (150 + 100), abs=1e-4)


@pytest.mark.parametrize("name", env_speed.WORKS)
def test_speed_of_the_envs_is_measured_as_a_ratio(name):
    assert name in throughput.WORKS
    assert all(measure.value > 0.0 for measure in env_speed.WORKS[name](chunks=1))


def test_physics_on_tiles_is_measured_over_the_plane():
    ratio, step = terrain_speed.ratios(num_envs=4, chunks=1)
    assert min(ratio, step) > 0.0
    assert "terrain" in throughput.WORKS


@pytest.mark.slow
def test_memory_of_a_training_is_measured_at_the_ends_of_its_rollouts():
    resident, growth = throughput.training_memory(timesteps=13_000)
    assert 50.0 < resident.value < 10_000.0, "MiB of a process with torch"
    assert math.isfinite(growth.value)


def test_memory_of_envs_is_at_least_that_of_their_states():
    (measure,) = throughput.env_memory(num_envs=1000)
    assert measure.value > 1000 * 8 * 100 / 2**20, "an env's state has over 100 numbers"
    assert "env-memory" in throughput.WORKS


def test_a_measurement_ends_with_the_program_that_is_killed():
    """The measuring process writes a byte when it begins; this test's end of the pipe closes when it has ended."""
    measurement = "import os, time; os.write(2, b'.'); time.sleep(1e6)"
    program = f"from benchmarks.measures import run_python; run_python({measurement!r})"
    process = subprocess.Popen([sys.executable, "-c", program], stderr=subprocess.PIPE, env=importing())
    with killed_on_failure(process):
        assert process.stderr.read(1) == b"."
        process.send_signal(signal.SIGKILL)
        assert output_of(process)[1] == b""
