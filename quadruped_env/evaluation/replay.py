"""Play a recorded joint trajectory again: as pictures of the robot would show it, or through its motors."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.film import FRAME_RATE, Motion
from quadruped_env.evaluation.recording import Recording, play
from quadruped_env.evaluation.results import check_free, write_json
from quadruped_env.evaluation.rollout import Progress
from quadruped_env.robot import JOINT_NAMES, JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE_HEIGHT, forward_kinematics
from quadruped_env.robot.kinematics import Pose
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.trajectory.csv import write_table

MODES: Final = ("kinematic", "dynamic")
LIMIT_TOLERANCE: Final = 0.01
"""rad: a joint's stop gives a little under load, and an encoder is not exact, so this far over a limit is at it"""

MAX_CLIP: Final = 100.0
"""rad: a position farther than this beyond a limit is damage, and no limit stands in for it"""

POSES_FILE: Final = "link_poses.csv"
JOINTS_FILE: Final = "joint_states.csv"
REPORT_FILE: Final = "tracking.json"

_POSE_COLUMNS: Final = ("x", "y", "z", "qw", "qx", "qy", "qz")


@dataclass(frozen=True)
class Replay:
    """What was recorded, and what was played."""

    mode: str
    recorded: JointTrajectory
    """In the order of `JOINT_NAMES`"""
    played: JointTrajectory
    """Stamps as the recording counts them. Kinematic: the recording's own rows. Dynamic: measured, 50 Hz"""
    motion: Recording | None
    """What the robot did in dynamic mode; a kinematic replay has no world to do it in"""
    clipped: int
    """How many recorded positions were moved to a limit"""

    def link_poses(self) -> dict[str, Pose]:
        """Link name -> (position in m (T, 3), quaternion wxyz (T, 4)).

        In the world in dynamic mode, and in the frame of `base_link` in kinematic mode.
        """
        return forward_kinematics(self.played.positions, None if self.motion is None else self.motion.base_pose)

    def tracking_error(self) -> NDArray[np.float64]:
        """Played minus recorded position at the same time, rad (T, 8)."""
        return self.played.positions - self.recorded.positions_at(self.played.times)

    def film(self) -> Motion:
        """What a film of it shows; a kinematic replay floats where its stance would stand."""
        name = Path(self.recorded.source.name).name
        if self.motion is not None:
            return Motion.of_recording(self.motion, name)
        times = np.arange(0.0, self.played.duration + 1e-9, 1.0 / FRAME_RATE)
        base_pose = np.tile([0.0, 0.0, STANCE_HEIGHT, 1.0, 0.0, 0.0, 0.0], (len(times), 1))
        return Motion(f"{name}, kinematic", 1.0 / FRAME_RATE, base_pose, self.played.positions_at(times))

    def report(self) -> dict[str, Any]:
        """The replay in numbers, as JSON takes them; errors in rad, times in s."""
        error = self.tracking_error()
        joints = {
            name: {**_summary(error[:, i]), "max_at": float(self.played.times[np.argmax(np.abs(error[:, i]))])}
            for i, name in enumerate(JOINT_NAMES)
        }
        motion = None
        if self.motion is not None:
            motion = {
                "seconds": self.motion.joints.duration,
                "fell_at": self.motion.fell_at,
                "base_pose_start": self.motion.base_pose[0].tolist(),
                "base_pose_end": self.motion.base_pose[-1].tolist(),
            }
        return {
            "recording": self.recorded.source.name,
            "mode": self.mode,
            "rows": len(self.recorded),
            "seconds": self.recorded.duration,
            "clipped": self.clipped,
            "motion": motion,
            "tracking_error": {"unit": "rad", "all": _summary(error), "joints": joints},
        }

    def table(self) -> str:
        """The report for people."""
        report = self.report()
        low, high = self.recorded.positions.min(axis=0), self.recorded.positions.max(axis=0)
        lines = [f"{'joint':<16}{'recorded range':>20}{'RMS error':>14}{'max error':>14}{'at':>11}"]
        for i, (name, error) in enumerate(report["tracking_error"]["joints"].items()):
            # Adding 0.0 turns a rounded -0.0 into 0.0.
            span = f"{low[i].round(3) + 0.0:+.3f} .. {high[i].round(3) + 0.0:+.3f}"
            lines.append(
                f"{name:<16}{span:>20}{error['rms']:>10.4f} rad{error['max']:>10.4f} rad{error['max_at']:>9.2f} s"
            )
        everything = report["tracking_error"]["all"]
        lines.append(f"{'all':<16}{'':>20}{everything['rms']:>10.4f} rad{everything['max']:>10.4f} rad")
        if self.clipped:
            lines.append(f"{self.clipped} recorded positions were moved to a joint's limit.")
        if self.motion is not None:
            lines.append(self.motion.outcome())
        return "\n".join(lines)

    def save(self, directory: Path, overwrite: bool = False, progress: Progress | None = None) -> None:
        """Write the link poses, the report and, in dynamic mode, the measured joints into a directory.

        Raises:
            QuadrupedError: if one of the files is there already and is not to be overwritten, or cannot be written.
        """
        check_free(replay_files(directory), overwrite)
        links = self.link_poses()
        titles = [f"{name}.{column}" for name in links for column in _POSE_COLUMNS]
        table = np.concatenate([part for pose in links.values() for part in pose], axis=1)
        write_table(directory / POSES_FILE, self.played.stamps, titles, table, overwrite, progress)
        if self.mode == "dynamic":
            self.played.save(directory / JOINTS_FILE, overwrite)
        write_json(directory / REPORT_FILE, self.report())


def replay(
    trajectory: JointTrajectory, mode: str = "dynamic", clip: bool = False, progress: Progress | None = None
) -> Replay:
    """Play a recording.

    Args:
        trajectory: all eight joints, in any order.
        mode: `kinematic` sets the joints to the recorded positions, with no forces and no ground. `dynamic` makes
            them the targets of the motors of a robot that starts at rest in its stance, with gravity and ground.
        clip: whether to move positions outside the joint limits to the limit.
        progress: is told the share that is done, in dynamic mode.

    Raises:
        QuadrupedError: if a joint is unknown or missing, a position is outside its joint's limits and `clip` is
            false (or so far outside that it is damage), or there is no such mode.
    """
    if mode not in MODES:
        raise QuadrupedError(f"replay: unknown mode {mode!r}; valid modes are {', '.join(MODES)}")
    recorded = trajectory.in_joint_order()
    playable, clipped = _within_limits(recorded, clip)
    if mode == "kinematic":
        return Replay(mode, recorded, playable, None, clipped)
    motion = play(playable, progress=progress)
    return Replay(mode, recorded, motion.joints, motion, clipped)


def replay_files(directory: Path) -> list[Path]:
    """What `Replay.save` may write into a directory."""
    return [directory / name for name in (POSES_FILE, JOINTS_FILE, REPORT_FILE)]


def _within_limits(trajectory: JointTrajectory, clip: bool) -> tuple[JointTrajectory, int]:
    """The trajectory with no position beyond a limit, and how many were."""
    positions = trajectory.positions
    excess = np.maximum(JOINT_POSITION_LOW - positions, positions - JOINT_POSITION_HIGH)
    beyond = excess > LIMIT_TOLERANCE
    if not beyond.any():
        return trajectory, 0
    damaged = excess > MAX_CLIP
    if not clip or damaged.any():
        row, column = np.argwhere(damaged if clip else beyond)[0]
        cure = (
            "too far to clip: mend the value" if clip else "clip (--clip) to play at the limit, or mend the recording"
        )
        raise QuadrupedError(
            f"{trajectory.source.row(row)}, position.{JOINT_NAMES[column]}: {positions[row, column]:g} rad at "
            f"{trajectory.times[row]:g} s is outside {JOINT_POSITION_LOW[column]:g} to "
            f"{JOINT_POSITION_HIGH[column]:g} rad; values outside: {beyond.sum()}; {cure}"
        )
    within = positions.clip(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)
    return JointTrajectory(trajectory.stamps, JOINT_NAMES, within, source=trajectory.source), int(beyond.sum())


def _summary(error: NDArray[np.float64]) -> dict[str, float]:
    return {"rms": float(np.sqrt(np.mean(error * error))), "max": float(np.max(np.abs(error)))}
