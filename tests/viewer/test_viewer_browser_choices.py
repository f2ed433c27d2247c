"""Terrain, disturbances, legend and colours of the viewer's page."""

import pytest
from viewer_page import until

pytest.importorskip("viser")
pytest.importorskip("mjviser")


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
