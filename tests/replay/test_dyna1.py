"""A real robot's log, read with the map among the assets: the worked example of a foreign robot."""

import numpy as np
import pytest
from paths import DYNA1, ROOT

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError, forward_kinematics
from quadruped_env.robot import MINI_QUADRUPED

MAP = ROOT / "assets" / "maps" / "dyna1.toml"


@pytest.fixture(scope="module")
def data():
    if not (DYNA1 / "measured.csv").exists():
        pytest.skip("the recording of Dyna1 is not here: expected shared/data/dyna1 in the checkout or next to it")
    return DYNA1


@pytest.fixture(scope="module")
def measured(data):
    return JointTrajectory.load(data / "measured.csv", columns=MAP, joint_map=MAP)


def test_log_without_its_map_is_refused(data):
    with pytest.raises(QuadrupedError, match=r"measured\.csv: text that begins with 'time_start,.*\(--columns FILE\)"):
        JointTrajectory.load(data / "measured.csv")
    with pytest.raises(
        QuadrupedError, match=r"measured\.csv: line 2, position\.flarm: -58\.65 rad .* degrees.*--unit deg"
    ):
        JointTrajectory.load(data / "measured.csv", columns=MAP)


def test_numbers_are_those_of_the_file(data, measured):
    table = np.genfromtxt(data / "measured.csv", delimiter=",", names=True)
    assert measured.names == JOINT_NAMES
    assert len(measured) == 1251
    assert measured.stamps[0] == 1_750_874_402_857_384_000
    np.testing.assert_allclose(measured.positions[:, 0], np.radians(-table["flarm"] - 7.1), rtol=1e-12)
    np.testing.assert_allclose(measured.positions[:, 7], np.radians(-0.8 * table["brfoot"] + 10.3), rtol=1e-12)


def test_standing_in_the_log_is_this_robots_stance(measured):
    standing = measured.at([measured.stamps[0] + 6_000_000_000])
    moving = [i for i, name in enumerate(JOINT_NAMES) if name not in {"LF_hip_joint", "LH_hip_joint"}]
    np.testing.assert_allclose(standing.positions[0, moving], MINI_QUADRUPED.stance[moving], atol=0.01)
    poses = forward_kinematics(measured.positions)
    lowest = min(float(poses[f"{leg}_leg"][0][600, 2]) for leg in ("RF", "RH"))
    assert lowest < -0.02  # the legs are under the body, not folded next to it


def test_commands_and_measurements_are_on_one_clock(data, measured):
    commands = JointTrajectory.load(data / "control.csv", columns=MAP, joint_map=MAP)
    assert (len(commands), commands.velocities) == (613, None)
    at = (commands.stamps - measured.stamps[0]) / 1e9
    knee = JOINT_NAMES.index("RF_knee_joint")
    errors = {
        lag: float(np.sqrt(np.mean((measured.positions_at(at + lag)[:, knee] - commands.positions[:, knee]) ** 2)))
        for lag in (-1.0, 0.0, 1.0)
    }
    assert errors[0.0] < 0.1 < min(errors[-1.0], errors[1.0])
