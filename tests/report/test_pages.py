"""The report in a real browser, opened from disk."""

import browser
import numpy as np
import pytest
from comparisons import write_evaluation
from waiting import wait_until

from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.report.pages import clips


@pytest.fixture(scope="module")
def opened(chromium, written):
    """The report in one page."""
    with browser.opened(chromium) as page:
        page.set_viewport_size({"width": 640, "height": 600})
        page.goto((written.directory / "evaluation" / "report.html").as_uri())
        yield page


def test_report_opens_from_disk_and_requests_nothing(opened, written):
    opened.wait_for_load_state("networkidle")
    addresses = [url for url in opened.watched.requests if not url.startswith(("data:", "blob:"))]
    assert addresses == [(written.directory / "evaluation" / "report.html").as_uri()]
    assert opened.watched.errors == []
    for image in opened.locator("img").all():
        assert image.evaluate("element => element.complete && element.naturalWidth > 0")
    # Nothing is wider than the page, on a desktop and on a phone.
    for width in (1280, 390, 640):
        opened.set_viewport_size({"width": width, "height": 600})
        assert opened.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.slow
def test_its_video_advances(chromium, tmp_path, monkeypatch):
    monkeypatch.setattr(clips, "CLIP_SECONDS", 0.8)
    evaluated = find_policy("flat", tmp_path)
    comparison = compare(evaluated.policy, 1, 4.0, [(0.4, 0.0), (0.0, 0.5)])
    path, _, missing = write_evaluation(evaluated, comparison, with_video=True)
    if missing:
        pytest.skip(missing[0])
    with browser.opened(chromium) as page:
        page.goto(path.as_uri())
        video = page.locator("video").first  # the film of the learning is below it
        video.scroll_into_view_if_needed()
        # A Chromium of Debian may lack H.264, which common browsers have.
        if video.evaluate("v => v.error !== null || v.networkState === 3"):
            pytest.skip("this Chromium cannot play H.264")
        wait_until(lambda: video.evaluate("v => v.currentTime") > 0.3)
        before = browser.pixels(video)
        wait_until(lambda: video.evaluate("v => v.currentTime") > 0.6)
        assert np.abs(browser.pixels(video).astype(int) - before).max() > 60
