"""3D replay of an episode as a self-contained HTML document, with viser's player.

Making it does not need OpenGL; viewing it does not need a network.
"""

import contextlib
import io
from typing import Final

import mujoco
import numpy as np

from quadruped_env.errors import MissingExtraError
from quadruped_env.reporting.films.film import FRAME_RATE, Clip, size_of, smoothed_position
from quadruped_env.reporting.ground_mesh import floor_offset, ground_mesh, robot_scene
from quadruped_env.simulation import build_model
from quadruped_env.simulation.height_field import HeightField

_CAMERA: Final = (0.65, -0.85, 0.42)
"""Camera position relative to a robot of size 1, m: the robot walks slightly towards the viewer."""
_LOOK_AT: Final = (0.0, 0.0, 0.06)
"""Point that the camera looks at, relative to a robot of size 1, m."""
_PORT: Final = 8090
"""First port to try. Viser cannot record without a server; it listens on the loopback interface only, and only while
the recording is made."""


def scene_html(clip: Clip) -> str:
    """HTML page that plays a clip; the robot stays in the middle and the ground moves beneath it.

    Raises:
        MissingExtraError: if viser or mjviser is not installed.
    """
    try:
        import mjviser  # noqa: F401
        import viser
    except ImportError as error:
        raise MissingExtraError("The 3D replay", "viewer") from error

    trace = clip.trace
    model = build_model(terrain=trace.terrain, robot=trace.robot)
    field = HeightField.of(model)
    data = mujoco.MjData(model)
    # Suppress viser's banner: its URL is of no use, because the server stops at once.
    with contextlib.redirect_stdout(io.StringIO()):
        server = viser.ViserServer(host="127.0.0.1", port=_PORT, verbose=False)
    try:
        scene = robot_scene(server, model)
        size = size_of(trace.robot)
        server.initial_camera.position = tuple(size * value for value in _CAMERA)
        server.initial_camera.look_at = tuple(size * value for value in _LOOK_AT)
        server.initial_camera.fov = np.radians(40.0)
        if field is not None:
            mesh = ground_mesh(field, trace.base_pose[:, :2])
            server.scene.add_mesh_trimesh("/fixed_bodies/terrain", mesh, cast_shadow=False)
        recording = server.get_scene_serializer()
        for sample in clip.frame_samples():
            centre = smoothed_position(trace, sample)
            data.qpos[:7], data.qpos[7:] = trace.base_pose[sample], trace.joint_position[sample]
            data.qpos[:2] -= centre
            mujoco.mj_kinematics(model, data)
            scene.update_from_mjdata(data)
            ground = floor_offset(-centre) if field is None else -centre
            scene.fixed_bodies_frame.position = (*ground, 0.0)
            recording.insert_sleep(1.0 / FRAME_RATE)
        return recording.as_html()
    finally:
        with contextlib.redirect_stdout(io.StringIO()):
            server.stop()
