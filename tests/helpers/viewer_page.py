"""The viewer's page in a browser: opening it, its controls, and pictures of it."""

import re

import browser
from waiting import wait_until

MIDDLE = {"x": 370, "y": 200, "width": 320, "height": 400}
"""Part of the page with the robot, without panels and notifications, pixels."""


def visit(page, show):
    before = len(show.clients())
    # Without this the picture gets coarser where drawing is slow.
    page.goto(f"http://127.0.0.1:{show.port}/?fixedDpr=1")
    page.get_by_text("Feet on the ground").wait_for()
    page.locator("canvas").first.wait_for()
    until(lambda: len(show.clients()) > before)


def still(page):
    """A picture of the middle once it no longer changes."""
    return browser.still(page, lambda: shot(page))


def until(condition, page=None):
    """Wait for a condition that another thread or the page brings about; a failure shows the page's console."""
    wait_until(condition, lambda: f"the condition (console: {page.watched.console if page else []})", interval=0.02)


def choose(page, label, option):
    """Choose from a list."""
    identity = page.locator("label", has_text=re.compile(f"^{re.escape(label)}$")).get_attribute("for")
    page.locator(f"[id='{identity}']").click()
    page.get_by_role("option", name=option, exact=True).click()


def tab(page, name):
    page.get_by_role("tab", name=name).click()


def shot(page):
    return browser.pixels(page, clip=MIDDLE)
