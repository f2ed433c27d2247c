"""Everything that the pages name exists: nodes, programs, options, make targets, links."""

import ast
import importlib
import re
import shlex
import subprocess
import sys

import numpy as np
import pytest
from pages import DOCS, FENCED, PAGES, anchors, commands_of, links
from paths import ROOT
from waiting import output_of

from quadruped_env import MissingExtraError, SinusoidalGait
from quadruped_env.cli.invocation import SUMMARIES as COMMANDS
from quadruped_env.cli.main import make_parser
from quadruped_env.live.__main__ import make_parser as make_node_parser
from quadruped_env.live.nodes import SUMMARIES
from quadruped_env.policies import load_policy

SCRIPT = re.compile(r"^(?:\S*/)?python3? (?=\w+/\S+\.py)")
PLACEHOLDER = re.compile(r"\b[A-Z]+$|[A-Z]{2,}|\.\.\.|[<>]")
"""Placeholder in a command: NODE, FILE, IN, N, <name>."""


def commands():
    """Page and words of every command of `mini-quadruped` on the pages, without placeholders for its subcommand.

    The changelog also names commands that are gone.
    """
    for page in (page for page in PAGES if page.name != "CHANGELOG.md"):
        for command in commands_of(page.read_text()):
            words = shlex.split(command) if re.match(r"\S*mini-quadruped ", command) else []
            name = words[2:3] if words[1:2] == ["live"] else words[1:2]
            if name and not PLACEHOLDER.search(name[0]):
                yield f"{page.name}: {command}", words[1:]


def parser_of(name, live=False):
    """The parser of a command, or of a node of `live`."""
    parser = make_node_parser(only=name) if live else make_parser(only=name)
    return parser._subparsers._group_actions[0].choices[name]


def scripts(*pages):
    for page in pages:
        for command in commands_of(page.read_text()):
            if SCRIPT.match(command):
                yield page.name, shlex.split(SCRIPT.sub("", command))


def test_pages_name_commands_to_check():
    live = [words[0] == "live" for _, words in commands()]
    assert sum(live) > 40
    assert len(live) - sum(live) > 60


def test_commands_on_every_page_exist_with_the_options_that_are_shown():
    for place, words in commands():
        live = words[0] == "live"
        name, *arguments = words[live:]
        if name.startswith("-"):
            continue
        assert name in (SUMMARIES if live else COMMANDS), place
        parser = parser_of(name, live)
        options = {word.split("=")[0] for word in arguments if word.startswith("--")}
        assert options <= set(parser._option_string_actions), place
        # A command may be shown with its beginning only: 'echo' without its topic.
        if arguments and "--help" not in arguments and not any(map(PLACEHOLDER.search, arguments)):
            parser.parse_args(arguments)


def test_scripts_and_make_targets_on_every_page_exist():
    for page, command in scripts(*PAGES):
        assert (ROOT / command[0]).is_file(), f"{page}: {command}"
    targets = set(re.findall(r"^([a-z0-9-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    for page in PAGES:
        for command in commands_of(page.read_text()):
            if re.match(r"make [a-z]", command) and page.name != "CHANGELOG.md":  # which names what was removed
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


def test_tables_on_every_page_are_well_formed():
    pages = "\n".join(FENCED.sub("", page.read_text()) for page in PAGES)
    for table in re.findall(r"^.*\n(?:^\|.*\n?)+", pages, re.MULTILINE):
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
def test_the_code_of_the_page_about_other_algorithms_runs(tmp_path, monkeypatch, capsys):
    contrib = pytest.importorskip("sb3_contrib", reason="sb3-contrib is not installed: pip install -e '.[contrib]'")
    monkeypatch.chdir(tmp_path)
    script, agent = snippets(ROOT / "docs" / "training.md")
    assert len(script.splitlines()) <= 20
    exec(script.replace("200_000", "4_096"), names := {})  # noqa: S102
    assert "Estimate(mean=" in capsys.readouterr().out
    loaded = load_policy("runs/mine")
    assert (loaded.activation, loaded.card["timesteps"]) == ("tanh", 4096)

    env = names["make_sb3_vec_env"](2, action_mode="residual")
    contrib.RecurrentPPO("MlpLstmPolicy", env, n_steps=8, device="cpu").save("recurrent")
    (tmp_path / "my_policy.py").write_text(agent)
    found = names["compare"](load_policy("my_policy.py"), 1, 3.0, [(0.3, 0.0)])
    assert found.rollouts["policy"].controller == "policy"


def test_python_on_every_page_compiles_and_imports_names_that_exist():
    for page in PAGES:
        for code in snippets(page):
            for node in ast.walk(ast.parse(code)):
                if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("quadruped_env"):
                    try:
                        module = importlib.import_module(node.module)
                        names = [alias.name for alias in node.names if not hasattr(module, alias.name)]
                    except MissingExtraError:
                        continue  # the extra is not installed here
                    assert not names, f"{page.name}: {ast.unparse(node)}"


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


def test_options_of_the_recordings_table_are_those_of_convert():
    text = (ROOT / "docs" / "troubleshooting.md").read_text()
    (table,) = re.findall(r"^## Recordings$.*?(^\|.*?)\n\n", text, re.MULTILINE | re.DOTALL)
    options = {command.split()[0] for command in re.findall(r"`(--[^`]+)`", table)} - {"--full-length"}
    assert len(options) > 5
    assert options <= set(parser_of("convert")._option_string_actions)
