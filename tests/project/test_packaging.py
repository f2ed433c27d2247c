import os
import re
import shlex
import subprocess
import tarfile
import tempfile
import tomllib
import venv
import zipfile
from pathlib import Path

import pytest
from pages import links
from paths import ROOT
from tasks import LAYOUT

import release
from quadruped_env.cli.invocation import SUMMARIES
from quadruped_env.envs import MiniQuadrupedEnv
from quadruped_env.task import TaskConfig

USE = """
import gymnasium, quadruped_env
assert "site-packages" in quadruped_env.__file__, quadruped_env.__file__
for name in ("mini_quadruped.urdf", "mini_quadruped.xml", "scene.xml"):
    assert quadruped_env.asset_path(name).is_file()
env = gymnasium.make("MiniQuadruped-v0")
observation, _ = env.reset(seed=0)
policy = quadruped_env.policies.load_policy("flat")
for name in ("train", "evaluate", "tests", "tools", "benchmarks", "assets"):
    try:
        __import__(name)
    except ImportError:
        continue
    raise AssertionError(f"{name} is importable")
envs = gymnasium.make_vec("MiniQuadruped-v0", num_envs=4, action_mode=policy.action_mode)
observation, _ = envs.reset(seed=0)
for _ in range(50):
    observation, *_ = envs.step(policy.predict(observation))
print("stepped")
"""


def test_every_package_is_listed_for_the_wheel():
    listed = set(tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["setuptools"]["packages"])
    packages = {".".join(path.parent.relative_to(ROOT).parts) for path in (ROOT / "quadruped_env").rglob("__init__.py")}
    assert listed == packages | {"quadruped_env.assets"}


def test_notice_names_the_tutorial_and_is_a_licence_file():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    (title,) = re.findall("《.*》", (ROOT / "NOTICE").read_text())
    assert title in (ROOT / "README.md").read_text()
    assert project["license-files"] == ["LICENSE", "NOTICE"]


def test_ranges_of_the_dependencies():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    # Private parts of these are used.
    assert "viser>=1.1,<1.2" in extras["viewer"]
    assert extras["dds"] == ["cyclonedds>=11,<11.1"]


@pytest.mark.slow
def test_the_wheel_holds_the_package_and_its_assets_and_works_outside_the_repository(tmp_path):
    pytest.importorskip("build", reason="build is not installed: pip install -e '.[release]'")
    pytest.importorskip("twine", reason="twine is not installed: pip install -e '.[release]'")
    if not (ROOT / ".git").exists():
        pytest.skip("not a git checkout")
    release.build("https://example.org/o/r", "v0.0.0", tmp_path)
    (sdist,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        assert {f"{sdist.name.removesuffix('.tar.gz')}/{name}" for name in ("LICENSE", "NOTICE")} < {
            *archive.getnames()
        }
    (wheel,) = tmp_path.glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        page = archive.read(next(name for name in archive.namelist() if name.endswith("METADATA"))).decode()
    assert "Project-URL: Changelog, https://example.org/o/r/blob/v0.0.0/CHANGELOG.md" in page
    assert "git clone https://example.org/o/r mini-quadruped" in page
    assert all(target.startswith("https://") for target in links(page))
    names = zipfile.ZipFile(wheel).namelist()
    assert {name.split("/")[-1] for name in names if "/licenses/" in name} == {"LICENSE", "NOTICE"}
    assert {name.split("/")[0] for name in names if "dist-info" not in name} == {"quadruped_env"}
    for part in (
        "assets/mini_quadruped/scene.xml",
        "policies/shipped/flat/policy.safetensors",
        "export/firmware/firmware.ino",
        "walking_page/assets/mujoco.wasm.gz",
        "walking_page/assets/worker.js.gz",
        "walking_page/assets/page.js",
        "py.typed",
    ):
        assert f"quadruped_env/{part}" in names
    assert any(name.startswith("quadruped_env/report/pages/templates/") for name in names)
    assert "quadruped_env/robot/templates/leg.urdf" in names

    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"} | {"BROWSER": "true"}
    environment = tmp_path / "venv"
    venv.create(environment, with_pip=True)
    python = environment / "bin" / "python"
    subprocess.run(
        [python, "-m", "pip", "install", "--quiet", "-c", str(ROOT / "constraints.txt"), str(wheel)],
        check=True,
        capture_output=True,
        env=clean,
    )
    result = subprocess.run([python, "-c", USE], cwd=tmp_path, env=clean, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    assert "stepped" in result.stdout

    def command(*arguments):
        program = [environment / "bin" / "mini-quadruped", *arguments]
        return subprocess.run(program, cwd=tmp_path, env=clean, capture_output=True, text=True, check=False)

    shown = command("demo", "-o", "walk.html")
    assert shown.returncode == 0, shown.stderr
    assert (tmp_path / "walk.html").stat().st_size > 1_000_000
    listed = command("--help")
    assert listed.returncode == 0, listed.stderr
    assert all(name in listed.stdout for name in SUMMARIES)
    done = command("baseline", "--seconds", "1", "--episodes", "1", "-o", "a.csv")
    assert done.returncode == 0, done.stderr
    assert command("convert", "a.csv", "b.csv").returncode == 0
    refused = command("evaluate", "nowhere")
    assert refused.returncode == 2
    advice = re.fullmatch(r"mini-quadruped evaluate: error: .* train one with '(.*) train'\n", refused.stderr)
    assert advice, refused.stderr
    named = subprocess.run(
        [*shlex.split(advice[1]), "train", "--help"], cwd=tmp_path, env=clean, capture_output=True, check=False
    )
    assert named.returncode == 0


def test_the_tables_of_the_docstring_are_the_terms():
    doc = MiniQuadrupedEnv.__doc__
    lines = [line.strip() for line in doc.splitlines() if line.strip().startswith("|")]
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines]
    terms = {row[0].strip("`"): row for row in rows if len(row) == 4 and row[0].startswith("`")}
    assert {name: float(row[3]) for name, row in terms.items()} == TaskConfig().reward.weights
    assert len({row[1] for row in terms.values()}) == len(terms), "each has a description of its own"
    fields = {row[1].strip("`"): row for row in rows if len(row) == 6 and row[1].startswith("`")}
    assert list(fields) == list(LAYOUT.slices)
    for name, columns in LAYOUT.slices.items():
        assert fields[name][0] == f"{columns.start}-{columns.stop - 1}"
        assert float(fields[name][4]) == LAYOUT.scale[columns.start]
        assert fields[name][5] == f"+-{LAYOUT.high[columns.start]:g}"
    assert not re.search(r"\{\w+\}", doc), "every placeholder is filled"
    assert re.search(rf"\b{TaskConfig().reward.foot_lift:g} m\b", doc)


def test_the_repository_names_no_home_and_no_registry():
    tracked = subprocess.run(["git", "-C", str(ROOT), "ls-files"], capture_output=True, text=True, check=False)
    if tracked.returncode:
        pytest.skip("not a git checkout")
    # The directory for temporary files is the same on many machines, and tests name it.
    places = {Path.home(), ROOT, ROOT.parent} - {Path(tempfile.gettempdir())}
    for name in tracked.stdout.splitlines():
        if Path(name).suffix in {".py", ".md", ".toml", ".txt", ".xml", ".urdf", ".json"}:
            text = (ROOT / name).read_text()
            for place in places:
                assert f"{place}/" not in text, name
