"""The built-in robot."""

from typing import Final

from quadruped_env.robot import facts
from quadruped_env.robot.robot import Robot

_OTHER_SIDE: Final = {"L": "R", "R": "L"}


def _mirror(names: tuple[str, ...]) -> tuple[int, ...]:
    return tuple(names.index(_OTHER_SIDE[name[0]] + name[1:]) for name in names)


MINI_QUADRUPED: Final = Robot(
    name="mini_quadruped",
    leg_names=facts.LEG_NAMES,
    joint_names=facts.JOINT_NAMES,
    link_names=facts.LINK_NAMES,
    joint_position_low=facts.JOINT_POSITION_LOW,
    joint_position_high=facts.JOINT_POSITION_HIGH,
    velocity_limit=facts.VELOCITY_LIMIT,
    effort_limit=facts.EFFORT_LIMIT,
    stance=facts.STANCE,
    stance_height=facts.STANCE_HEIGHT,
    foot_radius=facts.FOOT_RADIUS,
    joint_mirror=_mirror(facts.JOINT_NAMES),
    foot_mirror=_mirror(facts.LEG_NAMES),
)
"""8-joint quadruped of the ROS 2 tutorial; assets/mini_quadruped/README.md derives its masses."""
