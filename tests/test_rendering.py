"""Pictures, and what is imported for them."""

import copy
import json
import subprocess
import sys

import mujoco
import numpy as np
import pytest
from environments import (
    ROUGH,
    make,
    make_native,
    make_sync,
)
from gymnasium.utils.passive_env_checker import env_render_passive_checker

from quadruped_env import QuadrupedError, _opengl

# --- pictures ---


def test_a_window_without_a_display_is_refused_with_the_cure(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    with pytest.raises(QuadrupedError, match="needs a display, and there is none; use 'rgb_array'"):
        make(render_mode="human")


def test_a_window_shows_one_robot_only():
    with pytest.raises(QuadrupedError, match="'human' shows one robot; use 'rgb_array' here"):
        make_native(2, render_mode="human")


def test_no_opengl_is_said_with_the_packages_that_bring_it(monkeypatch):
    def broken(*args, **kwargs):
        raise AttributeError("'NoneType' object has no attribute 'eglQueryString'")

    monkeypatch.setattr(mujoco, "Renderer", broken)
    env = make(render_mode="rgb_array", disable_env_checker=True)
    env.reset(seed=0)
    with pytest.raises(QuadrupedError, match=r"no OpenGL.*apt-get install libegl1.*MUJOCO_GL.*eglQueryString"):
        env.render()
    env.close()


def assert_same_picture(picture, expected):
    # A renderer's first picture of a scene can differ a little from its second one.
    np.testing.assert_allclose(picture.astype(int), expected.astype(int), atol=3)


@pytest.mark.usefixtures("opengl")
def test_a_picture_shows_something_of_the_size_asked_for():
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
    copied = copy.deepcopy(env)
    assert_same_picture(copied.render(), env.render())
    for e in (env, copied):
        e.close()
        e.close()
    small = make(render_mode="rgb_array", width=64, height=48)
    small.reset(seed=0)
    assert small.render().shape == (48, 64, 3)
    small.close()


@pytest.mark.usefixtures("opengl")
def test_a_vector_environment_gives_a_picture_a_row_each_the_single_environments():
    kwargs = {"render_mode": "rgb_array", "width": 64, "height": 48, "config": ROUGH}
    vector, sync = make_native(2, **kwargs), make_sync(2, **kwargs)
    for env in (vector, sync):
        env.reset(seed=0)
        env.step(np.zeros((2, 8), dtype=np.float32))
    pictures = vector.render()
    assert len(pictures) == 2
    assert (pictures[0] != pictures[1]).any()
    for picture, expected in zip(pictures, sync.render(), strict=True):
        assert_same_picture(picture, expected)
    vector.close(), sync.close()


@pytest.mark.usefixtures("opengl")
def test_stable_baselines3_tiles_the_pictures():
    from quadruped_env.envs import make_sb3_vec_env

    env = make_sb3_vec_env(2, render_mode="rgb_array", width=64, height=48)
    env.reset()
    assert env.render().shape == (96, 64, 3)
    env.close()


def test_rendering_without_a_mode_says_how_to_ask_for_one():
    env = make(disable_env_checker=True)
    env.reset(seed=0)
    with pytest.warns(UserWarning, match="render_mode='rgb_array'"):
        assert env.unwrapped.render() is None
    assert make_native(2).render() is None


# --- imports ---


@pytest.mark.parametrize(
    ("environment", "libraries", "chosen"),
    [
        ({"MUJOCO_GL": "osmesa"}, {"EGL", "OSMesa"}, "osmesa"),
        ({"MUJOCO_GL": ""}, {"EGL", "OSMesa"}, ""),
        ({"MUJOCO_GL": "glfw", "DISPLAY": ":0"}, {"EGL"}, "glfw"),
        ({"DISPLAY": ":0"}, {"EGL"}, None),
        ({"WAYLAND_DISPLAY": "wayland-0"}, {"EGL"}, None),
        ({}, {"EGL", "OSMesa"}, "egl"),
        ({}, {"OSMesa"}, "osmesa"),
        ({}, set(), None),
    ],
)
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="other systems always have a display")
def test_opengl_is_chosen_only_where_nobody_chose(monkeypatch, environment, libraries, chosen):
    for name in ("MUJOCO_GL", "DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(_opengl.ctypes.util, "find_library", lambda name: name if name in libraries else None)
    _opengl.choose_opengl()
    assert _opengl.os.environ.get("MUJOCO_GL") == chosen


def test_the_package_imports_none_of_its_extras():
    extras = ["torch", "stable_baselines3", "matplotlib", "viser", "rosbags", "jinja2", "av", "tensorboard", "tqdm"]
    code = f"import sys, json, quadruped_env; print(json.dumps([m for m in {extras} if m in sys.modules]))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == []
