"""One palette for films, the 3D replay and the viewer."""

from collections import Counter
from xml.etree import ElementTree

import numpy as np
import pytest

from quadruped_env import QuadrupedError, asset_path
from quadruped_env.evaluation.trace import Trace
from quadruped_env.report import palette
from quadruped_env.report.films import film
from quadruped_env.report.films.film import Camera
from quadruped_env.report.ground_mesh import (
    FLOOR_PERIOD,
    floor_mesh,
    floor_offset,
    ground_mesh,
    scene_rgb,
    use_film_colours,
)
from quadruped_env.report.palette import rgb
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import build_model, find_terrain
from quadruped_env.simulation.height_field import HeightField

pytest.importorskip("trimesh")


def displayed(linear):
    """Linear values in 0 to 255 as a screen shows them; source: IEC 61966-2-1."""
    linear = np.asarray(linear, np.float64) / 255.0
    return 255.0 * np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def test_the_scene_of_films_has_the_colours_of_the_palette():
    scene = ElementTree.fromstring(asset_path("scene.xml").read_text())  # noqa: S314

    def colour(element, name):
        return [255.0 * float(value) for value in element.get(name).split()[:3]]

    sky, ground = scene.findall("asset/texture")
    for name, expected in (("rgb1", palette.FLOOR[0]), ("rgb2", palette.FLOOR[1])):
        np.testing.assert_allclose(colour(ground, name), rgb(expected), atol=0.01)
        np.testing.assert_allclose(colour(sky, name), rgb(palette.BACKGROUND), atol=0.01)
    np.testing.assert_allclose(colour(scene.find("visual/rgba"), "haze"), rgb(palette.BACKGROUND), atol=0.01)
    # A texture of two by two squares repeats this often per 2 m.
    repeats = [float(value) for value in scene.find("asset/material").get("texrepeat").split()]
    assert 2.0 / np.array(repeats) / 2.0 == pytest.approx(palette.SQUARE)


@pytest.mark.parametrize("colour", [*palette.FLOOR, palette.BACKGROUND, palette.FRONT, *palette.SERIES])
def test_a_browser_displays_the_colour_of_the_palette(colour):
    np.testing.assert_allclose(displayed(scene_rgb(colour)), rgb(colour), atol=7.0)  # rounded to 8 bits when dark


def test_the_robots_materials_are_displayed_as_in_films():
    model, browser = build_model(), build_model()
    use_film_colours(browser)
    for name in ("mat_rgba", "geom_rgba"):
        shown = displayed(255.0 * getattr(browser, name)[:, :3])
        np.testing.assert_allclose(shown, 255.0 * getattr(model, name)[:, :3], atol=1e-3)
        np.testing.assert_array_equal(getattr(browser, name)[:, 3], getattr(model, name)[:, 3])


def test_the_floor_is_flat_and_has_squares_that_repeat():
    mesh = floor_mesh()
    np.testing.assert_array_equal(mesh.vertices[:, 2], 0.0)
    # Every face is seen from above.
    assert (mesh.face_normals[:, 2] > 0.99).all()
    assert np.abs(mesh.vertices[:, :2]).max() > 20.0

    def colour_at(x, y):
        inside = [face for face in mesh.faces if is_inside(mesh.vertices[face][:, :2], np.array([x, y]))]
        assert len(inside) == 1
        (colour,) = {tuple(mesh.visual.vertex_colors[corner][:3]) for corner in inside[0]}
        return colour

    light, dark = map(scene_rgb, palette.FLOOR)
    for x, y in ((0.2, 0.1), (-0.3, -0.4), (1.2, 0.1), (0.7, 0.6)):
        assert colour_at(x, y) == light
        assert colour_at(x + palette.SQUARE, y) == dark
        assert colour_at(x + FLOOR_PERIOD, y - FLOOR_PERIOD) == light


def is_inside(triangle, point):
    """True if a point (2,) is in a triangle (3, 2)."""
    edges = np.roll(triangle, -1, axis=0) - triangle
    to_point = point - triangle
    turns = edges[:, 0] * to_point[:, 1] - edges[:, 1] * to_point[:, 0]
    return bool((turns > 0.0).all() or (turns < 0.0).all())


def test_the_floor_moves_by_less_than_its_period_and_looks_the_same():
    shift = np.random.default_rng(0).uniform(-50.0, 50.0, (100, 2))
    moved = floor_offset(shift)
    assert np.abs(moved).max() <= 0.5 * FLOOR_PERIOD
    periods = (shift - moved) / FLOOR_PERIOD
    np.testing.assert_allclose(periods, np.round(periods), atol=1e-9)


def test_uneven_ground_has_the_colours_of_the_floor_and_is_dark_at_the_foot_of_each_step():
    field = HeightField.of(build_model(terrain=find_terrain("stairs")))
    mesh = ground_mesh(field, np.zeros((1, 2)), 1.0)
    colours = mesh.visual.vertex_colors[:, :3]
    ring = np.abs(mesh.vertices[:, :2]).max(axis=1)
    # The level start is a square of 0.8 m, and each tread 0.2 m long: its last point is at the foot of the next one.
    level = ring < 0.3
    assert {tuple(colour) for colour in colours[level]} == set(map(scene_rgb, palette.FLOOR))
    for foot in (0.35, 0.55, 0.75):
        at_foot, on_tread = (colours[np.abs(ring - at) < 0.01] for at in (foot, foot + 0.1))
        assert at_foot.max() < 0.5 * on_tread.max()


def test_a_film_shows_floor_and_sky_in_these_colours():
    pose = np.array([[0.0, 0.0, MINI_QUADRUPED.stance_height, 1.0, 0.0, 0.0, 0.0]])
    trace = Trace(robot=MINI_QUADRUPED, timestep=0.02, base_pose=pose, joint_position=MINI_QUADRUPED.stance[None])
    try:
        with Camera(MINI_QUADRUPED) as camera:
            picture = camera.picture(trace, 0)
    except QuadrupedError as error:
        pytest.skip(str(error))
    assert picture.shape == (film.HEIGHT, film.WIDTH, 3)
    # The light's angle to the camera changes the floor's brightness a little.
    floor = [colour for colour, _ in Counter(map(tuple, picture[200:].reshape(-1, 3).tolist())).most_common(2)]
    for found, expected in zip(sorted(floor, reverse=True), palette.FLOOR, strict=True):
        np.testing.assert_allclose(found, rgb(expected), atol=20)
    np.testing.assert_allclose(picture[2].mean(axis=0), rgb(palette.BACKGROUND), atol=6)
