"""The ament_python package as users install it: built by colcon, its node run by a real rclpy."""

import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import launch_files
import numpy as np
import pytest
import ros2_peers
from paths import ROOT
from waiting import output_of, wait_until

from quadruped_env import JOINT_NAMES, SinusoidalGait
from quadruped_env.live.middleware.topics import JOINT_COMMANDS, JOINT_STATES

NAME = "mini_quadruped_sim"
PACKAGE = ROOT / "assets" / "ros2" / NAME
SUBSCRIBER = Path(ros2_peers.__file__).parent / "print_joint_states.py"
SETTER = Path(ros2_peers.__file__).parent / "set_parameters.py"
COUNT = 60

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    """A workspace in which the package has been built as its README says."""
    colcon = ros2_peers.colcon()
    workspace = tmp_path_factory.mktemp("ros2_ws")
    shutil.copytree(PACKAGE, workspace / "src" / NAME, ignore=shutil.ignore_patterns("__pycache__"))
    clean = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "AMENT_PREFIX_PATH")}
    built = subprocess.run(
        [colcon, "build", "--symlink-install"],
        cwd=workspace,
        env=clean | {"COLCON_HOME": str(workspace / "colcon")},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert built.returncode == 0, built.stdout
    assert f"Finished <<< {NAME}" in built.stdout
    return workspace


@pytest.fixture
def sourced(workspace, ros2):
    """The environment after `source install/setup.bash`, in a terminal of the ROS 2 distribution."""
    command = "source install/setup.bash && env -0"
    shown = subprocess.run(
        ["bash", "-c", command], cwd=workspace, env=ros2.environment(), capture_output=True, text=True, check=True
    )
    return dict(line.split("=", 1) for line in shown.stdout.split("\0") if line)


@pytest.fixture
def run_node(workspace, ros2, sourced):
    """Starts the built node with ROS arguments; ends it after the test if it still runs."""
    program = workspace / "install" / NAME / "lib" / NAME / "joint_state_publisher_node"
    started = []

    def run(*arguments):
        started.append(ros2.start(program, *arguments, env=sourced))
        return started[-1]

    yield run
    for process in started:
        # Not killed: it would leave its shared memory behind.
        process.terminate()
        output_of(process)


def messages_of(ros2, count=COUNT, *arguments):
    with ros2.start(SUBSCRIBER, count, *arguments) as process:
        output, _ = output_of(process)
    return [json.loads(line) for line in output.splitlines() if line.startswith("{")]


def ticks_of(messages, period):
    """Number of periods (ns) from the first message to each; asserts that the timestamps fill exactly that grid."""
    timestamps = np.array([message["timestamp"] for message in messages])
    assert np.gcd.reduce(np.diff(timestamps)) == period
    assert (np.diff(timestamps) > 0).all()
    return (timestamps - timestamps[0]) // period


def test_colcon_installs_what_the_launch_files_use(workspace, ros2, sourced):
    question = f"from ament_index_python.packages import *; print(get_package_share_directory({NAME!r}))"
    answer = subprocess.run([ros2.python, "-c", question], env=sourced, capture_output=True, text=True, check=True)
    share = Path(answer.stdout.strip())
    assert share.is_relative_to(workspace / "install")
    state, node, rviz = launch_files.started(share / "launch" / "display.launch.py", share)
    assert 'name="mini_quadruped"' in state.parameters["robot_description"]
    assert Path(rviz.arguments[rviz.arguments.index("-d") + 1]).is_file()
    package, executable = node.executable.split("/")
    assert os.access(share.parents[1] / "lib" / package / executable, os.X_OK)
    sim, *_ = launch_files.started(share / "launch" / "walk.launch.py", share, python="python")
    assert "sim" in sim.arguments


def test_built_node_publishes_the_preset_article_at_20_hz(ros2, run_node):
    node = run_node()
    messages = messages_of(ros2)
    node.send_signal(signal.SIGINT)
    output, _ = output_of(node)
    assert "Traceback" not in output
    assert node.returncode == 0

    assert len(messages) == COUNT
    assert all(message["name"] == list(JOINT_NAMES) and message["effort"] == [0.0] * 8 for message in messages)
    ticks = ticks_of(messages, 50_000_000)
    article = SinusoidalGait.preset("article")
    positions = np.array([message["position"] for message in messages])
    velocities = np.array([message["velocity"] for message in messages])
    # The subscriber may have missed the first messages: which tick was its first?
    candidates = np.arange(100_000)
    first = candidates[np.abs(article.positions(candidates * 0.05) - positions[0]).max(-1) <= 1e-12]
    assert first.size == 1
    times = (first[0] + ticks) * 0.05
    np.testing.assert_allclose(positions, article.positions(times), rtol=0, atol=1e-12)
    np.testing.assert_allclose(velocities, article.velocities(times), rtol=0, atol=1e-12)


def test_running_node_changes_its_gait_by_parameters_in_its_namespace(ros2, run_node):
    node = run_node("--ros-args", "-r", "__ns:=/r1", "-p", "rate:=40.0")
    topic = "--ros-args", "-r", "/joint_states:=/r1/joint_states"
    messages_of(ros2, 1, *topic)
    changes = {"angular_frequency": 4.0, "hip_amplitude": 0.1, "phases": [0.0] * 8, "knee_amplitude": float("nan")}
    with ros2.start(SETTER, "/r1/joint_state_publisher", json.dumps(changes)) as process:
        output, _ = output_of(process)
    assert json.loads(output.splitlines()[-1]) == {
        **dict.fromkeys(changes, ""),
        "knee_amplitude": "knee_amplitude: expected a finite number; found nan",
    }
    messages = messages_of(ros2, COUNT, *topic)
    assert node.poll() is None
    ticks = ticks_of(messages, 25_000_000)
    positions = np.array([message["position"] for message in messages])
    velocities = np.array([message["velocity"] for message in messages])
    assert (positions == np.tile(positions[:, :2], 4)).all()
    # The preset's knees, with the new frequency and phase; the hips a quarter of a cycle behind.
    phase = np.unwrap(np.arctan2(-velocities[:, 1] / (4.0 * 0.3), (positions[:, 1] + 0.3) / 0.3))
    np.testing.assert_allclose(phase - phase[0], 4.0 * 0.025 * ticks, atol=1e-6)
    np.testing.assert_allclose(positions[:, 0], 0.1 * np.sin(phase), atol=1e-9)


def test_walk_launch_in_a_sourced_terminal_starts_a_robot_that_is_controlled(workspace, sourced, nodes):
    share = workspace / "install" / NAME / "share" / NAME
    launched = launch_files.started(share / "launch" / "walk.launch.py", share, python=sys.executable, rviz="false")
    commands = [[one.executable, *one.arguments] for one in launched if one.executable == sys.executable]
    assert len(commands) == 2
    states, targets = (nodes().subscribe(topic) for topic in (JOINT_STATES, JOINT_COMMANDS))
    settings = {"env": sourced, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    running = [subprocess.Popen(command, **settings) for command in commands]
    try:
        for subscription, process in zip((states, targets), running, strict=True):
            wait_until(subscription.take, subscription.topic.name, alive=process)
    finally:
        for process in running:
            process.send_signal(signal.SIGINT)
        outputs = [output_of(process)[0] for process in running]
    assert [process.returncode for process in running] == [0, 0], outputs
    assert not any("Traceback" in output for output in outputs), outputs


@pytest.mark.parametrize(
    ("parameter", "found"),
    [("phases:=[0.5]", "found 1"), ("rate:=0.0", "found 0"), ("angular_frequency:=4", "INTEGER")],
)
def test_built_node_with_an_invalid_parameter_names_it_and_ends(run_node, parameter, found):
    node = run_node("--ros-args", "-p", parameter)
    output, _ = output_of(node)
    assert node.returncode == 1
    assert "Traceback" not in output
    last = output.strip().splitlines()[-1]
    assert last.startswith("error: ")
    assert parameter.split(":")[0] in last
    assert found in last
