"""Read a four-legged robot from a URDF, a xacro file or an MJCF, and write the files that train and simulate it.

Base, legs, joints, corners, signs, feet and knees are found from tree and geometry, never from names. It writes

    NAME.py     the robot: a task file for --task of the other programs, with each assumed number to edit
    NAME.xml    its MJCF
    NAME.png    a picture of it in its stance, where OpenGL can draw one

and prints what was found, assumed, repaired and left out. A robot has four legs of two joints (pitch, pitch) or three
(roll, pitch, pitch or pitch, roll, pitch).

    mini-quadruped robot my_robot.urdf
    mini-quadruped train --task my_robot.py
    mini-quadruped robot urdf/dog.urdf.xacro --folder ~/ros/src -o dog
"""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from quadruped_env.cli.common_options import add_output, add_overwrite
from quadruped_env.cli.invocation import Invocation
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import fitness
from quadruped_env.importer import ImportedRobot, import_robot
from quadruped_env.importer.imported_robot import FORWARD
from quadruped_env.importer.xml_tree import FIX
from quadruped_env.robot import Robot
from quadruped_env.utils.documents import check_regular
from quadruped_env.utils.files import check_free, write_whole
from quadruped_env.utils.text_table import text_table

_STATUSES: Final = ("found", "assumed", "repaired", "left out")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file, where its meshes are, and where the robot is written."""
    parser.add_argument("file", type=Path, metavar="FILE", help="URDF, xacro file (extra xacro) or MJCF")
    parser.add_argument(
        "--folder",
        type=Path,
        action="append",
        default=[],
        metavar="FOLDER",
        help="where meshes, included files and ROS packages (package://, $(find)) are searched besides the package of "
        "FILE; repeat it for several",
    )
    parser.add_argument(
        "--forward",
        nargs="?",
        const="",
        metavar="AXIS",
        help=f"axis of the base link along which the robot walks, where that is a convention: {', '.join(FORWARD)}",
    )
    for axis in FORWARD[1::2]:  # argparse takes the -y of '--forward -y' for an option
        parser.add_argument(axis, dest="forward", action="store_const", const=axis, help=argparse.SUPPRESS)
    parser.set_defaults(forward=None)
    add_output(parser, "NAME", "NAME of the files, or PATH/NAME (default: the name of FILE, in this folder)")
    add_overwrite(parser)


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Read the robot, write its files and print what was found."""
    check_regular(arguments.file, FIX)
    place = _place(arguments.file, arguments.output)
    files = {suffix: place.with_name(place.name + suffix) for suffix in (".py", ".xml", ".png")}
    check_free(files.values(), arguments.overwrite)
    robot = import_robot(arguments.file, arguments.folder, arguments.forward)
    value = robot.robot()
    write_whole({files[".xml"]: robot.mjcf.encode(), files[".py"]: robot.task_file(files[".xml"].name).encode()})
    print("\n".join(_summary(robot)))
    for line in fitness(value):
        print(f"note: {line}")
    problem = _picture(value, files[".png"])
    written = [str(path) for suffix, path in files.items() if not (problem and suffix == ".png")]
    print(f"\nwritten: {', '.join(written)}{problem and f'; {problem}'}")
    print(f"train it: mini-quadruped train --task {files['.py']}")
    return 0


def _place(file: Path, output: Path | None) -> Path:
    """Return the path of the files that are written, without suffix."""
    if output is not None:
        if output.name in ("", ".."):
            raise QuadrupedError(f"--output: {output} has no name; give NAME or PATH/NAME")
        place = output.with_suffix("") if output.suffix in (".py", ".xml") else output
    else:
        place = Path(file.name.split(".")[0] or "robot")
    if place.with_name(place.name + ".xml").resolve() == file.resolve():
        if output is not None:
            raise QuadrupedError(f"--output: {place}.xml is the file that is read; give another name")
        place = place.with_name(f"{place.name}_robot")
    return place


def _summary(robot: ImportedRobot) -> list[str]:
    stance = robot.stance
    lines = [
        f"{robot.name}: {robot.mass:.4g} kg, four legs of {len(robot.anatomy.kinds)} joints "
        f"({', '.join(robot.anatomy.kinds)}), thigh {stance.thigh:.4g} m, shank {stance.shank:.4g} m, feet of radius "
        f"{robot.anatomy.foot_radius:.3g} m, hips {stance.height:.3g} m above the ground",
        "",
    ]
    legs: list[Sequence[str]] = [("leg", "joints from the base to the foot", "signs", "knee")]
    for plane, knee in zip(stance.planes, stance.knees, strict=True):
        signs = "".join("+" if sign > 0 else "-" for sign in plane.signs)
        legs.append((plane.leg.corner, ", ".join(plane.leg.names), signs, "behind" if knee == "<" else "in front"))
    lines.append(text_table(legs, left=4))
    rows = [
        (status, finding.subject, finding.text)
        for status in _STATUSES
        for finding in robot.findings
        if finding.status == status
    ]
    return [*lines, "", text_table(rows, left=3)] if rows else lines


def _picture(robot: Robot, path: Path) -> str:
    """Draw the robot in its stance; return why there is no picture, or nothing."""
    from quadruped_env.importer.picture import write_picture

    try:
        write_picture(robot, path)
    except (QuadrupedError, ImportError) as error:
        return f"no picture: {error}"
    return ""
