"""Settings of the task for tests of its behaviour: the helper that knows the names of the config's fields."""

import math
from typing import Final

PHYSICS_TIMESTEP: Final = 0.005
"""Default of the task, s."""
CLOCK_FREQUENCY: Final = 3.4
"""Default of the task, Hz."""

REWARD_WEIGHTS: Final = {
    "track_forward_velocity": 9.0,
    "track_yaw_rate": 9.0,
    "forward_progress": 9.0,
    "turn_progress": 9.0,
    "steady_error": 0.0,
    "gait_clock": 8.0,
    "contact_clock": 3.0,
    "upright": -10.0,
    "base_motion": -2.0,
    "action_rate": -1.0,
    "electrical_power": -0.04,
    "foot_slip": -2.0,
    "landing": -1.0,
    "stand_still": -5.0,
    "fall": -250.0,
}
"""Weights of the built-in reward terms, per second."""
REWARD_PARAMETERS: Final = {
    "velocity_time_constant": 0.4,  # s
    "contact_threshold": 1.0,  # N
    "forward_velocity_std": 0.07,  # m/s
    "yaw_rate_std": 0.15,  # rad/s
    "foot_lift": 0.012,  # m
    "highest_lift": 0.06,  # m
    "base_arm": 0.2,  # m
}
"""Parameters of the built-in reward terms."""

TRAINING: Final = {
    "timesteps": 1_500_000,
    "num_envs": 256,
    "n_steps": 24,
    "batch_size": 1536,
    "n_epochs": 6,
    "hidden": (128, 128),
    "learning_rate": 1e-3,
    "gamma": 0.985,
    "gae_lambda": 0.95,
    "clip_range": 0.2,
    "ent_coef": 0.0,
    "max_grad_norm": 1.0,
    "log_std_init": -1.0,
    "final_log_std": -2.5,
}
"""Defaults of a training with PPO."""


def settings(
    *,
    fast_control=False,
    never_ends=False,
    max_tilt=None,
    forward_velocity=None,
    yaw_rate=None,
    shares=None,
    resample=None,
    sudden=False,
    still_start=False,
    start_tilt=None,
    friction=None,
    payload=None,
    push_velocity=None,
    push_interval=None,
    noise=None,
    randomization=None,
):
    """The `config` argument of an env; None leaves a field at its default.

    Args:
        fast_control: one physics step per control step, so that a control step takes `PHYSICS_TIMESTEP`.
        never_ends: no fall ends an episode.
        max_tilt: rad; a larger one ends an episode.
        forward_velocity, yaw_rate: ranges of the command, m/s and rad/s.
        shares: of standing and of straight commands; the others are curves, and none turns in place.
        resample: range of the time between commands, s.
        sudden: a new velocity command holds from the next step on, however much it changes.
        still_start: every episode begins in the stance, at rest.
        start_tilt: bound of the roll and of the pitch at the start, rad.
        friction, payload: ranges; payload in kg.
        push_velocity: bound of a push along each axis, m/s.
        push_interval: range of the time between pushes, s.
        noise: of the observations; 1 is the full amplitude.
        randomization: further settings, by name of the randomization.
    """
    standing, straight, turning = (None, None, None) if shares is None else (*shares, 0.0)
    tilt, force = (math.pi, 1e9) if never_ends else (max_tilt, None)
    still = dict.fromkeys(
        ("start_joint_position", "start_joint_velocity", "start_base_velocity", "start_base_rotation"), 0.0
    )
    sections = {
        "command": {
            "forward_velocity": forward_velocity,
            "yaw_rate": yaw_rate,
            "standing_fraction": standing,
            "straight_fraction": straight,
            "turning_fraction": turning,
            "resample_interval": resample,
            "forward_acceleration": 1e6 if sudden else None,
            "yaw_acceleration": 1e6 if sudden else None,
        },
        "termination": {"max_tilt": tilt, "max_trunk_force": force},
        "randomization": {
            **(still if still_start else {}),
            "start_tilt": 0.0 if still_start else start_tilt,
            "friction": friction,
            "payload": payload,
            "push_velocity": push_velocity,
            "push_interval": push_interval,
            "observation_noise": noise,
            **(randomization or {}),
        },
    }
    config = {"decimation": 1} if fast_control else {}
    for name, section in sections.items():
        chosen = {field: value for field, value in section.items() if value is not None}
        if chosen:
            config[name] = chosen
    return config
