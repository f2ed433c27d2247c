"""Paths on the viewer's page: without the directories of the machine."""

from pathlib import Path

import msgspec
import pytest
from viewing import showing
from waiting import wait_until

from quadruped_env import QuadrupedError, SinusoidalGait
from quadruped_env.evaluation.recorded_episode import publish
from quadruped_env.policies import find_controllers, load_policy
from quadruped_env.utils.files import shown_path
from quadruped_env.viewer.panel_text import without_directories


@pytest.mark.parametrize(
    ("path", "shown"),
    [
        ("runs/a", "runs/a"),
        ("../runs/a", "../runs/a"),
        ("{cwd}/runs/a", "runs/a"),
        ("/home/me/project/runs/a", "runs/a"),
        ("/volume/a.csv", "a.csv"),
        ("/a.csv", "a.csv"),
    ],
)
def test_shown_path_has_no_directory_of_the_machine(path, shown):
    assert shown_path(Path(path.format(cwd=Path.cwd()))) == shown


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("/home/me/runs/a/policy.json: missing", "a/policy.json: missing"),
        ("Not saved: [Errno 17] File exists: '/home/me/results'", "Not saved: [Errno 17] File exists: 'results'"),
        ("{cwd}/results/view 1/video.mp4 and 0.3 m/s", "results/view 1/video.mp4 and 0.3 m/s"),
        ("{home}/my results/x.csv", "my results/x.csv"),
        ("see http://127.0.0.1:8080/page and /joint_states", "see http://127.0.0.1:8080/page and /joint_states"),
        ("0.3 m/s, 2 rad/s; a/b/c", "0.3 m/s, 2 rad/s; a/b/c"),
    ],
)
def test_without_directories_cuts_absolute_paths_only(text, shown):
    assert without_directories(text.format(cwd=Path.cwd(), home=Path.home())) == shown


def test_sources_have_no_directory_in_their_names_and_different_ones_different_names(tmp_path):
    asked = []
    for directory in ("one", "two"):
        load_policy("flat").save(tmp_path / directory / "runs" / "best")
        publish(SinusoidalGait.preset("trot"), 1.0, 50.0).save(tmp_path / directory / "walk.csv")
        asked += [str(tmp_path / directory / "runs" / "best"), str(tmp_path / directory / "walk.csv")]
    _, chosen = find_controllers([*asked, asked[0]], runs=tmp_path / "none")
    assert chosen == (
        "run runs/best",
        "recording walk.csv",
        "run runs/best (2)",
        "recording walk.csv (2)",
        "run runs/best",
    )


def test_nothing_that_the_server_sends_names_a_directory_of_the_machine(tmp_path, monkeypatch):
    """The names of sources, and messages about files: one that is saved, and one that is damaged."""
    pytest.importorskip("viser")
    pytest.importorskip("mjviser")
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: None)
    run, damaged = tmp_path / "run", tmp_path / "runs" / "damaged"
    for directory in (run, damaged):
        load_policy("flat").save(directory)
    (damaged / "policy.json").write_text("{")
    sent = []
    with showing(tmp_path, asked=[str(run)]) as show:
        broadcast = show._server._websock_server._broadcast_buffer
        monkeypatch.setattr(show._server, "get_clients", lambda: {0: RecordedNotifications(sent)})
        show.controller.start_recording()
        wait_until(lambda: show.controller.view().recorded)
        show.controller.stop_recording()
        wait_until(lambda: any("joint_states.csv" in text for text in sent), lambda: f"a saved recording: {sent}")
        with pytest.raises(QuadrupedError, match=str(tmp_path)) as error:
            show.controller.set_source(0, "run damaged")
        show.panel.tell(str(error.value), bad=True)
        with broadcast.buffer_lock:
            messages = tuple(broadcast.message_from_id.values())
        page = b"".join(msgspec.msgpack.encode(message.as_serializable_dict([])) for message in messages)
    assert f"run {tmp_path.name}/run".encode() in page
    assert str(tmp_path).encode() not in page
    assert any("damaged/policy.json" in text for text in sent)
    assert not any(str(tmp_path) in text for text in sent)


class RecordedNotifications:
    """A browser client that records its notifications."""

    def __init__(self, sent):
        self._sent = sent

    def add_notification(self, title, body, **_):
        self._sent.append(body)
