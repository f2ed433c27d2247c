"""README.md and README.zh-CN.md: the first steps work, the figures are true, both say the same."""

import ast
import contextlib
import io
import re
import tomllib

import gymnasium
import pytest
import yaml
from pages import CHINESE as CHINESE_PAGES
from pages import FENCED, PAGES, commands_of, inline_code, links
from paths import ROOT

README = (ROOT / "README.md").read_text()
CHINESE = (ROOT / "README.zh-CN.md").read_text()
TUTORIAL = "The tutorial"
"""Section of the Chinese README that has the Chinese pages instead of the English ones."""
FIGURE = re.compile(r"(?<![\w.])[-+]?\d+(?:,\d{3})*(?:\.\d+)?(?:\s?(?:m/s|rad/s|rad|N m|kg|Hz|ms|s|%)(?![A-Za-z]))?")


def sections(text):
    """Heading -> text of every second-level section, in order; the text before the first has the heading ''."""
    parts = re.split(r"^## (.*)$", text, flags=re.MULTILINE)
    return dict(zip(["", *parts[1::2]], parts[0::2], strict=True))


def figures(text):
    return {
        " ".join(found.split()) for found in FIGURE.findall(re.sub(r"`[^`]*`|\]\([^)]*\)", "", FENCED.sub("", text)))
    }


def python_of(text):
    return [block for language, block in FENCED.findall(text) if language == "python"]


def dumped(block):
    """A block of Python without its comments, docstrings and formatting."""
    nodes = ast.walk(tree := ast.parse(block))
    for node in nodes:
        if isinstance(node, ast.FunctionDef) and ast.get_docstring(node):
            del node.body[0]
    return ast.dump(tree)


def table_lines(text):
    """Contents of a section's table lines, without their headers and rules."""
    return [line for line in text.splitlines() if line.startswith("| ") and not line.startswith("| |")]


def test_snippet_printed_distance_is_command_times_time():
    (snippet,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(snippet, {})  # noqa: S102
    (distance,) = re.fullmatch(r"(-?[0-9.]+) m forward\n", printed.getvalue()).groups()
    # 10 s at 0.5 m/s, from rest.
    assert float(distance) == pytest.approx(5.0, abs=0.5)


def test_readme_is_one_page_in_the_agreed_order():
    assert len(README.splitlines()) <= 120
    assert list(sections(README)) == [
        "",
        "Install",
        "In Python",
        "Your own robot",
        "The environment",
        "Commands",
        "Results",
        TUTORIAL,
        "Documentation",
    ]
    assert README.index("walk.webp") < README.index("A small four-legged robot") < README.index("## Install")
    assert len(table_lines(sections(README)["Commands"])) == 1 + 7
    assert len(table_lines(sections(README)["Results"])) == 1 + 3


def test_environment_table_states_the_spaces_terms_and_limits_of_the_env():
    env = gymnasium.make("MiniQuadruped-v0")
    _, info = env.reset(seed=0)
    *_, info = env.step(env.action_space.sample())
    table = sections(README)["The environment"]
    assert f"`Box(-1, 1, {env.action_space.shape})`, {1 / env.unwrapped.dt:.0f} Hz" in table
    assert f"`Box({env.observation_space.shape})`" in table
    assert f"sum of {sum(name.startswith('reward_') for name in info)} weighted terms" in table
    assert f"| {env.spec.max_episode_steps * env.unwrapped.dt:g} s; terminated" in table
    specification = " ".join(type(env.unwrapped).__doc__.split())
    for limit in ("-0.3 to 0.6 m/s", "-0.8 to 0.8 rad/s"):
        assert limit in table
        assert limit in specification
    mass = sum(env.unwrapped.model.body_mass)
    assert f"| {mass:.0f} kg, {env.action_space.shape[0]} joints" in table


def test_three_figures_are_those_of_the_measurements_page():
    measurements = (ROOT / "docs" / "measurements.md").read_text()
    transfer, speed, commands = (line.split("|")[2] for line in table_lines(sections(README)["Results"])[1:])
    (loss,) = re.findall(r"[\d.]+", transfer)
    second_engine = (ROOT / "docs" / "notes" / "second-engine.md").read_text()
    assert f"The policy loses at most {loss} % of a forward velocity" in second_engine
    steps, share = re.findall(r"\d[\d,.]*\d", speed)
    assert f"| vector env, 256 envs, over bare Batch.step | {share} |" in measurements
    assert f"| {steps} of " in measurements
    met, alone = re.fullmatch(r" (\d+) %; (\d+) % ", commands).groups()
    measured = " ".join(measurements.split())
    assert f"it meets {met} % of the 256 commands of [the suite](suite.md), its gait alone {alone} %" in measured


# --- the two languages


def test_both_languages_have_the_language_line_on_top_and_as_many_sections():
    assert README.startswith("English | [简体中文](README.zh-CN.md)\n")
    assert CHINESE.startswith("[English](README.md) | 简体中文\n")
    assert len(sections(README)) == len(sections(CHINESE))


def test_both_languages_have_the_same_commands_figures_and_links():
    pages = {"README.md", "README.zh-CN.md"}
    for (heading, english), chinese in zip(sections(README).items(), sections(CHINESE).values(), strict=True):
        if heading != TUTORIAL:
            assert sorted(commands_of(english)) == sorted(commands_of(chinese)), heading
            assert sorted(inline_code(english)) == sorted(inline_code(chinese)), heading
            assert figures(english) == figures(chinese), heading
            assert sorted(set(links(english)) - pages) == sorted(set(links(chinese)) - pages), heading
            code = [[ast.dump(ast.parse(block)) for _, block in FENCED.findall(text)] for text in (english, chinese)]
            assert code[0] == code[1], heading


def test_chinese_tutorial_map_covers_the_english_one():
    english, chinese = ((ROOT / "docs" / page).read_text() for page in ("from-the-tutorial.md", "zh/tutorial.md"))
    # Its first cells that are codes or section numbers stand in both languages.
    numbers = [re.match(r"\| ((?:\d(?:\.\d)?(?:, |、)?)+) ", line) for line in table_lines(english)]
    expected = [match[1].replace(", ", "、") for match in numbers if match]
    assert len(expected) == 13
    assert re.findall(r"^\| ((?:\d(?:\.\d)?、?)+) ", chinese, re.MULTILINE) == expected
    assert re.findall(r"troubleshooting\.md#(\d)", chinese) == list("1234567")
    assert sorted(inline_code(sections(english)["Commands"])) == sorted(inline_code(sections(chinese)["命令对照"]))


def test_chinese_pages_have_commands_and_code_of_the_english_ones():
    english = [page.read_text() for page in PAGES if page not in CHINESE_PAGES]
    commands = {command for text in english for command in commands_of(text)}
    code = {dumped(block) for text in english for block in python_of(text)}
    for page in CHINESE_PAGES:
        text = page.read_text()
        unknown = [command for command in commands_of(text) if "quadruped " in command and command not in commands]
        assert unknown == [], page.name
        assert {dumped(block) for block in python_of(text)} <= code, page.name


# --- citation


def test_citation_repeats_the_projects_metadata():
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    version = re.search(r'"(.*)"', (ROOT / "quadruped_env" / "_version.py").read_text())[1]
    assert citation["cff-version"] == "1.2.0"
    assert citation["version"] == version
    assert citation["license"] == project["license"]
    assert citation["authors"] == project["authors"]
    assert citation["abstract"] == project["description"]
    assert citation["keywords"] == project["keywords"]
    (tutorial,) = citation["references"]
    assert tutorial["title"] in README
    assert tutorial["title"] in CHINESE
    assert tutorial["title"] in (ROOT / "docs" / "from-the-tutorial.md").read_text()
