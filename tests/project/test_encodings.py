"""Text is UTF-8 in every locale, also where the system's own encoding is another one, as in a Chinese GBK locale."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from waiting import DEADLINE

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
    commands = [("page", "-o", "w.html"), ("baseline", "--seconds", "1", "--episodes", "1", "-o", "a.csv")]
    both = f"from quadruped_env.cli.main import main; assert not any(main(typed) for typed in {commands})"
    run([("-c", both)], tmp_path, gbk)
    check_pages(tmp_path, ["w.html"])
    assert "\u8f6c" in (tmp_path / "w.html").read_text(encoding="utf-8"), "its Chinese words"


@pytest.mark.slow
def test_all_steps_of_the_tutorial_run_in_a_gbk_locale(tmp_path, gbk):
    run(ALL, tmp_path, gbk, "-m", "quadruped_env")
    check_pages(tmp_path, ["runs/latest/evaluation/report.html", "results/comparison/report.html"])


@pytest.mark.slow
def test_all_steps_of_the_tutorial_never_use_the_encoding_of_the_locale(tmp_path):
    run(ALL, tmp_path, {**os.environ, "BROWSER": "true"}, "-X", "warn_default_encoding", "-c", STRICT)
