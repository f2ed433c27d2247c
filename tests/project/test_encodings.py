"""Text is UTF-8 in every locale, also where the system's own encoding is another one, as in a Chinese GBK locale."""

import ast
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from paths import ROOT
from waiting import DEADLINE

SOURCES = [path for folder in ("quadruped_env", "tools", ".ci") for path in sorted((ROOT / folder).rglob("*.py"))]
STRICT = """
import sys, warnings
warnings.filterwarnings("error", category=EncodingWarning, module="quadruped_env")
from quadruped_env.cli.main import main
sys.exit(main())
"""
TINY = ("--timesteps", "1024", "--num-envs", "16", "--n-steps", "16", "--batch-size", "64")
SHORT = ("--seeds", "1", "--seconds", "2")
CORE = (
    ("page", "-o", "w.html"),
    ("demo",),
    ("baseline", "--seconds", "1", "--episodes", "1", "-o", "a.csv"),
    ("convert", "a.csv", "b.csv"),
    ("replay", "a.csv", "-o", "replayed"),
)
ALL = (*CORE, ("train", *TINY), ("evaluate", "--no-video", *SHORT), ("compare", "flat", "runs/latest", *SHORT))


def calls_without_encoding(code):
    """Lines of the calls that read or write text in the locale's encoding."""
    found = []
    for node in ast.walk(ast.parse(code)):
        if not isinstance(node, ast.Call) or any(keyword.arg == "encoding" for keyword in node.keywords):
            continue
        name = getattr(node.func, "attr", getattr(node.func, "id", ""))
        values = [*node.args, *(keyword.value for keyword in node.keywords if keyword.arg == "mode")]
        modes = [str(value.value) for value in values if isinstance(value, ast.Constant)]
        text = any(keyword.arg in ("text", "universal_newlines") for keyword in node.keywords)
        opened = name == "open" and any(mode.strip("+t") in ("r", "w", "a", "x") for mode in modes)
        # Path.open, without an argument, and the built-in function with the name alone.
        default = name == "open" and (not values or (isinstance(node.func, ast.Name) and len(modes) == 0))
        whole = (name == "read_text" and not node.args) or (name == "write_text" and len(node.args) < 2)
        if text or opened or default or whole:
            found.append((node.lineno, ast.unparse(node.func)))
    return found


# `open` of libraries for recordings and films.
OTHERS = {"reader.open", "av.open"}


def test_every_text_file_and_pipe_names_its_encoding():
    found = {path: calls_without_encoding(path.read_text(encoding="utf-8")) for path in SOURCES}
    assert [f"{path}:{line}" for path, calls in found.items() for line, name in calls if name not in OTHERS] == []


@pytest.mark.parametrize(
    "code",
    [
        "p.read_text()",
        "p.write_text(t)",
        "open(n)",
        "p.open()",
        "p.open('a')",
        "open(n, mode='w')",
        "run(c, text=True)",
    ],
)
def test_calls_without_encoding_are_found(code):
    assert calls_without_encoding(code)


@pytest.mark.parametrize("code", ["p.read_text(encoding='utf-8')", "p.open('rb')", "open(n, 'wb')", "Folder.open(p)"])
def test_other_calls_are_not(code):
    assert calls_without_encoding(code) == []


@pytest.fixture(scope="module")
def gbk(tmp_path_factory):
    """Environment variables of a GBK locale."""
    if shutil.which("localedef") is None:
        pytest.skip("localedef is not installed")
    folder = tmp_path_factory.mktemp("locales")
    command = ["localedef", "-i", "zh_CN", "-f", "GBK", folder / "zh_CN.GBK"]
    done = subprocess.run(command, capture_output=True, check=False)
    if not (folder / "zh_CN.GBK").is_dir():
        pytest.skip(f"no GBK locale can be made (Debian: apt install locales): {done.stderr.decode(errors='replace')}")
    kept = {name: value for name, value in os.environ.items() if name not in ("PYTHONIOENCODING", "PYTHONUTF8")}
    gbk = {**kept, "LOCPATH": str(folder), "LC_ALL": "zh_CN.GBK", "PYTHONUTF8": "0", "BROWSER": "true"}
    code = "import locale; print(locale.getpreferredencoding())"
    shown = subprocess.run([sys.executable, "-c", code], env=gbk, capture_output=True, text=True, check=True).stdout
    assert shown.strip().upper() in ("GBK", "CP936")
    return gbk


def run(commands, folder, environment, *python):
    for command in commands:
        done = subprocess.run(
            [sys.executable, *python, *command],
            cwd=folder,
            env=environment,
            capture_output=True,
            timeout=DEADLINE,
            check=False,
        )
        assert done.returncode == 0, (command, done.stderr.decode(errors="replace"))


def check_pages(folder, names):
    for name in names:
        text = (Path(folder) / name).read_bytes().decode("utf-8")
        assert "\ufffd" not in text.replace('"\ufffd"', ""), name
        assert "<meta charset=" in text[:2000].lower(), name


def test_programs_run_in_a_gbk_locale(tmp_path, gbk):
    run(CORE, tmp_path, gbk, "-m", "quadruped_env")
    check_pages(tmp_path, ["w.html", "mini-quadruped-demo.html"])
    assert "\u8f6c" in (tmp_path / "w.html").read_text(encoding="utf-8"), "its Chinese words"


@pytest.mark.slow
def test_programs_never_use_the_encoding_of_the_locale(tmp_path):
    run(CORE, tmp_path, {**os.environ, "BROWSER": "true"}, "-X", "warn_default_encoding", "-c", STRICT)


@pytest.mark.slow
def test_all_steps_of_the_tutorial_run_in_a_gbk_locale(tmp_path, gbk):
    run(ALL, tmp_path, gbk, "-m", "quadruped_env")
    check_pages(tmp_path, ["runs/latest/evaluation/report.html", "results/comparison/report.html"])


@pytest.mark.slow
def test_all_steps_of_the_tutorial_never_use_the_encoding_of_the_locale(tmp_path):
    run(ALL, tmp_path, {**os.environ, "BROWSER": "true"}, "-X", "warn_default_encoding", "-c", STRICT)
