"""The command `mini-quadruped`, and the scripts of the checkout with the same options."""

import os
import runpy
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from paths import ROOT

from quadruped_env import __version__
from quadruped_env._python import SCRIPTS
from quadruped_env.cli.commands import SUMMARIES
from quadruped_env.cli.main import main, make_parser

HEAVY = {
    "torch",
    "stable_baselines3",
    "matplotlib",
    "viser",
    "av",
    "jinja2",
    "rosbags",
    "cyclonedds",
    "scipy",
    "onnx",
    "pydrake",
}
BAD = {
    "train": ("--resume", "nowhere"),
    "evaluate": ("nowhere",),
    "compare": ("nowhere", "flat"),
    "view": ("nowhere",),
    "live": ("controller", "nowhere"),
    "convert": ("nowhere.csv", "out.csv"),
    "replay": ("nowhere.csv",),
    "identify": ("nowhere.csv",),
    "baseline": ("--output", "out.txt"),
    "export": ("nowhere",),
    "sim2sim": ("nowhere",),
    "sweep": ("--resume", "nowhere"),
}
"""Command -> arguments that this package refuses, not argparse."""

PRINT_HELP_AND_MODULES = """
import sys
from quadruped_env.cli.main import main
try:
    main(["--help"])
finally:
    print(*sys.modules)
"""


def options_of(name):
    """The actions of a command, by option or destination."""
    commands = make_parser(only=name)._subparsers._group_actions[0].choices
    return {option: action for action in commands[name]._actions for option in action.option_strings or [action.dest]}


def parse(*arguments):
    return make_parser(only=arguments[0]).parse_args(arguments)


def help_of(run, capsys):
    """The help that a program prints, from its description on."""
    with pytest.raises(SystemExit) as ended:
        run()
    assert ended.value.code == 0
    return capsys.readouterr().out.split("\n\n", 1)[1]


def test_help_names_every_command_and_loads_no_heavy_library():
    done = subprocess.run([sys.executable, "-c", PRINT_HELP_AND_MODULES], capture_output=True, text=True, check=True)
    text, _, modules = done.stdout.strip().rpartition("\n")
    for name, summary in SUMMARIES.items():
        (line,) = [line for line in text.splitlines() if line.split()[:1] == [name]]
        assert summary.split()[0] in line
    assert HEAVY & set(modules.split()) == set()


def test_version_is_the_packages(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["--version"])
    assert (ended.value.code, capsys.readouterr().out) == (0, f"mini-quadruped {__version__}\n")


def test_module_quadruped_env_is_the_command():
    done = subprocess.run(
        [sys.executable, "-m", "quadruped_env", "--version"], capture_output=True, text=True, check=True
    )
    assert done.stdout == f"mini-quadruped {__version__}\n"


@pytest.mark.parametrize("name", SUMMARIES)
def test_command_help_has_a_description_and_describes_every_option(name, capsys):
    text = help_of(lambda: main([name, "--help"]), capsys)
    assert len(text.split("\n\n")[0]) > 30, "a description"
    for option, action in options_of(name).items():
        assert action.help or option == "node", f"{option} has no help"


def test_unknown_command_is_an_error_with_the_list(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["walk"])
    assert ended.value.code == 2
    assert "mini-quadruped: error: " in (said := capsys.readouterr().err)
    assert "evaluate" in said


@pytest.mark.parametrize("name", BAD)
def test_command_error_is_one_line_with_the_programs_name_and_status_2(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main([name, *BAD[name]]) == 2
    *log, line = capsys.readouterr().err.splitlines()
    assert all(entry.startswith("[") for entry in log), "only a node's log"
    prog = f"mini-quadruped {name}{' controller' if name == 'live' else ''}"
    assert line.startswith(f"{prog}: error: ")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", SCRIPTS)
def test_script_has_the_options_of_its_command(name, monkeypatch, capsys):
    script = ROOT / SCRIPTS[name]
    monkeypatch.setattr(sys, "argv", [str(script), "--help"])
    by_script = help_of(lambda: runpy.run_path(str(script), run_name="__main__"), capsys)
    by_command = help_of(lambda: main([name, "--help"]), capsys)
    assert by_script == by_command


def test_script_error_has_the_scripts_name_and_status_2(monkeypatch, capsys, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", ["evaluate/replay.py", "nowhere.csv"])
    with pytest.raises(SystemExit) as ended:
        runpy.run_path(str(ROOT / "evaluate" / "replay.py"), run_name="__main__")
    assert ended.value.code == 2
    assert capsys.readouterr().err.startswith("replay.py: error: nowhere.csv: ")


@pytest.mark.parametrize("name", sorted(set(SUMMARIES) - {"live", "completion"}))
def test_output_has_one_name_in_every_command(name):
    options = options_of(name)
    assert options["-o"] is options["--output"]
    shown = {option for option, action in options.items() if action.help != "==SUPPRESS=="}
    assert not shown & {"--out", "--results", "--runs", "--directory"}


@pytest.mark.parametrize(
    ("arguments", "default"),
    [
        (("train", "--runs"), Path("runs")),
        (("tune-gait", "--out"), Path("results/gait.json")),
        (("evaluate", "--out"), None),
        (("compare", "a", "b", "--out"), None),
        (("baseline", "--out"), None),
        (("view", "--results"), Path("results")),
        (("replay", "a.csv", "--out"), None),
        (("identify", "a.csv", "--out"), None),
        (("convert", "a.csv", "--out"), None),
    ],
    ids=lambda value: value[0] if isinstance(value, tuple) else "",
)
def test_output_earlier_spelling_still_works(arguments, default):
    assert parse(*arguments, "there").output == Path("there")
    assert parse(*arguments[:-1], "--output", "there").output == Path("there")
    assert parse(*arguments[:-1], "-o", "there").output == Path("there")
    assert parse(*arguments[:-1]).output == default


def test_convert_without_exactly_one_target_is_refused(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for arguments in ((), ("b.csv", "-o", "c.csv")):
        assert main(["convert", "a.csv", *arguments]) == 2
        assert "name it once" in capsys.readouterr().err
    assert main(["baseline", "--seconds", "1", "--episodes", "1", "-o", "a.csv"]) == 0
    assert main(["convert", "a.csv", "-o", "b.csv"]) == 0
    assert main(["convert", "a.csv", "c.csv"]) == 0
    assert Path("b.csv").read_bytes() == Path("c.csv").read_bytes()


def test_results_name_the_program_that_wrote_them(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    assert main(["baseline", "--seconds", "1", "--episodes", "1", "-o", "a.csv", "--commands"]) == 0
    assert main(["replay", "a.csv", "-o", "by command"]) == 0
    assert "mini-quadruped replay a.csv -o &#39;by command&#39;" in Path("by command/report.html").read_text()


# --- completion


@pytest.fixture
def complete(tmp_path, capsys):
    """Completes a line as bash does: function of the words, the last one unfinished."""
    if shutil.which("bash") is None:
        pytest.skip("no bash")
    assert main(["completion", "bash"]) == 0
    script = tmp_path / "completion.bash"
    script.write_text(capsys.readouterr().out)
    reply = """
        source "$1"; shift
        COMP_WORDS=(mini-quadruped "$@"); COMP_CWORD=$#; COMP_LINE="${COMP_WORDS[*]}"; COMP_POINT=${#COMP_LINE}
        "$(complete -p mini-quadruped | sed 's/.*-F \\([^ ]*\\).*/\\1/')"
        printf '%s\\n' "${COMPREPLY[@]}"
    """

    def run(*words):
        environment = {"PATH": os.environ["PATH"]}
        command = ["bash", "-c", reply, "bash", str(script), *words]
        return subprocess.run(
            command, capture_output=True, text=True, check=False, env=environment, cwd=tmp_path
        ).stdout.split()

    return run


def test_completion_completes_commands_options_values_and_files(complete, tmp_path):
    assert complete("comp") == ["compare", "completion"]
    assert "--overwrite" in complete("replay", "--over")
    assert complete("baseline", "--preset", "tr") == ["trot"]
    assert "controller" in complete("live", "cont")
    (tmp_path / "measured.csv").touch()
    assert complete("replay", "meas") == ["measured.csv"]


@pytest.mark.parametrize("shell", ["zsh", "tcsh"])
def test_completion_of_other_shells_names_the_commands(shell, capsys):
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    for name in SUMMARIES:
        assert name in script
