"""Numbers of the built-in robot under short names."""

from quadruped_env.robot import MINI_QUADRUPED

LINK_NAMES = MINI_QUADRUPED.link_names
STANCE = MINI_QUADRUPED.stance
STANCE_HEIGHT = MINI_QUADRUPED.stance_height
FOOT_RADIUS = MINI_QUADRUPED.foot_radius
JOINT_POSITION_LOW = MINI_QUADRUPED.joint_position_low
JOINT_POSITION_HIGH = MINI_QUADRUPED.joint_position_high
VELOCITY_LIMIT = float(MINI_QUADRUPED.velocity_limit[0])
EFFORT_LIMIT = float(MINI_QUADRUPED.effort_limit[0])
TOTAL_MASS = MINI_QUADRUPED.total_mass
