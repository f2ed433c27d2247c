"""Programs: signals, output that cannot be written, errors of the system, extras, control characters."""

import os
import signal
import subprocess
import sys

import pytest
from waiting import output_of, wait_until

from quadruped_env.cli.main import main
from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.program import Extras, run_program
from quadruped_env.utils.text_table import text_table

ESCAPE = "\x1b]0;title\x07\x9b2J\u202e"
ESCAPED = r"\x1b]0;title\x07\x9b2J\u202e"
PROGRAM = """
import sys, time
from pathlib import Path
from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.files import whole
from quadruped_env.utils.program import run_program

def run():
{body}
    return 0

sys.exit(run_program("program", run))
"""
PRINT = """
    for line in range(20000):
        print("a line of the program")
    Path("end").touch()
"""
WAIT = """
    with whole(Path("result")) as part:
        part.write_text("half")
        Path("begun").touch()
        time.sleep(1000)
"""


def started(folder, body, **options):
    code = PROGRAM.format(body=body)
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **options}
    return subprocess.Popen([sys.executable, "-c", code], cwd=folder, **options)


def test_closed_pipe_ends_a_program_without_an_error(tmp_path):
    with started(tmp_path, PRINT) as process:
        assert process.stdout.readline() == "a line of the program\n"
        process.stdout.close()
        errors = process.stderr.read()
    assert (process.returncode, errors) == (141, "")


@pytest.mark.parametrize("body", [PRINT, '    print("a line")', '    print("a line")\n    raise SystemExit'])
def test_full_standard_output_is_one_line_and_status_1(tmp_path, body):
    with open("/dev/full", "wb") as full:
        process = started(tmp_path, body, stdout=full)
        _, errors = output_of(process)
    assert process.returncode == 1
    assert errors == "program: error: No space left on device\n"


@pytest.mark.parametrize(("number", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 143)])
def test_a_signal_ends_a_program_with_its_status_and_leaves_no_incomplete_file(tmp_path, number, status):
    process = started(tmp_path, WAIT)
    wait_until((tmp_path / "begun").exists, alive=process)
    process.send_signal(number)
    assert output_of(process) == ("", "")
    assert process.returncode == status
    assert os.listdir(tmp_path) == ["begun"]


def test_program_under_nohup_ignores_a_closed_terminal(tmp_path):
    body = 'import signal\n    signal.raise_signal(signal.SIGHUP)\n    print("alive")'
    process = started(tmp_path, f"    {body}", preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    assert output_of(process)[0] == "alive\n"


def test_handlers_of_the_caller_are_back_after_a_program():
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)}
    streams = sys.stdout, sys.stderr
    assert run_program("program", lambda: 0) == 0
    assert {number: signal.getsignal(number) for number in before} == before
    assert (sys.stdout, sys.stderr) == streams


@pytest.mark.parametrize(
    "command", ["page", "demo", "evaluate flat", "compare flat rough", "train", "export", "baseline", "sweep"]
)
def test_output_with_a_name_that_is_too_long_is_one_line(command, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    assert main([*command.split(), "-o", 300 * "x"]) == 2
    errors = capsys.readouterr().err.splitlines()
    assert len(errors) == 1
    assert "xxx" in errors[0] or "extra" in errors[0]
    assert os.listdir(tmp_path) == []


def test_names_from_files_cannot_control_the_terminal(capsys):
    def run():
        print(f"name {ESCAPE}\tand\r\x1b[Kline")
        print(ESCAPE, file=sys.stderr)
        raise QuadrupedError(f"{ESCAPE}\r: damaged")

    run_program("program", run)
    out, err = capsys.readouterr()
    assert out == f"name {ESCAPED}\tand\r\x1b[Kline\n"
    assert err == f"{ESCAPED}\nprogram: error: {ESCAPED}\\r: damaged\n"


def test_tables_keep_one_line_per_row():
    assert text_table([["a\nb\r\x1b[K", "1"]]) == r"a\nb\r\x1b[K  1"


def test_characters_that_the_terminal_lacks_are_escaped(tmp_path):
    body = '    print("m/s\\u00b2 \\u8f6c \\udcff")'
    process = started(tmp_path, body, text=False, env={**os.environ, "PYTHONIOENCODING": "gbk"})
    assert output_of(process) == (b"m/s\\xb2 \xd7\xaa \\udcff\n", b"")
    assert process.returncode == 0


def test_each_extra_fails_alone_with_a_line(capsys):
    extras = Extras()
    with extras.part("page", of_some_only=True):
        raise QuadrupedError("not of a policy that is code")
    assert extras.status == 0
    with extras.part("film"):
        raise ZeroDivisionError("in a library")
    with extras.part("report"):
        print("written")
    assert extras.status == 3
    out, err = capsys.readouterr()
    assert out == "written\n"
    assert err == "no page: not of a policy that is code\nno film: ZeroDivisionError: in a library\n"
