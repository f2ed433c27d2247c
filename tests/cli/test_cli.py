"""The command `mini-quadruped`, and the scripts of the checkout with the same options."""

import os
import re
import runpy
import select
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from paths import ROOT
from waiting import DEADLINE

from quadruped_env import __version__
from quadruped_env.cli.invocation import SUMMARIES
from quadruped_env.cli.main import main, make_parser
from quadruped_env.live.nodes import SUMMARIES as NODES
from quadruped_env.utils.program import EXTRAS_STATUS

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
    "check-export": ("nowhere",),
    "import-policy": ("nowhere.zip",),
    "sweep": ("--work", "nowhere"),
}
"""Command -> arguments that this package refuses, not argparse."""
SCRIPTS = {
    "train/ppo.py": "train",
    "train/sweep.py": "sweep",
    "evaluate/policy.py": "evaluate",
    **{f"evaluate/{name}.py": name for name in ("compare", "baseline", "export", "view", "replay")},
    **{f"evaluate/{name}.py": name for name in ("convert", "identify")},
}
"""Script of a checkout -> the command that it is."""

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


def help_of(run, capsys):
    """The help that a program prints, from its description on."""
    with pytest.raises(SystemExit) as ended:
        run()
    assert ended.value.code == 0
    return capsys.readouterr().out.split("\n\n", 1)[1]


def test_help_names_every_command_and_loads_no_heavy_library():
    done = subprocess.run(
        [sys.executable, "-c", PRINT_HELP_AND_MODULES], capture_output=True, encoding="utf-8", check=True
    )
    text, _, modules = done.stdout.strip().rpartition("\n")
    for name, summary in SUMMARIES.items():
        (line,) = [line for line in text.splitlines() if line.split()[:1] == [name]]
        assert summary.split()[0] in line
    assert HEAVY & set(modules.split()) == set()


def test_version_is_the_packages(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["--version"])
    assert (ended.value.code, capsys.readouterr().out) == (0, f"mini-quadruped {__version__}\n")


def test_command_help_has_a_description_and_describes_every_option(capsys):
    for name in SUMMARIES:
        text = help_of(lambda name=name: main([name, "--help"]), capsys)
        assert len(text.split("\n\n")[0]) > 30, f"{name}: a description"
        for option, action in options_of(name).items():
            assert action.help or option == "node", f"{name}: {option} has no help"


@pytest.mark.parametrize("arguments", [[], ["live"]])
def test_no_command_prints_the_help_with_the_list(arguments, capsys):
    text = help_of(lambda: main(arguments), capsys)
    assert text == help_of(lambda: main([*arguments, "--help"]), capsys)
    assert all(name in text for name in (NODES if arguments else SUMMARIES))


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        (
            "evalute",
            r"mini-quadruped: error: argument COMMAND: invalid choice: 'evalute' .*'evaluate'.*; did you mean "
            r"evaluate\?",
        ),
        ("live cotroller", r"mini-quadruped live: error: .*'cotroller'.*; did you mean controller\?"),
        ("train --sedd 3", r"mini-quadruped train: error: unrecognized arguments: --sedd 3; did you mean --seed\?"),
        ("live sim --pickup=3", r"mini-quadruped live sim: error: .*--pickup=3; did you mean --pick-up\?"),
        ("train --recipe walkr", r"mini-quadruped train: error: .*; did you mean walker\?"),
        ("train --algo sacc", r"mini-quadruped train: error: .*; did you mean sac\?"),
        ("baseline --preset tort", r"mini-quadruped baseline: error: .*; did you mean trot\?"),
        ("evaluate rogh", r"mini-quadruped evaluate: error: .*; did you mean rough\?"),
        ("view flta", r"mini-quadruped view: error: .*; did you mean flat\?"),
        ("evaluate flat --terrain stiars", r"mini-quadruped evaluate: error: .*; did you mean stairs\?"),
        ("walk", r"mini-quadruped: error: .*'completion'\)"),
        ("evaluate nothing-like-it", r".*mini-quadruped train'"),
    ],
)
def test_error_about_a_mistyped_word_suggests_the_similar_one(arguments, error, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    try:
        status = main(arguments.split())
    except SystemExit as ended:
        status = ended.code
    assert status == 2
    assert re.fullmatch(error, capsys.readouterr().err.splitlines()[-1])


@pytest.mark.parametrize("name", BAD)
def test_command_error_is_one_line_with_the_programs_name_and_status_2(name, domain_id, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main([name, *BAD[name]]) == 2
    *log, line = capsys.readouterr().err.splitlines()
    assert all(entry.startswith("[") for entry in log), "only a node's log"
    prog = f"mini-quadruped {name}{' controller' if name == 'live' else ''}"
    assert line.startswith(f"{prog}: error: ")
    assert list(tmp_path.iterdir()) == []


def test_script_is_its_command(monkeypatch, capsys):
    for script, name in SCRIPTS.items():
        monkeypatch.setattr(sys, "argv", [str(ROOT / script), "--help"])
        by_script = help_of(lambda path=script: runpy.run_path(str(ROOT / path), run_name="__main__"), capsys)
        assert by_script == help_of(lambda name=name: main([name, "--help"]), capsys)


def test_every_script_of_train_and_evaluate_is_a_command_or_a_tool():
    scripts = {str(path.relative_to(ROOT)) for folder in ("train", "evaluate") for path in (ROOT / folder).glob("*.py")}
    assert scripts - {f"evaluate/{tool}.py" for tool in ("throughput", "learning_speed", "live")} == set(SCRIPTS)
    assert set(SCRIPTS.values()) == set(SUMMARIES) - {
        "live",
        "completion",
        "check-export",
        "demo",
        "page",
        "import-policy",
        "robot",
    }


def test_output_has_one_name_in_every_command():
    for name in set(SUMMARIES) - {"live", "completion", "check-export", "page", "convert"}:
        options = options_of(name)
        assert options["-o"] is options["--output"]


def test_results_name_the_program_that_wrote_them(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    assert main(["baseline", "--seconds", "1", "--episodes", "1", "-o", "a.csv", "--commands"]) == 0
    assert main(["replay", "a.csv", "-o", "by command"]) == 0
    assert "mini-quadruped replay a.csv -o &#39;by command&#39;" in Path("by command/report.html").read_text(
        encoding="utf-8"
    )


@pytest.mark.slow
def test_evaluation_without_report_and_page_keeps_its_numbers_and_says_so(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    for name in ("report.html", "walk.html"):
        Path("out", name, "in its place").mkdir(parents=True)
    assert main(["evaluate", "flat", "--seeds", "1", "--seconds", "2", "--no-video", "-o", "out"]) == EXTRAS_STATUS
    out, err = capsys.readouterr()
    assert "numbers: out/metrics.json" in out
    assert Path("out/metrics.json").is_file()
    assert [line.partition(":")[0] for line in err.splitlines() if line.startswith("no ")] == [
        "no walk.html",
        "no report.html",
    ]


# --- completion


@pytest.fixture(params=["bash", "zsh", "fish"])
def complete(request, tmp_path, capsys):
    """Function that completes a line in a shell, with a directory of its own: the candidates; of zsh, the new line."""
    shell = request.param
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    assert main(["completion", shell]) == 0
    script = tmp_path / "scripts" / "_mini-quadruped"
    script.parent.mkdir()
    script.write_text(capsys.readouterr().out, encoding="utf-8")
    directory = tmp_path / "here"
    for name in ("runs/20260101-000000-ppo", "runs/$(touch executed)", "train"):
        (directory / name).mkdir(parents=True)
    (directory / "measured joints.csv").touch()
    yield lambda line: COMPLETE[shell](script, line, directory)
    assert not (directory / "executed").exists()


def complete_in_bash(script, line, directory):
    reply = """
        source "$1"; shift
        COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
        "$(complete -p mini-quadruped | sed 's/.*-F \\([^ ]*\\).*/\\1/')"
        printf '%s\\n' "${COMPREPLY[@]}"
    """
    words = [part for part in re.split(r" |(=)", line) if part is not None]
    return output_in(directory, "bash", "-c", reply, "bash", script, *words)


def complete_in_fish(script, line, directory):
    lines = output_in(directory, "fish", "--no-config", "-c", f"source {script}; complete -C '{line}'")
    return [re.split("\t", found)[0].rpartition("=")[2] for found in lines]


def output_in(directory, *command):
    environment = {"PATH": os.environ["PATH"], "HOME": str(directory)}
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=True, env=environment, cwd=directory)
    return done.stdout.splitlines()


def complete_in_zsh(script, line, directory):
    """The word that the key tab makes of a line's last one in an interactive zsh."""
    terminal, of_shell = os.openpty()
    environment = {"PATH": os.environ["PATH"], "HOME": str(directory), "TERM": "dumb", "COLUMNS": "200"}
    pipes = dict.fromkeys(("stdin", "stdout", "stderr"), of_shell)
    with subprocess.Popen(
        ["zsh", "-f", "-i"], **pipes, env=environment, cwd=directory, start_new_session=True
    ) as shell:
        os.close(of_shell)
        output = ""

        def read_until(pattern):
            nonlocal output
            while not (found := re.search(pattern, output)):
                assert select.select([terminal], [], [], DEADLINE)[0], output
                output += os.read(terminal, 4096).decode(errors="replace")
            return found

        setup = f"fpath=({script.parent} $fpath); autoload -U compinit; compinit -u -D; bindkey '^I' complete-word"
        os.write(terminal, f"{setup}; print REA''DY\n".encode())
        read_until("\nREADY")
        # Ctrl-A and Ctrl-E: the beginning and the end of the line, which is printed instead of executed.
        os.write(terminal, f"{line}\t\x01print -rC1 -- 'RES'ULT \x05 'E'ND\n".encode())
        found = read_until(r"\nRESULT\r\n([\s\S]*?)\r\nEND\r\n")[1]
        shell.kill()
    os.close(terminal)
    return found.split("\r\n")[-1:]


COMPLETE = {"bash": complete_in_bash, "fish": complete_in_fish, "zsh": complete_in_zsh}


def test_completion_completes_commands_options_values_runs_and_files(complete):
    for line, completed in (
        ("basel", "baseline"),
        ("train --final", "--final-log-std"),
        ("train --recipe wal", "walker"),
        ("evaluate rou", "rough"),
        ("train --resume runs/20", "runs/20260101-000000-ppo"),
        ("live controller tun", "tuned"),
        ("live sim --pick", "--pick-up"),
        ("replay meas", "measured joints.csv"),
    ):
        assert [found.rstrip("/") for found in complete(f"mini-quadruped {line}")] == [completed], line


@pytest.mark.parametrize("complete", ["bash", "fish"], indirect=True)
def test_completion_lists_all_that_fits(complete):
    assert set(complete("mini-quadruped ")) == set(SUMMARIES)
    assert set(complete("mini-quadruped live ")) == set(NODES)
    assert set(complete("mini-quadruped train --recipe ")) == {"flat", "walker"}
    assert len(complete("mini-quadruped evaluate ")) >= 4, "policies, and runs also of odd names"
    assert not set(complete("mini-quadruped train --seed ")) - {""}


@pytest.mark.parametrize(
    ("typed", "end"),
    [
        ("train --steps=9", "--steps=9; did you mean --n-steps?"),
        ("train --foo", "unrecognized arguments: --foo"),
    ],
)
def test_suggestions_for_options_are_right_or_missing(typed, end, capsys):
    with pytest.raises(SystemExit):
        main(typed.split())
    assert capsys.readouterr().err.strip().endswith(end)


@pytest.mark.parametrize(
    ("typed", "number"),
    [("1500", 1500), ("1e6", 10**6), ("100k", 10**5), ("1.5M", 1_500_000), ("2K", 2000), ("3m", 3 * 10**6), ("-5", -5)],
)
def test_counts_are_read_as_people_write_them(typed, number):
    assert make_parser("train").parse_args(["train", f"--timesteps={typed}"]).timesteps == number
    assert type(make_parser("train").parse_args(["train", f"--num-envs={typed}"]).num_envs) is int


@pytest.mark.parametrize("typed", ["1.5", "k", "", "1e-3", "many", "1e400", "1e999999999", "nan", "inf", "10kk"])
def test_what_is_no_count_is_refused_with_examples(typed, capsys):
    with pytest.raises(SystemExit):
        make_parser("train").parse_args(["train", f"--timesteps={typed}"])
    assert (
        "argument --timesteps: expected a whole number, such as 1500000, 1e6, 100k or 1.5M" in capsys.readouterr().err
    )


@pytest.mark.parametrize("command", ["page", "evaluate", "view"])
def test_a_policy_that_does_not_exist_is_named_without_a_function(command, capsys):
    assert main([command, "no_such_policy"]) == 2
    error = capsys.readouterr().err
    assert "load_policy" not in error
    assert "no_such_policy" in error
