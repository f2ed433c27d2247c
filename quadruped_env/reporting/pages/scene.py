"""An episode in three dimensions, as one HTML document in which it plays and can be turned: viser's own player.

It needs no OpenGL on the machine that makes it, and no network where it is looked at.
"""

import contextlib
import io
from typing import Final

import mujoco
import numpy as np

from quadruped_env.errors import MissingExtraError
from quadruped_env.reporting.films.film import FRAME_RATE, Motion, steady_way
from quadruped_env.robot import load_model

_CAMERA: Final = (0.65, -0.85, 0.42)
"""m from the robot, which comes out of the picture a little"""
_LOOK_AT: Final = (0.0, 0.0, 0.06)
_PORT: Final = 8090
"""Where to begin to look for a free port: viser cannot record without a server, which listens on the loopback only,
for the moment that the recording takes"""


def scene_html(motion: Motion) -> str:
    """A page that plays a motion; the robot stays in the middle and the ground goes by beneath it.

    Raises:
        MissingExtraError: if viser or mjviser is not installed.
    """
    try:
        import viser
        from mjviser import ViserMujocoScene
    except ImportError as error:
        raise MissingExtraError("The 3D replay", "viewer") from error

    model = load_model()
    data = mujoco.MjData(model)
    # Its banner says where to look, and there is nothing to look at.
    with contextlib.redirect_stdout(io.StringIO()):
        server = viser.ViserServer(host="127.0.0.1", port=_PORT, verbose=False)
    try:
        scene = ViserMujocoScene(server, model, num_envs=1)
        scene.camera_tracking_enabled = False
        server.initial_camera.position = _CAMERA
        server.initial_camera.look_at = _LOOK_AT
        server.initial_camera.fov = np.radians(40.0)
        recording = server.get_scene_serializer()
        for sample in motion.frame_samples():
            way = steady_way(motion, sample)
            data.qpos[:7], data.qpos[7:] = motion.base_pose[sample], motion.joint_position[sample]
            data.qpos[:2] -= way
            mujoco.mj_kinematics(model, data)
            scene.update_from_mjdata(data)
            scene.fixed_bodies_frame.position = (-way[0], -way[1], 0.0)
            recording.insert_sleep(1.0 / FRAME_RATE)
        return recording.as_html()
    finally:
        with contextlib.redirect_stdout(io.StringIO()):
            server.stop()
