"""Release and packages: index page, changelog, workflow, conda recipe and container."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml
from pages import links
from paths import ROOT

import release
from quadruped_env import __version__
from quadruped_env.viewer import PORT

ADDRESS, TAG = "https://example.org/o/r", f"v{__version__}"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def lint(program, *arguments):
    """Run a linter, which must find nothing; skip without it."""
    path = shutil.which(program, path=os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]]))
    if path is None:
        pytest.skip(f"{program} is not installed: pip install -e '.[release]'")
    done = subprocess.run([path, *arguments], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_links_of_the_index_page_lead_to_the_tag_in_the_repository():
    assert release.absolute("[![a](b.png)](c.md#d) [e](#f) ![g](h.png)", ADDRESS, TAG) == (
        f"[![a]({ADDRESS}/raw/{TAG}/b.png)]({ADDRESS}/blob/{TAG}/c.md#d) [e](#f) ![g]({ADDRESS}/raw/{TAG}/h.png)"
    )
    text = (ROOT / "README.md").read_text()
    for before, after in zip(links(text), links(release.absolute(text, ADDRESS, TAG)), strict=True):
        kind = "raw" if before.startswith("assets/pictures/") else "blob"
        assert after == (before if "://" in before else f"{ADDRESS}/{kind}/{TAG}/{before}")


@pytest.mark.parametrize(
    ("heading", "tag", "problem"),
    [
        (f"{__version__} - 2026-12-01", TAG, None),
        ("Unreleased", TAG, rf"CHANGELOG.md: the first section with entries is 'Unreleased'.*'{__version__} - YYYY"),
        (f"{__version__} - soon", TAG, "with the date"),
        (f"{__version__} - 2026-12-01", "v99.0", "_version.py: found .*; the tag v99.0 needs 99.0"),
    ],
)
def test_release_needs_the_tags_version_and_a_dated_section_on_top_of_the_changelog(heading, tag, problem, tmp_path):
    (tmp_path / "quadruped_env").mkdir()
    shutil.copy(ROOT / "quadruped_env" / "_version.py", tmp_path / "quadruped_env")
    empty = "" if heading == "Unreleased" else "## Unreleased\n\n"
    (tmp_path / "CHANGELOG.md").write_text(f"# Changelog\n\n{empty}## {heading}\n\n- More.\n\n## 0.0.1 - 2026-01-01\n")
    if problem is None:
        release.check_release(tmp_path, tag)
        return
    with pytest.raises(release.ReleaseError, match=problem):
        release.check_release(tmp_path, tag)


def test_workflow_publishes_what_the_script_builds_without_a_key():
    lint("zizmor", "--offline", "--pedantic", ".github")
    workflow = yaml.safe_load((ROOT / ".github" / "workflows" / "release.yml").read_text())
    assert workflow["jobs"]["publish"]["permissions"] == {"id-token": "write"}
    assert "secrets." not in str(workflow)
    (command,) = re.findall(r"python (tools/release.py .*?)'", str(workflow))
    assert {"--address", "--tag"} < {*command.split()}


def test_conda_recipe_renders_with_the_projects_version_and_dependencies():
    builder = pytest.importorskip("rattler_build", reason="rattler-build is missing: pip install -e '.[release]'")
    (variant,) = builder.Stage0Recipe.from_file(ROOT / "recipe" / "recipe.yaml").render(builder.VariantConfig())
    recipe = variant.recipe.to_dict()
    assert recipe["package"] == {"name": PROJECT["name"], "version": __version__}
    ((script, function),) = PROJECT["scripts"].items()
    assert recipe["build"]["python"]["entry_points"] == [f"{script} = {function}"]
    needs = {name.replace("mujoco-python", "mujoco").replace(" ", "") for name in recipe["requirements"]["run"]}
    assert needs == {f"python{PROJECT['requires-python']}", *PROJECT["dependencies"]}
    assert recipe["about"]["license_file"] == PROJECT["license-files"]


def test_container_has_the_viewers_port_and_extras_that_exist():
    lint("hadolint", "Dockerfile")
    text = (ROOT / "Dockerfile").read_text()
    assert re.findall(r"^EXPOSE (\d+)$", text, re.MULTILINE) == [str(PORT)]
    (extras,) = re.findall(r"/source\[([\w,]+)\]", text)
    assert set(extras.split(",")) < set(PROJECT["optional-dependencies"])
    # Otherwise the viewer would be open to every machine that reaches this one.
    assert re.findall(r"-p (\S+):\d+:\d+", text) == ["127.0.0.1"]
    copied = [line.removeprefix("!") for line in (ROOT / ".dockerignore").read_text().splitlines() if line[0] == "!"]
    assert all((ROOT / name).exists() for name in copied)
