"""Rendering, and its imports."""

import copy
import json
import os
import pickle
import subprocess
import sys
from functools import partial

import missing_opengl
import numpy as np
import pytest
from environments import ROUGH, make, make_native, make_sync
from gymnasium.utils.passive_env_checker import env_render_passive_checker
from waiting import output_of

from quadruped_env import QuadrupedError
from quadruped_env.envs import make_sb3_vec_env, rendering

RENDER_TWICE = """
import gymnasium, quadruped_env
for _ in range(2):
    env = gymnasium.make("MiniQuadruped-v0", render_mode="rgb_array")
    env.reset(seed=0)
    env.step(env.action_space.sample())
    try:
        print("rendered:", env.render().shape)
    except quadruped_env.QuadrupedError as error:
        print("refused:", error)
"""

# --- pictures ---


def test_window_without_a_display_is_refused_with_the_fix(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    with pytest.raises(QuadrupedError, match="needs a display, and there is none; use 'rgb_array'"):
        make(render_mode="human")


@pytest.mark.parametrize(
    ("variables", "reason"),
    [
        ({}, "no OpenGL to render with: install a software renderer (Debian and Ubuntu: 'apt-get install libegl1"),
        ({"MUJOCO_GL": "glfw"}, "MUJOCO_GL is 'glfw', which needs a display"),
    ],
    ids=["unset", "glfw"],
)
def test_env_without_opengl_libraries_steps_and_refuses_each_picture(without_opengl, variables, reason):
    assert_refused_twice(without_opengl(sys.executable, "-c", RENDER_TWICE), variables, reason)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="other systems have other backends")
def test_env_with_rendering_switched_off_steps_and_refuses_each_picture():
    reason = "rendering is switched off: MUJOCO_GL is 'disable'; unset it"
    assert_refused_twice([sys.executable, "-c", RENDER_TWICE], {"MUJOCO_GL": "disable"}, reason)


@pytest.mark.slow
@pytest.mark.usefixtures("opengl")
def test_environment_variable_that_keeps_opengl_from_starting_is_named():
    variables = {"MUJOCO_GL": "egl", "MUJOCO_EGL_DEVICE_ID": "4711"}
    assert_refused_twice([sys.executable, "-c", RENDER_TWICE], variables, "an environment variable keeps OpenGL from")


def assert_refused_twice(command, variables, reason):
    environment = missing_opengl.environment(**variables)
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    refused = done.stdout.splitlines()
    assert len(refused) == 2
    assert refused[0] == refused[1]
    assert refused[0].startswith(f"refused: {reason}")
    assert "GLFW" not in done.stderr


@pytest.mark.slow
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="other systems always have a display")
def test_window_on_a_display_that_is_not_there_is_refused_and_the_process_continues():
    code = """
import gymnasium, quadruped_env
try:
    gymnasium.make("MiniQuadruped-v0", render_mode="human")
except quadruped_env.QuadrupedError as error:
    print("refused:", error)
"""
    environment = {**os.environ, "DISPLAY": ":4711", "MUJOCO_GL": "egl"}
    environment.pop("WAYLAND_DISPLAY", None)
    process = subprocess.Popen(
        [sys.executable, "-c", code], env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    out, _ = output_of(process)
    assert "refused: render_mode 'human': no window can be opened on the display (DISPLAY=:4711)" in out


@pytest.mark.usefixtures("opengl")
def test_offscreen_buffer_grows_with_the_requested_size():
    for width, height in ((1281, 16), (16, 961)):
        env = make(render_mode="rgb_array", width=width, height=height)
        env.reset(seed=0)
        picture = env.render()
        assert picture.shape == (height, width, 3)
        assert picture.std() > 5
        env.close()


@pytest.mark.usefixtures("opengl")
def test_picture_too_large_for_opengl_error_names_its_size():
    env = make(render_mode="rgb_array", width=10**6, height=8)
    env.reset(seed=0)
    with pytest.raises(QuadrupedError, match="not for images of 1000000 x 8 pixels; use a smaller") as caught:
        env.render()
    assert "install" not in str(caught.value)
    assert env.unwrapped.model.vis.global_.offwidth < 10**6
    env.close()


def assert_same_picture(picture, expected):
    # A renderer's first picture differs a little from its later ones, on edges by more: compare pictures of equal rank.
    np.testing.assert_allclose(picture.astype(int), expected.astype(int), atol=3)


@pytest.mark.usefixtures("opengl")
def test_picture_has_the_requested_size_and_is_not_blank():
    env = make(render_mode="rgb_array")
    env.reset(seed=0)
    env_render_passive_checker(env)
    picture = env.render()
    assert picture.shape == (480, 640, 3)
    assert picture.dtype == np.uint8
    assert picture.std() > 5
    for _ in range(20):
        env.step(np.full(8, -1.0, dtype=np.float32))
    assert (env.render() != picture).any()
    env.close()
    env.close()
    small = make(render_mode="rgb_array", width=64, height=48)
    small.reset(seed=0)
    assert small.render().shape == (48, 64, 3)
    small.close()


@pytest.mark.usefixtures("opengl")
@pytest.mark.parametrize(
    ("maker", "duplicate"),
    [(make, copy.deepcopy), (partial(make_sb3_vec_env, 2), lambda env: pickle.loads(pickle.dumps(env)))],  # noqa: S301
)
def test_copy_of_an_env_that_has_rendered_renders_the_same_picture(maker, duplicate):
    env = maker(render_mode="rgb_array", width=64, height=48)
    env.reset()
    picture = np.array(env.render())
    copied = duplicate(env)
    assert_same_picture(np.array(copied.render()), picture)
    assert_same_picture(np.array(copied.render()), np.array(env.render()))
    env.close(), copied.close()


@pytest.mark.usefixtures("opengl")
def test_vector_environment_renders_one_picture_per_env_equal_to_the_single_environments():
    kwargs = {"render_mode": "rgb_array", "width": 64, "height": 48, "config": ROUGH}
    vector, sync = make_native(2, **kwargs), make_sync(2, **kwargs)
    for env in (vector, sync):
        env.reset(seed=0)
        env.step(np.zeros((2, 8), dtype=np.float32))
    for env in (vector, sync):
        env.render()
    pictures = vector.render()
    assert len(pictures) == 2
    assert (pictures[0] != pictures[1]).any()
    for picture, expected in zip(pictures, sync.render(), strict=True):
        assert_same_picture(picture, expected)
    vector.close(), sync.close()


def test_rendering_without_a_mode_error_says_how_to_set_one():
    env = make(disable_env_checker=True)
    env.reset(seed=0)
    with pytest.warns(UserWarning, match="render_mode='rgb_array'"):
        assert env.unwrapped.render() is None
    assert make_native(2).render() is None


# --- imports ---


@pytest.mark.parametrize(("libraries", "chosen"), [({"EGL", "OSMesa"}, "egl"), ({"OSMesa"}, "osmesa"), (set(), None)])
def test_opengl_backend_without_a_display_is_the_one_that_is_installed(monkeypatch, libraries, chosen):
    monkeypatch.setitem(os.environ, "MUJOCO_GL", "")  # so that it is restored
    monkeypatch.delenv("MUJOCO_GL")
    monkeypatch.setattr(rendering.ctypes.util, "find_library", lambda name: name if name in libraries else None)
    assert rendering.choose_opengl() == (chosen is not None)
    assert os.environ.get("MUJOCO_GL") == chosen


def test_the_package_imports_none_of_its_extras():
    extras = ["torch", "stable_baselines3", "matplotlib", "viser", "rosbags", "jinja2", "av", "tensorboard"]
    extras += ["ray", "optuna"]
    code = f"import sys, json, quadruped_env; print(json.dumps([m for m in {extras} if m in sys.modules]))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == []
