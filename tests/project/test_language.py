"""Plain technical English: words and habits that this project avoids, in pages, help texts, docstrings and comments.

`RULES` is the list, with what to write instead. A rule that matches a legitimate use gets an entry in `ALLOWED`, with
the reason.
"""

import re
import subprocess
import sys
from dataclasses import dataclass
from functools import cache, cached_property
from typing import NamedTuple

import pytest
from paths import ROOT
from prose import EXAMPLES, docstrings, has_prose, prose

from quadruped_env.live.__main__ import make_parser
from quadruped_env.live.nodes import SUMMARIES

PROGRAMS = [path for folder in ("train", "evaluate") for path in sorted((ROOT / folder).glob("*.py"))]

NOUNS = (
    "number|numbers|value|values|line|lines|panel|panels|table|tables|transform|transforms|message|messages|pose|poses|"
    "target|targets|phase|phases|sinusoid|sinusoids|vector|vectors|file|files|column|columns|row|rows|word|words|"
    "sentence|module|mean|generator|parameter|parameters|thread|process|topic|range|one|two|three|four|each"
)
UNITS = "joint|leg|foot|env|row|link|topic|axis|candidate|robot|panel|node|file|message|column|type|batch|pixel|term"


@dataclass(frozen=True)
class Rule:
    """A pattern that prose must not match, and what to write instead."""

    pattern: str
    instead: str
    only: tuple[str, ...] = ("",)
    """Beginnings of the paths that it holds for, where the word is right elsewhere."""

    @cached_property
    def compiled(self):
        """The pattern for text in lower case; its spaces also match one line end."""
        return re.compile(self.pattern.replace(" ", r"(?:[ \t]+|[ \t]*\n[ \t]*)"))


ENVS = ("quadruped_env/simulation", "quadruped_env/task", "quadruped_env/envs", "quadruped_env/policies")
"""Where a row is an env; elsewhere tables have rows"""

RULES = {
    # --- the glossary
    "row": Rule(r"\b(?<!-)rows?\b", "env, num_envs, env_ids", ENVS),
    "rows": Rule(
        r"\b\d[\d,]* rows\b|\b(?:a|each|every|one|per|the) row's\b|\brows? of (?:a|the) (?:env|batch)", "envs"
    ),
    "way": Rule(r"\bthe (?:way|ways) of the\b|\b(?:feet|foot|camera|robot|joint)'s? ways?\b", "trajectory"),
    "told": Rule(
        r"\b(?:is|are|was|were|be|been) told\b(?! apart)", "is called with, receives; velocity command, joint target"
    ),
    "asked": Rule(r"\b(?:is|are|was|were) asked (?:for|of)\b|\basks of\b", "velocity command; requested"),
    "far-off": Rule(r"\bhow far (?:\w+ ){0,3}off\b|\b(?:m/s|rad/s|rad|mm) off\b", "tracking error"),
    "stamp": Rule(r"(?<![-\w/.])stamps?\b(?!:)(?!\.sec)", "timestamp"),
    "falling": Rule(
        r"\b(?:time)?stamps? (?:that )?(?:fall|falls|rise|rises)\b|\b(?:falling|rising) (?:time)?stamps?\b",
        "non-monotonic, decreasing, increasing",
    ),
    "none": Rule(r"(?<!there\s)\b(?:is|are) none\b|\bnumbers? that (?:is|are) none\b", "NaN, not finite, invalid"),
    "is-no": Rule(
        r"(?<!there\s)\b(?:is|are) no (?:numbers?|text|characters?|symbolic|regular|tables?|bool|dds|names?|files?)\b",
        "is not a ...",
    ),
    "one-a": Rule(rf"\b(?:{NOUNS}|\d+|\)) an? (?:{UNITS})\b", "per: one per joint, one line per env"),
    "mend": Rule(r"\bmend(?:s|ed|ing)?\b", "fix, repair, auto-fix"),
    "somebody": Rule(
        r"\b(?:whoever|whom|somebody|someone|anybody|nobody)\b", "publisher, subscriber, process, no publisher"
    ),
    "who": Rule(
        r"\bwho (?:publishes|subscribes|listens|sends|reads|writes|calls|asks|starts|is publishing)\b",
        "the publisher, subscriber, process, caller that ...",
    ),
    "anew": Rule(r"\banew\b", "again"),
    "alike": Rule(r"\balike\b", "identically, both, the same"),
    "beside": Rule(r"\bbeside\b", "next to, together with, in addition to"),
    "likewise": Rule(r"\blikewise\b", "same units, also"),
    "feels": Rule(r"\bfeels?\b", "measurement, sensor reading"),
    "lost": Rule(r"\b(?:episodes?|robots?|envs?) (?:is|are|was|were) lost\b", "fall, terminated, truncated, diverged"),
    "pulls": Rule(r"\bpulls? no more\b", "limp (motors disabled)"),
    "rise": Rule(r"\bthe rise\b", "stand-up trajectory"),
    "happened": Rule(r"\bwhat happened\b", "failure gallery, worst episodes"),
    "longest-wait": Rule(r"\bthe longest wait\b|\bwhat is beyond\b", "timeout, threshold"),
    "knows-no": Rule(
        r"\bknows? (?:no|nothing)\b|\btaken apart\b", "must not be imported by, does not depend on; supports pickling"
    ),
    # --- one word per concept
    "article": Rule(r"\b(?:the|its|an) article\b", "the tutorial (`article` is the preset's name)"),
    "room": Rule(r"\b(?:a|the|each|every|this) rooms?\b|\brooms of\b", "package"),
    # --- riddles
    "anyhow": Rule(r"\banyhow\b|\bof no account\b", "random; is ignored"),
    "to-and-fro": Rule(r"\bto and fro\b", "back and forth"),
    "from-nothing": Rule(r"\b(?:learns?|learning|learned) from nothing\b", "from scratch"),
    "in-silence": Rule(r"\bin silence\b", "silently"),
    "once-for-all": Rule(r"\bonce for all\b", "permanently"),
}

AS_NOUN = "what"
MID_AIR = "mid-air"
DOCSTRING_RULES = {
    AS_NOUN: (
        "name the noun: 'Files written by a replay.', 'True if ...', 'Number of ...'",
        re.compile(r"(What|How|Whether)\b"),
    ),
    MID_AIR: (
        "a sentence that begins with its noun: 'Relative step tolerance.', units last",
        re.compile(r"(?!\S+ \([\w., ]*\)$)[a-z]\S* \S|At most\b"),
    ),
}
"""Beginnings of docstrings: of modules, classes and functions the first alone, of constants and fields both."""

BREAK = "\n\x01\n"
POEM = "name"
NAMES = re.compile(
    r"^ *class (?:Gate|Mirror|Rise|Sole)\b|^ *def (?:told|looks|barked)\b|\bself\.(?:told|looks|barked)\b"
    r"|^(?:TURNS|_?LOOK|_OBEYS|_KEEP)\b(?=.*=)",
    re.MULTILINE,
)
"""Definitions of classes, functions and constants whose names do not say what they are."""

ALLOWED: dict[tuple[str, str], str] = {
    ("quadruped_env/trajectory/formats/mapped_csv.py", "stamp"): "a key of the column maps, in an error",
    ("quadruped_env/trajectory/maps.py", "stamp"): "a key of the column maps, in the examples of the docstring",
    ("tests/cli/test_convert.py", "100 rows"): "rows of a recording, in the program's output",
    ("tests/trajectory/test_echo.py", "stamp"): "a key of the column maps, in their TOML",
    ("tests/trajectory/test_trajectory.py", "4 rows"): "rows of a trajectory, in its `repr`",
}
"""(path, found text) -> why it is right there."""


class Finding(NamedTuple):
    path: str
    line: int
    rule: str
    found: str
    instead: str

    def __str__(self):
        return f"{self.path}:{self.line}: found {self.found!r}; write: {self.instead}"


def findings_in(path, text):
    """List of what a file's text breaks."""
    found, lines = [], dict(prose(path, text))
    # No phrase matches across a break, and one search of all pieces is faster than one of each.
    readable = BREAK.join(lines.values())
    for rule_name, rule in RULES.items():
        if path.startswith(rule.only):
            for match in rule.compiled.finditer(readable):
                before = readable[: match.start()].split(BREAK)
                line = list(lines)[len(before) - 1] + before[-1].count("\n")
                found.append(Finding(path, line, rule_name, " ".join(match[0].split()), rule.instead))
    if path.endswith(".py"):
        for match in NAMES.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            instead = "a name that says what it is: watchdog_tripped, TimestampFilter, LEG_PHASES"
            found.append(Finding(path, line, POEM, match[0].strip(), instead))
        for line, docstring, assigned in docstrings(text):
            for rule_name, (instead, pattern) in DOCSTRING_RULES.items():
                if (assigned or rule_name == AS_NOUN) and pattern.match(docstring):
                    found.append(Finding(path, line, rule_name, " ".join(docstring.split())[:60], instead))
    return found


@cache
def all_findings():
    done = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if done.returncode:
        pytest.skip("not a git checkout")
    found = []
    for path in sorted(set(done.stdout.splitlines())):
        file = ROOT / path
        if has_prose(path) and file.is_file() and not file.is_symlink():
            found += [one for one in findings_in(path, file.read_text()) if (path, one.found) not in ALLOWED]
    return found


# --- the checks


def test_prose_has_no_words_to_avoid():
    assert not all_findings(), "\n" + "\n".join(map(str, all_findings()))


def test_allowed_exceptions_are_still_there():
    for path, found in ALLOWED:
        assert found in (ROOT / path).read_text().lower(), f"{path} has no {found!r}: delete it from ALLOWED"


def test_rules_match_the_wrong_phrase_and_not_the_right_one():
    for rule, wrong, right in (
        ("told", "the callback is told the share", "calls are told apart"),
        ("stamp", "stamps of a stream", "timestamps of header.stamp, --stamps and `stamp`"),
        ("none", "values that are none", "that there are none; none of them"),
        ("one-a", "one value a joint", "the value of a joint; 50 steps a second"),
        ("rows", "64 rows", "64 envs in rows of a table"),
        ("somebody", "if somebody publishes", "if a process publishes"),
        ("who", "who publishes it", "for those who have ROS"),
        ("beside", "the file beside\n    it", "besides"),
        ("article", "the article's gait", "preset `article`"),
        ("is-no", "that are no numbers", "there is no file"),
        ("far-off", "how far it is off", "0.031 m/s"),
        ("knows-no", "a controller that knows no browser", "what it knows of it"),
    ):
        assert [one.rule for one in findings_in("docs/page.md", wrong)] == [rule]
        assert findings_in("docs/page.md", right) == []


def test_python_prose_is_comments_docstrings_and_messages_but_no_code():
    source = '''"""Files beside `beside`."""
stamp = told["stamp"]  # anew  # noqa: S101
raise ValueError(f"{beside} is a "
                 "line a row")
pattern = r"somebody is told"
LIMIT = 3
"""of a file, likewise"""
def f():
    """Whether it is."""
'''
    found = [(one.line, one.rule) for one in findings_in("evaluate/x.py", source)]
    assert sorted(found) == [(1, "beside"), (2, "anew"), (3, "one-a"), (7, "likewise"), (7, MID_AIR), (9, AS_NOUN)]


def test_python_prose_of_tests_leaves_out_data_but_no_docstring():
    source = '''"""Files beside it."""
DATA = """
the line a row
"""
TEXT = f"""written {DATA} anew"""
assert DATA, "somebody reads"
def f():
    """Files likewise."""
'''
    in_program, in_test, in_examples = (
        sorted(one.rule for one in findings_in(path, source)) for path in ("evaluate/x.py", "tests/x.py", EXAMPLES)
    )
    assert in_program == ["anew", "beside", "likewise", "one-a", "somebody"]
    assert in_test == ["beside", "likewise", "somebody"]
    assert in_examples == ["beside", "likewise"]


def test_markdown_prose_has_comments_of_commands_but_not_the_commands():
    source = "Text.\n\n    mend beside.csv    # writes anew\n\n```sh\nlikewise  # alike\n```\n[page](docs/beside.md)\n"
    assert [one.rule for one in findings_in("docs/page.md", source)] == ["anew", "alike"]


def test_help_texts_have_no_words_to_avoid(capsys):
    for node in SUMMARIES:
        with pytest.raises(SystemExit):
            make_parser().parse_args([node, "--help"])
        page = re.sub(r"\n {2,}", " ", capsys.readouterr().out)
        found = findings_in(f"{node}.md", page)
        assert not found, "\n".join(map(str, found))


@pytest.mark.slow
@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.name)
def test_help_of_program_has_no_words_to_avoid(program):
    done = subprocess.run([sys.executable, program, "--help"], cwd=ROOT, capture_output=True, text=True, check=True)
    found = findings_in(f"{program.name} --help.md", re.sub(r"\n {2,}", " ", done.stdout))
    assert not found, "\n".join(map(str, found))
