"""The report in a real browser, opened from disk."""

import browser
import numpy as np
import pytest

from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.reporting.pages import pictures
from quadruped_env.reporting.pages.evaluation_report import write_report


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    patch = pytest.MonkeyPatch()
    patch.setattr(pictures, "CLIP_SECONDS", 0.8)
    evaluated = find_policy("flat", tmp_path_factory.mktemp("report"))
    comparison = compare(evaluated.policy, 1, 4.0, [(0.4, 0.0), (0.0, 0.5)])
    path, _, missing = write_report(evaluated, comparison, "python evaluate/policy.py flat")
    patch.undo()
    return path, missing


@pytest.fixture(scope="module")
def opened(chromium, report):
    """The report in one page for all tests."""
    # Its viewer would lower the resolution if frames were slow.
    with browser.opened(chromium, slow_frames=False) as page:
        page.set_viewport_size({"width": 640, "height": 600})
        page.goto(report[0].as_uri())
        yield page


def test_report_opens_from_disk_and_requests_nothing(opened, report):
    opened.wait_for_load_state("networkidle")
    addresses = [url for url in opened.watched.requests if not url.startswith(("data:", "blob:"))]
    assert addresses == [report[0].as_uri()]
    assert opened.watched.errors == []
    assert report[0].stat().st_size < 5_000_000
    for image in opened.locator("img").all():
        assert image.evaluate("element => element.complete && element.naturalWidth > 0")
    # Nothing is wider than the page, on a desktop and on a phone.
    for width in (1280, 390, 640):
        opened.set_viewport_size({"width": width, "height": 600})
        assert opened.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.slow
def test_its_video_advances(opened, report):
    if report[1]:
        pytest.skip(report[1][0])
    video = opened.locator("video").first  # that of the learning stands below it
    video.scroll_into_view_if_needed()
    # A Chromium of Debian may lack H.264, which common browsers have.
    if video.evaluate("v => v.error !== null || v.networkState === 3"):
        pytest.skip("this Chromium cannot play H.264")
    opened.wait_for_function("document.querySelector('video').currentTime > 0.3")
    before = browser.pixels(video)
    opened.wait_for_function("document.querySelector('video').currentTime > 0.6")
    assert np.abs(browser.pixels(video).astype(int) - before).max() > 60
