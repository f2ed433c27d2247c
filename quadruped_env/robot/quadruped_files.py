"""Model files of a `QuadrupedDesign`: MJCF for MuJoCo and URDF for ROS.

assets/mini_quadruped/README.md explains the choices for motors, contacts, sensors and the solver.
"""

from collections.abc import Iterable, Sequence
from typing import Final

from quadruped_env.robot.motors import GEAR_RATIO, JOINT_KINDS, VOLTAGE, JointMotor
from quadruped_env.robot.quadruped_dimensions import QuadrupedDimensions

IMU: Final = "imu"
"""Name of the IMU in the MJCF and in the URDF's `<ros2_control>`."""

_FRONT_SHARE: Final = 0.1
"""Length of the mark at the front of the base, relative to the base."""
_PROUD: Final = 0.001
"""Distance by which the mark stands out from the base, so that it is drawn in front of it, m."""
_COLOURS: Final = {
    "gray": "0.5 0.5 0.5 1",
    "blue": "0.2 0.3 0.8 1",
    "black": "0.1 0.1 0.1 1",
    "yellow": "0.94 0.89 0.26 1",
}
"""Name -> red, green, blue and opacity. The first three are the tutorial's; yellow marks the front."""


def number(value: float) -> str:
    """A number as the files state it: 15 digits, which are enough for dimensions that are given as decimals."""
    return f"{value + 0.0:.15g}"  # + 0.0 turns -0.0 into 0.0


def numbers(*values: float) -> str:
    """Numbers, separated by spaces."""
    return " ".join(number(float(value)) for value in values)


def mjcf(design: QuadrupedDimensions) -> str:
    """The robot alone: bodies, joints, motors, sensors, home keyframe; the ground is in scene.xml."""
    joints = design.joint_names
    stance = "  ".join(numbers(*design.stance_angles) for _ in design.leg_names)
    sides = sorted({leg[0] for leg in design.leg_names})
    pairs = [[leg for leg in design.leg_names if leg[0] == side] for side in sides]
    return f"""\
<!-- Written by quadruped_env/robot/quadruped_files.py: edit the design there, not this file.
     The robot alone: bodies, joints, motors, sensors, home keyframe. The ground is in scene.xml.
     Units are SI (m, kg, s, rad, N, N m, V). assets/mini_quadruped/README.md derives the built-in ones. -->
<mujoco model="{design.name}">
  <compiler angle="radian" autolimits="true"/>

  <!-- README.md, "Time step and solver", measures this choice against a five times finer step. -->
  <option timestep="0.005" integrator="implicitfast" cone="elliptic" iterations="10" ls_iterations="20">
    <!-- One robot of few shapes is one island: looking for islands and bounding volumes costs 8 %, for nothing. -->
    <flag island="disable" midphase="disable"/>
  </option>
  <size memory="256K"/>

  <default>
    <default class="{design.name}">
      <default class="visual">
        <geom contype="0" conaffinity="0" group="2" mass="0"/>
      </default>
      <!-- Robot geoms meet the ground only; the two leg pairs that can reach each other are named in <contact>. -->
      <default class="collision">
        <geom contype="1" conaffinity="0" group="3" condim="3" friction="{numbers(design.friction, 0.005, 0.0001)}" \
solref="0.01 1" mass="0" rgba="0.9 0.4 0.1 0.4"/>
      </default>
      <!-- nominal: supply voltage, stall torque, no-load speed. The controller's last number limits its voltage to the
           supply's: that limit is what makes the torque-speed line, saturation limits the braking side. -->
{_motor_class("hip", design.motors.hip, design.hip_range)}
{_motor_class("knee", design.motors.knee, design.knee_range)}
      <!-- Zones whose contact forces the touch sensors add up: a little larger than the surface they watch. -->
      <default class="touch_site">
        <site group="4" rgba="0.9 0.1 0.1 0.2"/>
        <default class="foot_site">
          <site type="sphere" size="{number(design.leg_radius + 0.005)}" pos="{numbers(0, 0, design.foot_height)}"/>
        </default>
      </default>
    </default>
  </default>

  <asset>
{_join(f'    <material name="{name}" rgba="{colour}"/>' for name, colour in _COLOURS.items())}
  </asset>

  <worldbody>
    <body name="base_link" childclass="{design.name}" pos="{numbers(0, 0, design.stance_height)}">
      <freejoint name="floating_base"/>
      <inertial pos="0 0 0" mass="{number(design.base_mass)}" diaginertia="{numbers(*design.base_inertia)}"/>
      <geom name="base_visual" class="visual" type="box" size="{_half(design.base_size)}" material="gray"/>
      <geom name="front_visual" class="visual" type="box" size="{_half(_front_size(design))}" \
pos="{_front_centre(design)}" material="yellow"/>
      <geom name="base_collision" class="collision" type="box" size="{_half(design.base_size)}"/>
      <site name="imu" group="4" size="0.01"/>
      <site name="base_touch" class="touch_site" type="box" size="{_half(design.base_size, 0.01)}"/>
      <camera name="track" pos="0 -1.0 0.35" xyaxes="1 0 0 0 0.3 1" mode="trackcom"/>
{_join(_mjcf_leg(design, leg) for leg in design.leg_names)}
    </body>
  </worldbody>

  <contact>
{_join(f'    <pair geom1="{a}_leg_collision" geom2="{b}_leg_collision" condim="1"/>' for a, b in pairs)}
  </contact>

  <actuator>
{_join(f'    <dcmotor name="{name}" joint="{name}" class="{_kind(name)}"/>' for name in joints)}
  </actuator>

  <sensor>
    <!-- What a real robot measures: encoders, motor current (as torque), IMU, foot switches. -->
{_sensors("jointpos", joints, "position", "joint")}
{_sensors("jointvel", joints, "velocity", "joint")}
{_sensors("actuatorfrc", joints, "torque", "actuator")}
    <framequat name="imu_orientation" objtype="site" objname="imu"/>
    <gyro name="imu_angular_velocity" site="imu"/>
    <accelerometer name="imu_linear_acceleration" site="imu"/>
{_join(f'    <touch name="{leg}_foot_force" site="{leg}_foot"/>' for leg in design.leg_names)}
    <!-- What only a simulator knows: for rewards and reports, never for the policy. -->
    <touch name="base_contact_force" site="base_touch"/>
{_join(f'    <touch name="{leg}_hip_contact_force" site="{leg}_hip_touch"/>' for leg in design.leg_names)}
    <framepos name="base_position" objtype="site" objname="imu"/>
    <framezaxis name="world_up" objtype="body" objname="world" reftype="site" refname="imu"/>
    <velocimeter name="base_linear_velocity" site="imu"/>
{_foot_sensors("framepos", design.leg_names, "position")}
{_foot_sensors("framelinvel", design.leg_names, "velocity")}
{_foot_sensors("frameangvel", design.leg_names, "angular_velocity")}
  </sensor>

  <keyframe>
    <!-- The stance: each foot under its hip, soles on the ground. -->
    <key name="home" qpos="{numbers(0, 0, design.stance_height, 1, 0, 0, 0)}  {stance}"
         ctrl="{stance}"/>
  </keyframe>
</mujoco>
"""


def urdf(design: QuadrupedDimensions) -> str:
    """The robot for ROS and other simulators: links, joints, limits, inertia, collision, and its drives."""
    joints = design.joint_names
    return f"""\
<?xml version="1.0"?>
<!-- Written by quadruped_env/robot/quadruped_files.py: edit the design there, not this file.
     A robot like that of the ROS 2 tutorial, with the inertia, collision and drives that it leaves out; the MJCF of the
     same name is the same robot for MuJoCo. assets/mini_quadruped/README.md derives the built-in robot's numbers. -->
<robot name="{design.name}" xmlns:drake="http://drake.mit.edu">
{_join(f'  <material name="{name}"><color rgba="{colour}"/></material>' for name, colour in _COLOURS.items())}

{_urdf_base(design)}

{(chr(10) * 2).join(_urdf_leg(design, leg) for leg in design.leg_names)}

  <!-- Drives, for Drake. Inertia of a rotor at its joint: rotor_inertia * gear_ratio^2, kg m^2. -->
{_join(_transmission(name, _motor(design, name)) for name in joints)}

  <!-- The same drives for ros2_control; put the plugin of your hardware or simulator in place of the mock. kp (N m/rad)
       and kd (N m s/rad) are the gains of the position servo, within the limits of effort and velocity. -->
  <ros2_control name="{design.name}" type="system">
    <hardware>
      <plugin>mock_components/GenericSystem</plugin>
    </hardware>
{_join(_ros2_control_joint(name, _range(design, name), _motor(design, name)) for name in joints)}
{_ros2_control_imu()}
{_join(_ros2_control_transmission(name) for name in joints)}
  </ros2_control>
</robot>
"""


def _join(lines: Iterable[str]) -> str:
    return "\n".join(lines)


def _kind(joint: str) -> str:
    return next(kind for kind in JOINT_KINDS if f"_{kind}_" in joint)


def _motor(design: QuadrupedDimensions, joint: str) -> JointMotor:
    return design.motors.of_joints([_kind(joint)])[0]


def _range(design: QuadrupedDimensions, joint: str) -> tuple[float, float]:
    return design.hip_range if _kind(joint) == "hip" else design.knee_range


def _half(size: Sequence[float], margin: float = 0.0) -> str:
    return numbers(*(0.5 * length + margin for length in size))


def _motor_class(kind: str, motor: JointMotor, joint_range: tuple[float, float]) -> str:
    friction = f' frictionloss="{number(motor.friction_loss)}"' if motor.friction_loss else ""
    return f"""\
      <default class="{kind}">
        <joint axis="0 1 0" range="{numbers(*joint_range)}" armature="{number(motor.armature)}" \
damping="{number(motor.damping)}"{friction}/>
        <dcmotor input="pos" ctrlrange="{numbers(*joint_range)}" \
nominal="{numbers(VOLTAGE, motor.stall_torque, motor.no_load_speed)}" \
saturation="{numbers(motor.stall_torque, 0, 0)}" controller="{numbers(motor.kp, 0, motor.kd, 0, 0, VOLTAGE)}"/>
      </default>"""


def _mjcf_leg(design: QuadrupedDimensions, leg: str) -> str:
    radius, length = design.leg_radius, design.leg_length
    centre = numbers(0, 0, -0.5 * length)
    return f"""\
      <body name="{leg}_hip" pos="{numbers(*design.hip_position(leg), 0)}">
        <inertial pos="0 0 0" mass="{number(design.hip_mass)}" diaginertia="{numbers(*design.hip_inertia)}"/>
        <joint name="{leg}_hip_joint" class="hip"/>
        <geom class="visual" type="sphere" size="{number(design.hip_radius)}" material="blue"/>
        <geom name="{leg}_hip_collision" class="collision" type="sphere" size="{number(design.hip_radius)}"/>
        <site name="{leg}_hip_touch" class="touch_site" type="sphere" size="{number(design.hip_radius + 0.005)}"/>
        <body name="{leg}_leg" pos="{numbers(0, 0, -design.hip_to_knee)}">
          <inertial pos="{centre}" mass="{number(design.leg_mass)}" diaginertia="{numbers(*design.leg_inertia)}"/>
          <joint name="{leg}_knee_joint" class="knee"/>
          <geom class="visual" type="capsule" size="{number(radius)}" \
fromto="{numbers(0, 0, 0, 0, 0, design.foot_height)}" material="black"/>
          <geom name="{leg}_leg_collision" class="collision" type="capsule" size="{number(radius)}" \
fromto="{numbers(0, 0, -radius, 0, 0, design.foot_height)}"/>
          <site name="{leg}_foot" class="foot_site"/>
        </body>
      </body>"""


def _sensors(kind: str, joints: Sequence[str], reading: str, target: str) -> str:
    return _join(f'    <{kind} name="{name.removesuffix("_joint")}_{reading}" {target}="{name}"/>' for name in joints)


def _foot_sensors(kind: str, legs: Sequence[str], reading: str) -> str:
    return _join(f'    <{kind} name="{leg}_foot_{reading}" objtype="site" objname="{leg}_foot"/>' for leg in legs)


def _front_size(design: QuadrupedDimensions) -> tuple[float, float, float]:
    """Size of the mark around the front end of the base along x, y and z, m."""
    length, width, height = design.base_size
    return _FRONT_SHARE * length + _PROUD, width + 2.0 * _PROUD, height + 2.0 * _PROUD


def _front_centre(design: QuadrupedDimensions) -> str:
    return numbers(0.5 * (design.base_size[0] - _front_size(design)[0]) + _PROUD, 0, 0)


def _urdf_base(design: QuadrupedDimensions) -> str:
    front = f"""
    <!-- A mark around the front end. -->
{_urdf_visual(f'box size="{numbers(*_front_size(design))}"', "yellow", _front_centre(design))}"""
    shape = f'box size="{numbers(*design.base_size)}"'
    return _urdf_link("base_link", shape, "gray", design.base_mass, design.base_inertia, front)


def _urdf_visual(shape: str, material: str, origin: str | None = None) -> str:
    place = "" if origin is None else f'\n      <origin xyz="{origin}" rpy="0 0 0"/>'
    return f"""\
    <visual>{place}
      <geometry><{shape}/></geometry>
      <material name="{material}"/>
    </visual>"""


def _urdf_link(
    name: str, shape: str, material: str, mass: float, inertia: Iterable[float], more_visuals: str = ""
) -> str:
    return f"""\
  <link name="{name}">
{_urdf_visual(shape, material)}{more_visuals}
    <collision>
      <geometry><{shape}/></geometry>
    </collision>
    <inertial>
      <mass value="{number(mass)}"/>
      <inertia {_urdf_inertia(inertia)}/>
    </inertial>
  </link>"""


def _urdf_inertia(moments: Iterable[float]) -> str:
    xx, yy, zz = (number(moment) for moment in moments)
    return f'ixx="{xx}" iyy="{yy}" izz="{zz}" ixy="0" ixz="0" iyz="0"'


def _urdf_joint(name: str, links: tuple[str, str], origin: str, limits: tuple[float, float], motor: JointMotor) -> str:
    return f"""\
  <joint name="{name}" type="revolute">
    <parent link="{links[0]}"/>
    <child link="{links[1]}"/>
    <origin xyz="{origin}" rpy="0 0 0"/>
    <axis xyz="0 1 0"/>
    <limit lower="{number(limits[0])}" upper="{number(limits[1])}" effort="{number(motor.stall_torque)}" \
velocity="{number(motor.no_load_speed)}"/>
    <dynamics damping="{number(motor.damping)}" friction="{number(motor.friction_loss)}"/>
  </joint>"""


def _transmission(joint: str, motor: JointMotor) -> str:
    # Without mechanicalReduction, which Drake warns about: its actuators act at the joint.
    return f"""\
  <transmission name="{joint}_transmission">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="{joint}"/>
    <actuator name="{joint}_motor">
      <drake:rotor_inertia value="{number(motor.rotor_inertia)}"/>
      <drake:gear_ratio value="{number(GEAR_RATIO)}"/>
    </actuator>
  </transmission>"""


def _ros2_control_joint(joint: str, limits: tuple[float, float], motor: JointMotor) -> str:
    return f"""\
    <joint name="{joint}">
      <command_interface name="position">
        <param name="min">{number(limits[0])}</param>
        <param name="max">{number(limits[1])}</param>
      </command_interface>
      <state_interface name="position"/>
      <state_interface name="velocity"/>
      <state_interface name="effort"/>
      <param name="kp">{number(motor.kp)}</param>
      <param name="kd">{number(motor.kd)}</param>
    </joint>"""


def _ros2_control_imu() -> str:
    """The ten state interfaces from which `imu_sensor_broadcaster` makes a message."""
    names = [f"orientation.{axis}" for axis in "xyz"]
    names += [f"{quantity}.{axis}" for quantity in ("angular_velocity", "linear_acceleration") for axis in "xyz"]
    return f"""\
    <sensor name="{IMU}">
      <!-- With this value, mock hardware is level. -->
      <state_interface name="orientation.w"><param name="initial_value">1</param></state_interface>
{_join(f'      <state_interface name="{name}"/>' for name in names)}
    </sensor>"""


def _ros2_control_transmission(joint: str) -> str:
    return f"""\
    <transmission name="{joint}_transmission">
      <plugin>transmission_interface/SimpleTransmission</plugin>
      <actuator name="{joint}_motor" role="actuator1"/>
      <joint name="{joint}" role="joint1">
        <mechanical_reduction>{number(GEAR_RATIO)}</mechanical_reduction>
      </joint>
    </transmission>"""


def _urdf_leg(design: QuadrupedDimensions, leg: str) -> str:
    radius, length = design.leg_radius, design.leg_length
    centre = numbers(0, 0, -0.5 * length)
    shank_centre, foot = numbers(0, 0, 0.5 * design.foot_height), numbers(0, 0, design.foot_height)
    ball = f'sphere radius="{number(radius)}"'
    hip, shank = f"{leg}_hip", f"{leg}_leg"
    hip_origin, knee_origin = numbers(*design.hip_position(leg), 0), numbers(0, 0, -design.hip_to_knee)
    return f"""\
{_urdf_link(hip, f'sphere radius="{number(design.hip_radius)}"', "blue", design.hip_mass, design.hip_inertia)}
{_urdf_joint(f"{leg}_hip_joint", ("base_link", hip), hip_origin, design.hip_range, design.motors.hip)}
  <link name="{shank}">
    <!-- URDF has no capsule: a cylinder for the shank, and a sphere for the rounded foot at its lower end. The drawn
         shank is rounded at the knee too. -->
{_urdf_visual(f'cylinder radius="{number(radius)}" length="{number(-design.foot_height)}"', "black", shank_centre)}
{_urdf_visual(ball, "black", foot)}
{_urdf_visual(ball, "black")}
    <collision>
      <origin xyz="{centre}" rpy="0 0 0"/>
      <geometry><cylinder radius="{number(radius)}" length="{number(length - 2.0 * radius)}"/></geometry>
    </collision>
    <collision>
      <origin xyz="{foot}" rpy="0 0 0"/>
      <geometry><{ball}/></geometry>
    </collision>
    <inertial>
      <origin xyz="{centre}" rpy="0 0 0"/>
      <mass value="{number(design.leg_mass)}"/>
      <inertia {_urdf_inertia(design.leg_inertia)}/>
    </inertial>
  </link>
{_urdf_joint(f"{leg}_knee_joint", (hip, shank), knee_origin, design.knee_range, design.motors.knee)}"""
