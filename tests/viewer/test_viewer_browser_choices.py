"""Terrain, disturbances, legend and colours of the viewer's page."""

import browser
import numpy as np
import pytest
from browser import fill
from viewer_page import choose, shot, still, tab, until

from quadruped_env.reporting.palette import BACKGROUND, FLOOR, rgb

pytest.importorskip("viser")
pytest.importorskip("mjviser")


@pytest.mark.slow
def test_floor_and_sky_have_the_colours_of_films(paused):
    _, page = paused
    still(page)

    def commonest(**clip):
        picture = browser.pixels(page, clip=clip)
        colours, counts = np.unique(picture.reshape(-1, 3), axis=0, return_counts=True)
        return colours[np.argsort(-counts)].astype(int)

    sky = commonest(x=660, y=2, width=40, height=20)[0]
    np.testing.assert_allclose(sky, rgb(BACKGROUND), atol=4)
    floor = commonest(x=370, y=440, width=320, height=180)
    # The lights are not those of films, and the shadows are paler.
    for colour in FLOOR:
        assert np.abs(floor[:20] - rgb(colour)).max(axis=1).min() < 20


@pytest.mark.slow
def test_terrain_and_its_level(paused):
    controller, page = paused
    tab(page, "Robots")
    page.get_by_text("Level", exact=True).wait_for(state="hidden")
    flat = still(page)
    choose(page, "Terrain", "stairs")
    until(lambda: controller.terrain.name == "stairs")
    choose(page, "Level", "6")
    until(lambda: controller.terrain.level == 6)
    until(lambda: not np.array_equal(shot(page), flat))
    choose(page, "Terrain", "hills")  # which has no levels
    until(lambda: (controller.terrain.name, controller.terrain.level) == ("hills", None))
    page.get_by_text("Level", exact=True).wait_for(state="hidden")
    choose(page, "Terrain", "flat")
    until(lambda: controller.terrain.name == "flat")
    until(lambda: np.abs(shot(page).astype(int) - flat).mean() < 1.0)


@pytest.mark.slow
def test_a_sustained_force_in_its_direction_size_and_time(stage, paused):
    panel = stage[0].panel
    controller, page = paused
    fill(page, "To, degrees", 90)
    fill(page, "Force, N", 4)
    fill(page, "For, s", 0.1)
    until(lambda: (panel._direction.value, panel._force.value, panel._seconds.value) == (90, 4, 0.1))
    page.get_by_role("button", name="Apply force").click()
    until(lambda: controller._robots.slots[0].robot._force_steps == 5)
    for _ in range(4):
        controller.step()
        np.testing.assert_allclose(controller.view().robots[0].force, [0.0, 4.0, 0.0], atol=0.2)
    controller.step()
    np.testing.assert_array_equal(controller.view().robots[0].force, np.zeros(3))


@pytest.mark.slow
def test_a_robot_that_follows_no_command_offers_none(paused):
    controller, page = paused
    legend, keys = page.locator("[data-legend]"), page.locator("[data-keys]")
    assert "commanded velocity" in legend.inner_text()
    assert "faster, slower" in keys.inner_text()
    controller.set_source(0, "gait article")
    page.get_by_text("Forward, m/s", exact=True).wait_for(state="hidden")
    until(lambda: "commanded velocity" not in legend.inner_text())
    until(lambda: "faster, slower" not in keys.inner_text())
    assert "push" in keys.inner_text()
    assert " of " not in page.locator("[data-status]").inner_text()
    controller.set_source(0, "policy flat")
    page.get_by_text("Forward, m/s", exact=True).wait_for(state="visible")
