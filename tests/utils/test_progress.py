"""The line that shows the progress of a program."""

import pytest

from quadruped_env.utils.progress import ProgressLine, part_of


@pytest.fixture
def report(capsys, monkeypatch):
    """A function that reports progress at times in s, and returns what was printed."""
    now = [0.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])

    def reported(line, *progress):
        for now[0], share in progress:
            line(share)
        return capsys.readouterr().err

    return reported


def test_progress_is_quiet_until_it_takes_long_and_ends_with_the_time(report):
    line = ProgressLine("playing")
    assert report(line, (0.5, 0.1), (2.0, 0.2)) == ""
    assert report(line, (4.5, 0.6), (5.0, 0.65), (8.0, 1.0)) == "playing:  60%, 3 s left\nplaying: 100% in 7.5 s\n"


def test_short_work_prints_nothing(report):
    assert report(ProgressLine("playing"), (0.0, 0.1), (1.9, 1.0)) == ""


def test_note_follows_the_estimate(report):
    line = ProgressLine("training")
    assert (
        report(lambda share: line(share, ", 3 steps"), (0.0, 0.0), (4.0, 0.5)) == "training:  50%, 4 s left, 3 steps\n"
    )


def test_line_in_a_terminal_is_overwritten_and_fits(capsys, monkeypatch, report):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    monkeypatch.setenv("COLUMNS", "20")
    line = ProgressLine("playing")
    assert report(line, (0.0, 0.0), (4.0, 0.5), (4.1, 0.55), (8.0, 0.8)) == (
        "\r\x1b[Kplaying:  50%, 4 s \r\x1b[Kplaying:  80%, 2 s "
    )
    line.close()
    assert capsys.readouterr().err == "\n"


def test_progress_starts_again_with_the_next_piece_of_work(report):
    pieces = ((0.0, 0.5), (0.5, 1.0), (20.0, 0.1), (21.0, 0.2), (22.0, 0.3))
    assert report(ProgressLine("filming"), *pieces) == "filming:  30%, 7 s left\n"


def test_part_of_a_progress_is_scaled_into_its_range():
    seen = []
    part = part_of(seen.append, 0.25, 0.75)
    for share in (0.0, 0.5, 1.0):
        part(share)
    assert seen == [0.25, 0.5, 0.75]
    assert part_of(None, 0.0, 1.0) is None
