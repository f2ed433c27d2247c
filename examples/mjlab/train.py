"""Train this package's robot on its task with mjlab: thousands of robots on a GPU, or a few on the CPU.

    python examples/mjlab/train.py Mini-Quadruped --env.scene.num-envs 4096 --agent.max-iterations 500
    python examples/mjlab/train.py Mini-Quadruped --gpu-ids None --env.scene.num-envs 64    # on the CPU

It takes the arguments of mjlab's own `train`. README.md says how the policy comes back into this package.
"""

import math
import sys
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import mujoco
import torch
from mjlab.actuator import DcMotorActuatorCfg
from mjlab.entity import EntityArticulationInfoCfg, EntityCfg
from mjlab.envs import ManagerBasedRlEnv, ManagerBasedRlEnvCfg, mdp
from mjlab.envs.mdp import dr
from mjlab.envs.mdp.actions import JointPositionActionCfg
from mjlab.managers import (
    EventTermCfg,
    ObservationGroupCfg,
    ObservationTermCfg,
    RewardTermCfg,
    SceneEntityCfg,
    TerminationTermCfg,
)
from mjlab.rl import RslRlModelCfg, RslRlOnPolicyRunnerCfg, RslRlPpoAlgorithmCfg
from mjlab.scene import SceneCfg
from mjlab.scripts.train import main
from mjlab.sensor import ContactMatch, ContactSensorCfg
from mjlab.sim import MujocoCfg, SimulationCfg
from mjlab.tasks.registry import register_mjlab_task
from mjlab.tasks.velocity.mdp import UniformVelocityCommandCfg, feet_slip, illegal_contact, soft_landing
from mjlab.tasks.velocity.rl import VelocityOnPolicyRunner
from mjlab.terrains import TerrainEntityCfg
from mjlab.utils.noise import UniformNoiseCfg

MJCF = Path(__file__).resolve().parents[2] / "assets" / "mini_quadruped" / "mini_quadruped.xml"


def _numbers(path: str, attribute: str) -> list[float]:
    """Numbers of an attribute of the MJCF's element at a path."""
    return [float(word) for word in ElementTree.parse(MJCF).find(path).get(attribute).split()]  # noqa: S314


HOME = _numbers("keyframe/key", "qpos")
LEGS = ("LF", "RF", "LH", "RH")
JOINTS = [f"{leg}_{kind}_joint" for leg in LEGS for kind in ("hip", "knee")]
LIMITS = {kind: tuple(_numbers(f".//default[@class='{kind}']/joint", "range")) for kind in ("hip", "knee")}
_, STALL_TORQUE, NO_LOAD_SPEED = _numbers(".//default[@class='hip']/dcmotor", "nominal")
KP, _, KD = _numbers(".//default[@class='hip']/dcmotor", "controller")[:3]
HEAT = NO_LOAD_SPEED / STALL_TORQUE
"""Heat of a motor per squared torque, R / K^2, W/(N m)^2, with K = voltage / speed and R = voltage K / torque."""
FOOT_RADIUS = 0.02  # m
LEG_PHASES = (0.0, math.pi, math.pi, 0.0)  # rad: a trot

CLOCK_FREQUENCY = 3.4  # Hz
TIMESTEP, DECIMATION = 0.005, 4  # s
STEP = TIMESTEP * DECIMATION


def robot_spec() -> mujoco.MjSpec:
    """The robot without its motors, which MuJoCo 3.11 cannot read, and without the sensors of their torques."""
    root = ElementTree.parse(MJCF).getroot()  # noqa: S314
    for parent in list(root.iter()):
        for child in list(parent):
            if child.tag in {"dcmotor", "actuator", "sensor", "keyframe"}:
                parent.remove(child)
    spec = mujoco.MjSpec.from_string(ElementTree.tostring(root, encoding="unicode"))
    for geom in spec.geoms:
        if geom.name.endswith("_collision"):
            geom.priority = 1  # its friction counts, not the ground's in mjlab
    return spec


# The same line of torque over speed as the package's motors.
LINE = {"effort_limit": STALL_TORQUE, "saturation_effort": STALL_TORQUE, "velocity_limit": NO_LOAD_SPEED}
MOTORS = DcMotorActuatorCfg(target_names_expr=(".*_joint",), stiffness=KP, damping=KD, **LINE)
ROBOT = EntityCfg(
    spec_fn=robot_spec,
    init_state=EntityCfg.InitialStateCfg(pos=tuple(HOME[:3]), joint_pos=dict(zip(JOINTS, HOME[7:], strict=True))),
    articulation=EntityArticulationInfoCfg(actuators=(MOTORS,)),
)
ALL_JOINTS = SceneEntityCfg("robot", joint_names=(".*",))
SHAPES = SceneEntityCfg("robot", geom_names=(".*_collision",))
FEET = SceneEntityCfg("robot", site_names=tuple(f"{leg}_foot" for leg in LEGS), preserve_order=True)


def command(env: ManagerBasedRlEnv) -> torch.Tensor:
    """Commanded forward velocity and yaw rate (N, 2), m/s and rad/s."""
    return env.command_manager.get_command("twist")[:, [0, 2]]


def moving(env: ManagerBasedRlEnv) -> torch.Tensor:
    """1 where a motion is commanded, else 0, (N,)."""
    return (command(env).abs() > 0.02).any(dim=1).float()


def phase(env: ManagerBasedRlEnv) -> torch.Tensor:
    """Phase of the gait clock (N, 1), rad."""
    return (math.tau * CLOCK_FREQUENCY * STEP * env.episode_length_buf)[:, None]


def leg_clock(env: ManagerBasedRlEnv) -> torch.Tensor:
    """Sine of each leg's phase (N, 4); positive while the foot should swing."""
    return torch.sin(phase(env) + torch.tensor(LEG_PHASES, device=env.device))


def gait_clock(env: ManagerBasedRlEnv) -> torch.Tensor:
    """Sine and cosine of the clock's phase (N, 2), 0 where standing is commanded."""
    return torch.cat([torch.sin(phase(env)), torch.cos(phase(env))], dim=1) * moving(env)[:, None]


def _term(func: object, scale: float = 1.0, bound: float = 1.0, noise: float = 0.0) -> ObservationTermCfg:
    """An observation: noise in the reading's unit, then the scale, within +-bound."""
    added = UniformNoiseCfg(n_min=-noise, n_max=noise) if noise else None
    return ObservationTermCfg(func=func, scale=scale, clip=(-bound / scale, bound / scale), noise=added)


# The package's layout with observation_history 1.
OBSERVATIONS = {
    "projected_gravity": _term(mdp.projected_gravity, noise=0.02),
    "angular_velocity": _term(mdp.base_ang_vel, 0.25, 4.0, noise=0.1),
    "joint_position": _term(mdp.joint_pos_rel, 1.0, 2.1, noise=0.01),
    "joint_velocity": _term(mdp.joint_vel_rel, 1.0 / NO_LOAD_SPEED, 3.0, noise=0.3),
    "last_action": _term(mdp.last_action),
    "command": _term(command, 4.0, 4.0),
    "gait_clock": _term(gait_clock),
}


def tracking(velocity: torch.Tensor, asked: torch.Tensor, std: float) -> torch.Tensor:
    """exp(-(error / std)^2)."""
    return torch.exp(-(((velocity - asked) / std) ** 2))


def progress(velocity: torch.Tensor, asked: torch.Tensor, smallest: float) -> torch.Tensor:
    """Share of the command that is reached, less twice what is beyond it, at least -1."""
    size = asked.abs().clamp(min=smallest)
    share, whole = velocity * asked.sign() / size, asked.abs() / size
    return (share - 2.0 * (share - whole).clamp(min=0.0)).clamp(min=-1.0)


class OfVelocity:
    """A term of the average velocity over about one gait cycle, of one axis: 0 forwards, 1 yaw."""

    def __init__(self, cfg: RewardTermCfg, env: ManagerBasedRlEnv) -> None:
        self.velocity = torch.zeros(env.num_envs, 2, device=env.device)

    def reset(self, env_ids: torch.Tensor | slice | None = None) -> None:
        """Begin again with robots at rest."""
        self.velocity[slice(None) if env_ids is None else env_ids] = 0.0

    def __call__(
        self, env: ManagerBasedRlEnv, score: Callable[..., torch.Tensor], axis: int, width: float
    ) -> torch.Tensor:
        """Score (N,) of the velocity."""
        data = env.scene["robot"].data
        now = torch.stack([data.root_link_lin_vel_b[:, 0], data.root_link_ang_vel_b[:, 2]], dim=1)
        self.velocity += (1.0 - math.exp(-STEP / 0.4)) * (now - self.velocity)
        return score(self.velocity[:, axis], command(env)[:, axis], width)


def feet_follow_clock(env: ManagerBasedRlEnv, asset_cfg: SceneEntityCfg, lift: float) -> torch.Tensor:
    """Mean over the feet of clock times 1 - 2 (1 - height / lift)^2, at least -1."""
    height = env.scene["robot"].data.site_pos_w[:, asset_cfg.site_ids, 2] - FOOT_RADIUS
    lifted = (1.0 - 2.0 * (1.0 - height / lift) ** 2).clamp(min=-1.0)
    return (leg_clock(env) * lifted).mean(dim=1) * moving(env)


def contacts_follow_clock(env: ManagerBasedRlEnv) -> torch.Tensor:
    """Mean over the feet of clock times 1 - 2 contact."""
    contact = (env.scene["feet"].data.force.norm(dim=-1) > 1.0).float()
    return (leg_clock(env) * (1.0 - 2.0 * contact)).mean(dim=1) * moving(env)


def base_motion(env: ManagerBasedRlEnv) -> torch.Tensor:
    """v_y^2 + v_z^2 + (0.2 m)^2 (w_x^2 + w_y^2)."""
    data = env.scene["robot"].data
    across, tumbling = data.root_link_lin_vel_b[:, 1:] ** 2, data.root_link_ang_vel_b[:, :2] ** 2
    return across.sum(dim=1) + 0.2**2 * tumbling.sum(dim=1)


def electrical_power(env: ManagerBasedRlEnv) -> torch.Tensor:
    """Positive mechanical power and heat of the motors at the end of the step, W."""
    data = env.scene["robot"].data
    torque = data.qfrc_actuator
    return ((torque * data.joint_vel).clamp(min=0.0) + HEAT * torque**2).sum(dim=1)


def stand_still(env: ManagerBasedRlEnv) -> torch.Tensor:
    """Squared distance of the joints from the stance while standing is commanded."""
    return (mdp.joint_pos_rel(env) ** 2).sum(dim=1) * (1.0 - moving(env))


def _of_velocity(score: Callable, axis: int, width: float) -> RewardTermCfg:
    return RewardTermCfg(func=OfVelocity, weight=9.0, params={"score": score, "axis": axis, "width": width})


GROUND = {"sensor_name": "feet", "command_name": "twist"}
# The package's terms, with its weights per second.
REWARDS = {
    "track_forward_velocity": _of_velocity(tracking, 0, 0.07),
    "track_yaw_rate": _of_velocity(tracking, 1, 0.15),
    "forward_progress": _of_velocity(progress, 0, 0.1),
    "turn_progress": _of_velocity(progress, 1, 0.2),
    "gait_clock": RewardTermCfg(func=feet_follow_clock, weight=8.0, params={"asset_cfg": FEET, "lift": 0.012}),
    "contact_clock": RewardTermCfg(func=contacts_follow_clock, weight=3.0),
    "upright": RewardTermCfg(func=mdp.flat_orientation_l2, weight=-10.0),
    "base_motion": RewardTermCfg(func=base_motion, weight=-2.0),
    "action_rate": RewardTermCfg(func=mdp.action_rate_l2, weight=-1.0),
    "electrical_power": RewardTermCfg(func=electrical_power, weight=-0.04),
    # mjlab's own: the speed of the feet's centres, and the force of a landing.
    "foot_slip": RewardTermCfg(func=feet_slip, weight=-2.0, params={**GROUND, "asset_cfg": FEET}),
    "landing": RewardTermCfg(func=soft_landing, weight=-1e-3, params=GROUND),
    "stand_still": RewardTermCfg(func=stand_still, weight=-5.0),
    "fall": RewardTermCfg(func=mdp.is_terminated, weight=-250.0),
}


def _contacts(name: str, geoms: str, **options: object) -> ContactSensorCfg:
    """Forces of the ground on some of the robot's shapes, N."""
    shapes, ground = ContactMatch("geom", geoms, "robot"), ContactMatch("body", "terrain")
    return ContactSensorCfg(name=name, primary=shapes, secondary=ground, reduce="netforce", **options)


def env_cfg() -> ManagerBasedRlEnvCfg:
    """The task on level ground."""
    tilt, turn, speed = (-0.05, 0.05), (-math.pi, math.pi), (-0.2, 0.2)
    start = {"pose_range": {"roll": tilt, "pitch": tilt, "yaw": turn}, "velocity_range": dict.fromkeys("xyz", speed)}
    joints = {"position_range": (-0.1, 0.1), "velocity_range": (-0.5, 0.5), "asset_cfg": ALL_JOINTS}
    friction = {"asset_cfg": SHAPES, "operation": "abs", "ranges": (0.5, 1.1), "shared_random": True}
    every = {"interval_range_s": (2.0, 4.0)}
    push = {"velocity_range": {"x": (-0.5, 0.5), "y": (-0.5, 0.5), "yaw": (-0.8, 0.8)}}
    events = {
        "base": EventTermCfg(func=mdp.reset_root_state_uniform, mode="reset", params=start),
        "joints": EventTermCfg(func=mdp.reset_joints_by_offset, mode="reset", params=joints),
        "friction": EventTermCfg(func=dr.geom_friction, mode="startup", params=friction),
        "push": EventTermCfg(func=mdp.push_by_setting_velocity, mode="interval", params=push, **every),
    }
    limits = {f".*_{kind}_joint": limit for kind, limit in LIMITS.items()}
    actions = JointPositionActionCfg(entity_name="robot", actuator_names=(".*",), scale=0.6, clip=limits)
    ranges = UniformVelocityCommandCfg.Ranges(lin_vel_x=(-0.3, 0.6), lin_vel_y=(0.0, 0.0), ang_vel_z=(-0.8, 0.8))
    often = {"resampling_time_range": (1.0, 5.0), "rel_standing_envs": 0.1, "heading_command": False}
    twist = UniformVelocityCommandCfg(entity_name="robot", ranges=ranges, **often)
    privileged = {"base_velocity": ObservationTermCfg(func=mdp.base_lin_vel)}
    trunk = {"sensor_name": "trunk", "force_threshold": 1.0}
    fallen = {
        "tilted": TerminationTermCfg(func=mdp.bad_orientation, params={"limit_angle": 1.0}),
        "trunk_contact": TerminationTermCfg(func=illegal_contact, params=trunk),
    }
    return ManagerBasedRlEnvCfg(
        decimation=DECIMATION,
        episode_length_s=20.0,
        sim=SimulationCfg(mujoco=MujocoCfg(timestep=TIMESTEP, cone="elliptic", iterations=10, ls_iterations=20)),
        scene=SceneCfg(
            num_envs=4096,
            terrain=TerrainEntityCfg(terrain_type="plane"),
            entities={"robot": ROBOT},
            sensors=(
                _contacts("feet", ".*_leg_collision", track_air_time=True),
                _contacts("trunk", "(base|.*_hip)_collision", history_length=DECIMATION),
            ),
        ),
        actions={"joint_pos": actions},
        commands={"twist": twist},
        observations={
            "actor": ObservationGroupCfg(terms=OBSERVATIONS, enable_corruption=True),
            "critic": ObservationGroupCfg(terms=OBSERVATIONS | privileged),
        },
        rewards=REWARDS,
        terminations={"time_out": TerminationTermCfg(func=mdp.time_out, time_out=True), **fallen},
        events=events,
    )


def rl_cfg() -> RslRlOnPolicyRunnerCfg:
    """PPO of rsl_rl, with the package's discounts; the normalization of observations is a part of the ONNX file."""
    network = {"hidden_dims": (128, 128), "activation": "elu", "obs_normalization": True}
    exploration = {"class_name": "GaussianDistribution", "init_std": 0.4, "std_type": "scalar"}
    return RslRlOnPolicyRunnerCfg(
        actor=RslRlModelCfg(**network, distribution_cfg=exploration),
        critic=RslRlModelCfg(**network),
        algorithm=RslRlPpoAlgorithmCfg(gamma=0.985, lam=0.95, entropy_coef=0.0, num_learning_epochs=6),
        clip_actions=1.0,
        experiment_name="mini_quadruped",
        logger="tensorboard",
        upload_model=False,
    )


register_mjlab_task("Mini-Quadruped", env_cfg(), env_cfg(), rl_cfg(), VelocityOnPolicyRunner)

if __name__ == "__main__":
    sys.exit(main())
