"""Find out which motor moves which joint, and write it as a map for --map: names, signs, zeros, linear combinations.

    mini-quadruped live calibrate my_robot.toml
    mini-quadruped live calibrate my_robot.toml --task my_robot.py --motors m0 m1 m2 m3 m4 m5 m6 m7

THE ROBOT HAS TO HANG FREE. Its driver sends /joint_states and executes /joint_commands. One motor after another moves a
little out and back, slowly, while the others hold; you say which joints moved, and in which direction. Any key stops
the motion at once and lets the robot go limp; so do Ctrl-C, /estop, 1 s without states, and a motor that does not keep
to its target. At last you hold each leg at known angles. The file appears when all is known.
"""

import argparse
import math
import re
import sys
import time
from collections import deque
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.live.keyboard import Keyboard
from quadruped_env.live.middleware.topics import JOINT_STATES
from quadruped_env.live.motor_swing import ANGLE, SPEED, Motors, MotorSwing
from quadruped_env.live.node_options import add_robot_argument, robot_of
from quadruped_env.live.session import POLL_PERIOD, Session
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import SENSOR_DATA_QOS
from quadruped_env.ros.robot_messages import read_joint_state
from quadruped_env.trajectory.joint_map import UNITS, JointMap, JointRule, check_rule
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.files import check_free, write_whole
from quadruped_env.utils.interpreter import program_command
from quadruped_env.utils.program import CLEAR_LINE

_LISTEN: Final = 1.0
"""Time in which all motors have sent a state, s."""
_ANSWER: Final = re.compile(r"(?P<joint>\S+?)(?P<sign>[+-])(?P<factor>\d+\.?\d*|\.\d+)?")
_DIRECTIONS: Final = (("forward", "backward"), ("left", "right"), ("up", "down"))
"""Positive and negative direction along each axis of the base."""
_DECIMALS: Final = {"rad": 4, "deg": 2, "turn": 5, "ticks": 1}
"""Decimals of offsets, by unit."""

Answers = dict[str, dict[int, float]]
"""Motor -> joint that it moves -> angle of the joint per angle of the motor."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file, the motors, and their motion."""
    parser.add_argument("file", type=Path, metavar="MAP.toml", help="the map to write")
    parser.add_argument("--overwrite", action="store_true", help="replace the file if it exists")
    parser.add_argument(
        "--motors", nargs="+", metavar="NAME", help=f"the driver's names (default: all on {JOINT_STATES.name})"
    )
    parser.add_argument(
        "--unit", choices=UNITS, default="rad", help="the driver's unit of positions (default: %(default)s)"
    )
    parser.add_argument("--ticks-per-turn", type=float, metavar="N", help="of the encoders, with --unit ticks")
    add_robot_argument(parser, joint_map=False)


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Ask until the map is complete, and write it."""
    robot, path = robot_of(arguments), arguments.file
    unit = JointRule(unit=arguments.unit, ticks_per_turn=arguments.ticks_per_turn)
    check_rule("calibrate: --unit:", unit)
    check_free([path], arguments.overwrite)
    names = tuple(arguments.motors or _names(session))
    swing = MotorSwing(session, Motors(names, unit.factors[0]))
    with Keyboard() as keyboard:
        wizard = _Wizard(session, swing, keyboard, robot, names, unit)
        wizard.warn()
        found = wizard.joint_map()
    heading = f"# Joints of {robot.name} by the motors of its driver, as 'mini-quadruped live calibrate' found them."
    write_whole({path: f"{heading}\n\n{found.text()}".encode()})
    session.say(f"wrote {path}; move the joints by hand and check: {program_command('live', 'view', '--map', path)}")
    return 0


def _names(session: Session) -> Sequence[str]:
    """Names on `/joint_states`, which may hold some of them per message."""
    states = session.node.subscribe(JOINT_STATES, SENSOR_DATA_QOS, read=read_joint_state)
    names: dict[str, None] = {}
    end = math.inf
    for _ in session.turns():
        if time.monotonic() > end:
            break
        for _, state in states.messages(session.refuse):
            end = min(end, time.monotonic() + _LISTEN)
            names.update(dict.fromkeys(state.names))
        session.wait_for("" if names else JOINT_STATES.name)
    session.node.remove(states)
    return list(names)


class _Wizard:
    """Questions and answers.

    Args:
        swing: moves the motors.
        keyboard: of the answers, and to stop a motion.
        robot: the robot.
        motors: names of its motors.
        unit: rule with the unit of their positions, and nothing else.
    """

    def __init__(
        self,
        session: Session,
        swing: MotorSwing,
        keyboard: Keyboard,
        robot: Robot,
        motors: Sequence[str],
        unit: JointRule,
    ) -> None:
        self._session, self._swing, self._keyboard = session, swing, keyboard
        self._robot, self._motors, self._unit = robot, motors, unit
        self._keys: deque[str] = deque()

    def warn(self) -> None:
        """Tell what will happen, and wait for consent.

        Raises:
            QuadrupedError: without it.
        """
        shown = ", ".join(
            f"{name} {position:.3g}" for name, position in zip(self._motors, self._swing.positions(), strict=True)
        )
        self._session.say(
            f"THE ROBOT HAS TO HANG FREE: no leg may reach the ground, a cable or a hand, and its power switch is in "
            f"your reach. Each of its {len(self._motors)} motors moves by {ANGLE:g} rad, at {SPEED:g} rad/s at most, "
            f"while the others hold. Any key stops it at once, and the robot goes limp."
        )
        self._session.say(f"positions in {self._unit.unit}, is the unit right? {shown}")
        self._list_joints()
        if self._ask("Does the robot hang free? Type yes, or anything else to end.") != "yes":
            raise QuadrupedError("the robot has to hang free; nothing was moved")

    def joint_map(self) -> JointMap:
        """Ask until the answers make a map, and return it."""
        answers: Answers = {}
        asked = list(self._motors)
        while asked:
            for motor in asked:
                answers[motor] = self._moved(motor)
            problem = _problem(self._robot, answers, self._unit)
            self._session.say(problem or f"found:\n{_map(self._robot, answers, self._unit).text()}")
            asked = self._chosen(required=bool(problem))
        references, positions = np.zeros((2, self._robot.num_joints))
        for joints in map(list, self._robot.leg_joints):
            references[joints] = self._angles(joints)
            # All motors; a leg's joints use this leg's motors.
            measured = self._swing.positions()
            combined = _map(self._robot, answers, self._unit).to_joints(self._motors, {"position": measured})
            positions[joints] = combined["position"][joints]
        return _map(self._robot, answers, self._unit, references - positions)

    def _moved(self, motor: str) -> dict[int, float]:
        """Joints that a motor moves, as the user saw it, and their angles per angle of the motor."""
        direction, answer = 1.0, ""
        while True:
            if answer in ("", "other"):
                self._session.say(f"{motor} moves out and back. Press any key when you have seen which joints turn.")
                reason = self._swing.swing(self._motors.index(motor), direction, self._key_pressed)
                if reason:
                    self._session.say(f"{motor}: stopped, limp: {reason}")
            answer = self._ask(
                f"{motor}: which joints turned on the way out? Such as 1+ or 1-0.5 2+0.5 (joint, direction, angle per "
                f"angle of the motor), none, ? (list of joints), Enter: again, other: again in the other direction"
            )
            if answer == "other":
                direction = -direction
            elif answer == "?":
                self._list_joints()
            elif answer:
                try:
                    found = parsed_answer(answer, self._robot.joint_names)
                except QuadrupedError as error:
                    self._session.say(str(error))
                else:
                    return {joint: direction * factor for joint, factor in found.items()}

    def _chosen(self, required: bool) -> list[str]:
        """Ask which motors the user wants to see again."""
        enter = "" if required else "Enter: go on; or "
        while True:
            chosen = self._ask(f"{enter}a motor to move again: {', '.join(self._motors)}").split()
            if all(name in self._motors for name in chosen) and (chosen or not required):
                return chosen

    def _angles(self, joints: list[int]) -> Floats:
        """Ask for the angles at which the user holds a leg's joints, rad."""
        names = ", ".join(self._robot.joint_names[joint] for joint in joints)
        while True:
            answer = self._ask(
                f"{names}: hold the leg still at known angles. Enter: all 0 (a straight leg of the built-in robot, "
                f"across the trunk); or type the angles in degrees"
            ).replace(",", " ")
            try:
                angles = np.radians([float(angle) for angle in answer.split()] or [0.0] * len(joints))
            except ValueError:
                continue
            if len(angles) == len(joints) and np.isfinite(angles).all():
                return angles

    def _list_joints(self) -> None:
        feet = self._robot.skeleton.foot_centres(
            np.vstack([np.zeros(self._robot.num_joints), 0.1 * np.eye(self._robot.num_joints)])
        )
        lines = []
        for joint, name in enumerate(self._robot.joint_names):
            leg = next(leg for leg, joints in enumerate(self._robot.leg_joints) if joint in joints)
            moved = feet[1 + joint, leg] - feet[0, leg]
            axis = int(np.abs(moved).argmax())
            plus, minus = _DIRECTIONS[axis] if moved[axis] > 0.0 else _DIRECTIONS[axis][::-1]
            lines.append(f"  {joint + 1} {name}: + foot {plus}, - foot {minus}")
        self._session.say("joints, and where the foot of a straight leg goes:\n" + "\n".join(lines))

    def _key_pressed(self) -> bool:
        return bool(self._keyboard.pressed(0.0)) or self._keyboard.gone

    def _ask(self, question: str) -> str:
        """Ask a question. Returns the line that the user types.

        Raises:
            QuadrupedError: if the session or the terminal ends.
        """
        self._session.say(question)
        typed = ""
        for _ in self._session.turns(lambda: 0.0):
            sys.stdout.write(f"{CLEAR_LINE}> {typed}")
            sys.stdout.flush()
            if self._keyboard.gone:
                break
            self._keys.extend(self._keyboard.pressed(POLL_PERIOD))
            while self._keys:
                key = self._keys.popleft()
                if key in "\r\n":
                    sys.stdout.write(f"{CLEAR_LINE}> {typed}\n")
                    return typed.strip()
                typed = typed[:-1] if key in "\x7f\b" else typed + key * (len(key) == 1 and key.isprintable())
        raise QuadrupedError("ended before the map was complete; no file was written")


def parsed_answer(answer: str, joints: Sequence[str]) -> dict[int, float]:
    """Joint -> signed factor, of an answer such as `1+ LF_knee-0.5` or `none`.

    Raises:
        QuadrupedError: if a word names no joint, or is otherwise wrong.
    """
    found: dict[int, float] = {}
    for word in [] if answer == "none" else answer.replace(",", " ").split():
        match = _ANSWER.fullmatch(word)
        named = match["joint"] if match else ""
        fits = [i for i, name in enumerate(joints) if named == str(i + 1) or (named and name.startswith(named))]
        factor = float(f"{match['sign']}{match['factor'] or 1}") if match else 0.0
        if len(fits) != 1 or fits[0] in found or factor == 0.0:
            raise QuadrupedError(
                f"{short(word)}: expected the number or the beginning of a joint's name, + or -, and a factor, each "
                f"joint once"
            )
        found[fits[0]] = factor
    return found


def _problem(robot: Robot, answers: Answers, unit: JointRule) -> str:
    """Return why the answers are no map; empty if they are one."""
    still = [name for i, name in enumerate(robot.joint_names) if not any(i in moved for moved in answers.values())]
    if still:
        return f"no motor moves {', '.join(still)}"
    try:
        _map(robot, answers, unit).to_sources({"position": np.zeros(robot.num_joints)})
    except QuadrupedError as error:
        return str(error)
    return ""


def _map(robot: Robot, answers: Answers, unit: JointRule, offsets: Floats | None = None) -> JointMap:
    """Return the map of the answers.

    Args:
        robot: the robot.
        answers: joints that each motor moves.
        unit: rule with the unit of the motors.
        offsets: of the joints (J,), rad; None: 0.
    """
    rules = {}
    for joint, name in enumerate(robot.joint_names):
        weights = {motor: moved[joint] for motor, moved in answers.items() if joint in moved}
        offset = 0.0 if offsets is None else round(float(offsets[joint]) / unit.factors[0], _DECIMALS[unit.unit])
        if len(weights) == 1:
            ((source, weight),) = weights.items()
            sign, scale = math.copysign(1.0, weight), abs(weight)
            rules[name] = replace(unit, source=source, sign=sign, scale=scale, offset=offset)
        else:
            rules[name] = replace(unit, sources=weights or None, offset=offset)
    return JointMap(rules, "the answers")
