"""The line that shows the progress of a program."""

from quadruped_env.cli.progress import ProgressLine


def test_progress_is_quiet_until_it_takes_long(capsys, monkeypatch):
    now = [0.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    line = ProgressLine("playing")
    for now[0], share in ((0.5, 0.1), (2.0, 0.25), (4.0, 0.5), (8.0, 1.0)):
        line(share)
    assert capsys.readouterr().err == "playing:  25%, 8 s left\nplaying: 100%, 0 s left\n"


def test_progress_estimates_from_the_first_step_and_not_from_earlier_work(capsys, monkeypatch):
    now = [0.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    line = ProgressLine("filming")
    # Ten seconds of plots, then a second for every twentieth of the film.
    for number in range(1, 5):
        now[0] = 10.0 + number
        line(number / 20)
    assert capsys.readouterr().err == "filming:  10%, 18 s left\n"


def test_progress_starts_again_with_the_next_piece_of_work(capsys, monkeypatch):
    now = [0.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    line = ProgressLine("filming")
    for now[0], share in ((0.0, 0.5), (0.5, 1.0), (20.0, 0.1), (22.0, 0.3)):
        line(share)
    assert capsys.readouterr().err == "filming:  30%, 7 s left\n"
