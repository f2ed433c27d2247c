"""Everything that the pages name exists: nodes, programs, options, make targets, links."""

import re
import shlex
import subprocess
import sys

import numpy as np
import pytest
from pages import DOCS, FENCED, PAGES, anchors, commands_of, links
from paths import ROOT
from waiting import output_of

from quadruped_env import SinusoidalGait
from quadruped_env.cli.commands import SUMMARIES as COMMANDS
from quadruped_env.cli.main import make_parser as make_command_parser
from quadruped_env.live.__main__ import make_parser
from quadruped_env.live.nodes import SUMMARIES

PYTHON = re.compile(r"^(?:\S*/)?python3? ")
PLACEHOLDER = re.compile(r"[A-Z]{2,}|\.\.\.|[<>]")
"""Placeholder in a command: NODE, FILE, IN, <name>."""


def python_commands(*pages):
    for page in pages:
        for command in commands_of(page.read_text()):
            if PYTHON.match(command):
                yield page.name, shlex.split(PYTHON.sub("", command))


def test_pages_name_commands_to_check():
    named = [command for _, command in python_commands(*PAGES)]
    assert sum(command[:2] == ["-m", "quadruped_env.live"] for command in named) > 40
    assert sum(command[0].startswith(("evaluate/", "train/")) for command in named) > 30


def test_live_commands_on_every_page_name_a_node_and_its_options():
    parser = make_parser()
    for page, command in python_commands(*PAGES):
        if command[:2] != ["-m", "quadruped_env.live"] or len(command) < 3:
            continue
        arguments = command[2:]
        if PLACEHOLDER.search(arguments[0]) or arguments == ["--help"]:
            continue
        assert arguments[0] in SUMMARIES, f"{page}: {command}"
        try:
            parser.parse_args(arguments)
        except SystemExit:
            # A command may be shown with its beginning only: 'echo' without its topic.
            assert not any(one.startswith("-") for one in arguments), f"{page}: {command}"


def test_installed_commands_on_every_page_parse():
    for page in PAGES:
        for command in commands_of(page.read_text()):
            words = shlex.split(command) if command.startswith("mini-quadruped ") else []
            if len(words) < 2 or any(PLACEHOLDER.search(word) for word in words):
                continue
            assert words[1] in {*COMMANDS, "--help", "--version"}, f"{page.name}: {command}"
            if len(words) > 2 and "--help" not in words:
                make_command_parser(only=words[1]).parse_args(words[1:])


def test_programs_on_every_page_exist():
    for page, command in python_commands(*PAGES):
        if command[0].endswith(".py") and "/" in command[0]:
            assert (ROOT / command[0]).is_file(), f"{page}: {command}"


def test_make_targets_on_every_page_exist():
    targets = set(re.findall(r"^([a-z0-9-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    for page in PAGES:
        for command in commands_of(page.read_text()):
            if re.match(r"make [a-z]", command):
                assert command.split()[1] in targets, f"{page.name}: {command}"


def test_links_and_anchors_on_every_page_exist():
    broken = []
    for page in PAGES:
        for target in links(page.read_text()):
            if target.startswith(("http://", "https://")):
                continue
            path, _, anchor = target.partition("#")
            linked = (page.parent / path).resolve() if path else page
            if not linked.exists() or (anchor and anchor not in anchors(linked.read_text())):
                broken.append(f"{page.relative_to(ROOT)}: {target}")
    assert broken == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_tables_on_every_page_are_well_formed(page):
    tables = re.findall(r"^.*\n(?:^\|.*\n?)+", FENCED.sub("", page.read_text()), re.MULTILINE)
    for table in tables:
        before, *lines = table.splitlines()
        assert not before.strip(), f"a blank line before the table is missing: {table}"
        assert re.fullmatch(r"\|(?:---\|)+", lines[1]), table
        # Markdown cuts or fills up a line with another number of cells; a bar within code still separates cells.
        bars = {line.replace("\\|", "").count("|") for line in lines}
        assert len(bars) == 1, table
        assert all(line.endswith("|") for line in lines), table


def test_readme_links_every_page_of_docs():
    text = (ROOT / "README.md").read_text()
    for page in DOCS:
        assert f"(docs/{page.name})" in text


def test_troubleshooting_answers_the_tutorials_seven_rows():
    text = (ROOT / "docs" / "troubleshooting.md").read_text()
    assert [int(number) for number in re.findall(r"^### (\d)\. ", text, re.MULTILINE)] == [1, 2, 3, 4, 5, 6, 7]


def snippets(page):
    return [block for language, block in FENCED.findall(page.read_text()) if language == "python"]


TALKER, LISTENER, HEAVIER_ROBOT, EXERCISE = snippets(ROOT / "docs" / "from-the-tutorial.md")


def test_the_robot_of_the_tutorials_page_is_heavier_by_its_shanks():
    exec(HEAVIER_ROBOT, names := {})  # noqa: S102
    assert names["HEAVY"].robot().total_mass == pytest.approx(4.0 + 4 * 0.1)


def test_the_exercise_of_the_tutorials_page_runs(capsys):
    exec(EXERCISE, names := {})  # noqa: S102
    assert "[]" in capsys.readouterr().out
    expected = SinusoidalGait.preset("article").positions(1.0)[1::2]
    np.testing.assert_allclose(names["faster"].positions(0.5)[1::2], expected)


@pytest.mark.slow
def test_nodes_of_the_tutorials_page_exchange_messages(domain_id, tmp_path):
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    with (
        subprocess.Popen([sys.executable, "-c", TALKER], cwd=tmp_path, **pipes) as talking,
        subprocess.Popen([sys.executable, "-c", LISTENER], cwd=tmp_path, **pipes) as listening,
    ):
        try:
            output, _ = output_of(listening)
        finally:
            # Not by SIGINT, which a program ignores that was started in the background.
            talking.kill()
            listening.kill()
    heard = [int(line.removeprefix("hello ")) for line in output.splitlines()]
    assert len(heard) >= 10
    assert heard == list(range(heard[0], heard[0] + len(heard)))


def help_of(*program):
    done = subprocess.run([sys.executable, *program, "--help"], cwd=ROOT, capture_output=True, text=True, check=True)
    return done.stdout


def has_option(help_text, option):
    return re.search(rf"(?<![\w-]){option}(?![\w-])", help_text) is not None


@pytest.mark.slow
def test_options_of_the_recordings_table_are_those_of_convert():
    text = (ROOT / "docs" / "troubleshooting.md").read_text()
    (table,) = re.findall(r"^## Recordings$.*?(^\|.*?)\n\n", text, re.MULTILINE | re.DOTALL)
    options = {command.split()[0] for command in re.findall(r"`(--[^`]+)`", table)} - {"--full-length"}
    assert len(options) > 5
    help_text = help_of("evaluate/convert.py")
    assert [option for option in options if not has_option(help_text, option)] == []


@pytest.mark.slow
def test_programs_on_every_page_have_the_options_that_are_shown():
    shown = {}
    for page, command in python_commands(*PAGES):
        if command[0].endswith(".py") and "/" in command[0]:
            options = {part.split("=")[0] for part in command[1:] if part.startswith("--")}
            shown.setdefault(command[0], {}).update(dict.fromkeys(options, page))
    assert shown
    for program, options in shown.items():
        if options:
            help_text = help_of(program)
            for option, page in options.items():
                assert has_option(help_text, option), f"{page}: {program} {option}"
