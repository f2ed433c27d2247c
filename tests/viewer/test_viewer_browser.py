"""The viewer in a browser, as a person uses it."""

import browser
import numpy as np
import pytest
from browser import field, fill
from viewer_page import choose, shot, still, tab, until, visit
from viewing import showing

from quadruped_env import JOINT_NAMES, JointTrajectory
from quadruped_env.policies import load_policy
from quadruped_env.policies.policy_data import CARD_FILE

pytest.importorskip("viser")
pytest.importorskip("mjviser")


def robot_pixels(picture):
    """Number of pixels that are as blue as the hips."""
    red, green, blue = picture.astype(int).transpose(2, 0, 1)
    return int(((blue > red + 60) & (blue > green + 40)).sum())


ENOUGH = 300
"""Number of blue pixels above which a robot is in the middle of the picture."""


# --- the scene


def test_robot_is_shown_moves_and_stands_still_in_a_pause(stage):
    show, page = stage
    show.controller.set_command(0.4, 0.0)
    until(lambda: show.controller.view().time > 1.0)
    until(lambda: robot_pixels(shot(page)) > ENOUGH)
    first = shot(page).astype(int)
    until(lambda: np.abs(first - shot(page)).max() > 50)
    page.get_by_role("button", name="Pause").click()
    until(lambda: show.controller.paused)
    page.get_by_role("button", name="Resume").wait_for()
    picture = still(page)
    browser.draw(page, 20)
    np.testing.assert_array_equal(shot(page), picture)
    page.get_by_role("button", name="Resume").click()
    until(lambda: not show.controller.paused)


def test_scene_is_not_pale_although_viser_has_not_faded_it_in(stage):
    _, page = stage
    opacity = """() => {
        const canvas = document.querySelector("canvas[data-engine]"), before = canvas.style.opacity;
        canvas.style.opacity = "0.05";
        const shown = getComputedStyle(canvas).opacity;
        canvas.style.opacity = before;
        return shown;
    }"""
    assert page.evaluate(opacity) == "1"


# --- controls


def test_command_sliders_set_the_command(paused):
    controller, page = paused
    fill(page, "Forward, m/s", 0.25)
    until(lambda: controller.command == (0.25, 0.0))
    fill(page, "Turn left, rad/s", -0.5)
    until(lambda: controller.command == (0.25, -0.5))
    controller.step()
    np.testing.assert_array_equal(controller.view().robots[0].now.command, [0.25, -0.5])


@pytest.mark.slow
def test_keys_command_the_robot_and_leave_the_camera_alone(stage, paused):
    show, _ = stage
    controller, page = paused
    (client,) = show.clients()
    camera = client.camera.position.copy()
    page.mouse.click(browser.WIDTH / 2, browser.HEIGHT - 20)
    for key, command in (
        ("ArrowUp", (0.1, 0.0)),
        ("ArrowUp", (0.2, 0.0)),
        ("ArrowLeft", (0.2, 0.2)),
        ("ArrowRight", (0.2, 0.0)),
        ("ArrowDown", (0.1, 0.0)),
        ("0", (0.0, 0.0)),
    ):
        page.keyboard.press(key)
        until(lambda command=command: controller.command == command)
    page.keyboard.down("ArrowUp")
    until(lambda: controller.command == (0.1, 0.0))
    browser.draw(page, 20)
    page.keyboard.up("ArrowUp")
    assert controller.command == (0.1, 0.0)
    np.testing.assert_array_equal(client.camera.position, camera)
    page.keyboard.press("Space")
    until(lambda: not controller.paused)
    page.keyboard.press("Space")
    until(lambda: controller.paused)
    page.keyboard.press("r")
    until(lambda: controller.view().time == 0.0)
    page.keyboard.press("n")
    until(lambda: controller.view().time == pytest.approx(0.02))


@pytest.mark.slow
def test_gait_sliders_set_the_gait(paused):
    controller, page = paused
    tab(page, "Robots")
    choose(page, "Robot", "gait trot")
    until(lambda: controller.gait is not None)
    fill(page, "Amplitude", 1.5)
    until(lambda: controller.gait.amplitude == 1.5)
    fill(page, "Frequency, Hz", 1.2)
    until(lambda: controller.gait.frequency == 1.2)
    for leg, name in enumerate(("LF", "RF", "LH", "RH")):
        fill(page, f"Phase {name}, cycles", 0.1 * leg + 0.3)
        until(lambda leg=leg: controller.gait.phases[leg] == pytest.approx(0.1 * leg + 0.3))
    choose(page, "Robot", "policy flat")
    until(lambda: controller.gait is None)
    page.get_by_text("Amplitude").wait_for(state="hidden")


# --- more than one browser, and less


@pytest.mark.slow
def test_two_browsers_show_and_steer_the_same(stage, paused, chromium):
    show, _ = stage
    controller, page = paused
    with browser.opened(chromium) as other:
        visit(other, show)
        until(lambda: robot_pixels(shot(other)) > ENOUGH, page=other)
        for steering, watching, shown in ((page, other, "0.1"), (other, page, "0.2")):
            steering.mouse.click(browser.WIDTH / 2, browser.HEIGHT - 20)
            steering.keyboard.press("ArrowUp")
            until(lambda shown=shown: controller.command == (float(shown), 0.0))
            for each in (steering, watching):
                until(lambda each=each, shown=shown: field(each, "Forward, m/s").input_value() == shown)
        until(lambda: robot_pixels(shot(other)) > ENOUGH, page=other)
        assert other.watched.errors == []


@pytest.mark.slow
def test_a_browser_that_is_closed_leaves_a_complete_recording(tmp_path, chromium, monkeypatch):
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: None)
    with showing(tmp_path) as show:
        with browser.opened(chromium) as page:
            visit(page, show)
            page.get_by_role("button", name="Record").click()
            until(lambda: (show.controller.view().recorded or 0.0) > 0.5, page=page)
            page.get_by_text("recording").wait_for()
        until(lambda: show.controller.view().recorded is None)
        until(lambda: list(tmp_path.glob("results/view-*/joint_states.csv")))
        (path,) = tmp_path.glob("results/view-*/joint_states.csv")
        trajectory = JointTrajectory.load(path)
        assert trajectory.duration > 0.5
        assert trajectory.names == JOINT_NAMES
        # The show continues.
        before = show.controller.view().time
        until(lambda: show.controller.view().time > before)


@pytest.mark.slow
def test_errors_are_shown_in_the_page(tmp_path, page, monkeypatch):
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: None)
    run = tmp_path / "runs" / "damaged"
    load_policy("flat").save(run)
    (run / CARD_FILE).write_text("{")
    with showing(tmp_path) as show:
        visit(page, show)
        tab(page, "Robots")
        choose(page, "Robot", "run damaged")
        page.get_by_text("the file is damaged, train again").wait_for()
        assert show.controller.robots == ("policy flat",)
        page.get_by_role("combobox", name="Robot").and_(page.locator("[value='policy flat']")).wait_for()
        page.get_by_role("tab", name="Drive").click()
        page.get_by_role("button", name="Record").click()
        until(lambda: show.controller.view().recorded is not None)
        page.get_by_role("button", name="Stop and save").click()
        page.get_by_text("s recorded: ").wait_for()
