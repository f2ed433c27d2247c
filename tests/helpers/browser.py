"""Debian's Chromium under Playwright, for tests that use a page as a person would."""

import os
import re
import shlex
import shutil
import tempfile
from contextlib import contextmanager
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from urllib.parse import urlsplit

import numpy as np
import pytest
import waiting
from PIL import Image

EXECUTABLES = ("chromium", "chromium-browser", "google-chrome")
LOCAL_SCHEMES = ("file", "data", "blob", "about")
WIDTH, HEIGHT = 1020, 640
"""Of a page: enough, and little to draw without a graphics card."""
TIMEOUT = 1e3 * waiting.DEADLINE
"""Timeout of Playwright's own waits, ms."""

# WebGL on the CPU, and no background activity of the browser.
ARGUMENTS = (
    "--no-sandbox",
    "--disable-gpu",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    # The watchdog would take slow software rendering on a busy machine for a hung GPU, and end the process.
    "--disable-gpu-watchdog",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
    "--disable-quic",
)


# Pages draw ten times a second: a page that draws as often as it can keeps both cores busy with software rendering.
SLOW_FRAMES = """
const request = window.requestAnimationFrame.bind(window);
window.requestAnimationFrame = draw => setTimeout(() => request(draw), 100);
window.cancelAnimationFrame = clearTimeout;
"""

# As root, Chromium gives its drawing a higher priority than the robot's control loop has.
UNPRIVILEGED = '#!/bin/sh\nexec setpriv --bounding-set=-sys_nice --inh-caps=-sys_nice {executable} "$@"\n'


@dataclass
class Watched:
    """Console messages, errors and requests of a page since it was opened."""

    console: list[str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)

    def outside(self) -> list[str]:
        """Requests that left the machine."""
        return [
            url
            for url in self.requests
            if urlsplit(url).scheme not in LOCAL_SCHEMES and urlsplit(url).hostname not in ("127.0.0.1", "localhost")
        ]


@contextmanager
def launched():
    """A running Chromium; skips the test if it or Playwright is not installed."""
    playwright = pytest.importorskip("playwright.sync_api", reason="no Playwright to drive a browser with")
    executable = next(filter(None, map(shutil.which, EXECUTABLES)), None)
    if executable is None:
        pytest.skip("no Chromium installed")
    with playwright.sync_playwright() as driver, tempfile.TemporaryDirectory() as directory:
        if os.getuid() == 0 and shutil.which("setpriv"):
            wrapper = Path(directory, "chromium")
            wrapper.write_text(UNPRIVILEGED.format(executable=shlex.quote(executable)), encoding="utf-8")
            wrapper.chmod(0o755)
            executable = str(wrapper)
        browser = driver.chromium.launch(executable_path=executable, args=list(ARGUMENTS))
        yield browser
        browser.close()


@contextmanager
def opened(browser, slow_frames=True):
    """A new page in a browser context of its own, with a `Watched` as its `watched`."""
    context = browser.new_context(viewport={"width": WIDTH, "height": HEIGHT}, accept_downloads=False)
    context.set_default_timeout(TIMEOUT)
    if slow_frames:
        context.add_init_script(SLOW_FRAMES)
    page = context.new_page()
    page.watched = watched = Watched()
    page.on("console", lambda message: watched.console.append(message.text))
    page.on("console", lambda message: watched.errors.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: watched.errors.append(str(error)))
    page.on("request", lambda request: watched.requests.append(request.url))
    page.on("websocket", lambda socket: watched.requests.append(socket.url))
    yield page
    context.close()


def draw(page, frames=2):
    """Let a page draw some frames, however long it takes to draw one."""
    page.evaluate(
        """frames => new Promise(done => {
            const next = () => frames-- > 0 ? requestAnimationFrame(next) : done();
            next();
        })""",
        frames,
    )


def still(page, picture, frames=10):
    """Wait until `picture()` stays the same for some frames of the page; returns it."""
    pictures = [picture()]

    def stays():
        draw(page, frames)
        pictures.append(picture())
        return np.array_equal(*pictures[-2:])

    waiting.wait_until(stays, "a picture that no longer changes", interval=0.0)
    return pictures[-1]


def pixels(target, **options):
    """Screenshot (height, width, 3) of a page or of a part of it, with the options of Playwright's `screenshot`."""
    return np.asarray(Image.open(BytesIO(target.screenshot(**options))).convert("RGB"))


def field(page, label):
    """The number field next to a slider."""
    identity = page.locator("label", has_text=re.compile(f"^{re.escape(label)}$")).get_attribute("for")
    return page.locator(f"[id='{identity}']").locator("xpath=..").locator("input[type=text]")


def fill(page, label, value):
    """Type a number into the field next to a slider."""

    def filled():
        # Typed key by key: if a text is set at once, the field's library drops every second one. A busy machine may
        # still lose a key between two renderings, so this is repeated.
        field(page, label).select_text()
        field(page, label).press_sequentially(str(value), delay=20)
        field(page, label).press("Tab")
        draw(page)
        return float(field(page, label).input_value()) == pytest.approx(value)

    waiting.wait_until(filled, f"{value} next to {label}")
