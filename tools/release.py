"""Build the files of a release, and check them: an sdist and a wheel that a package index takes as they are.

    python tools/release.py --address https://github.com/OWNER/NAME --tag v1.2.3 -o dist

The files are those that git tracks, as they are in this checkout. On an index page no relative link works, so the page
gets absolute ones, to the tag in the repository at that address, and the package its `[project.urls]`. Nothing is
uploaded: `.github/workflows/release.yml` does that for every tag.
"""

import argparse
import re
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
LINK = re.compile(r"(!?)\[((?:[^\[\]]|!\[[^\]]*\]\([^)]*\))*)\]\((?!https?://|#)([^)\s]+)\)")
URLS = {"Homepage": "", "Source": "", "Documentation": "/tree/{tag}/docs", "Changelog": "/blob/{tag}/CHANGELOG.md",
        "Issues": "/issues"}  # fmt: skip
PLACEHOLDER = re.compile(r"git clone URL (\S+).*")
"""Line of the page in which the address is not known."""


class ReleaseError(Exception):
    """A release that cannot be made; the message says what to change."""


def check_release(folder: Path, tag: str) -> None:
    """Check that a checkout's version is the tag's, and its changelog has a dated section for it, on top.

    Raises:
        ReleaseError: if not; the message says what to change.
    """
    (version,) = re.findall(r'"(.+)"', (folder / "quadruped_env" / "_version.py").read_text(encoding="utf-8"))
    if tag != f"v{version}":
        raise ReleaseError(f"quadruped_env/_version.py: found {version}; the tag {tag} needs {tag.removeprefix('v')}")
    sections = re.split(r"^## (.*)$", (folder / "CHANGELOG.md").read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]
    heading, text = next(pair for pair in zip(sections[::2], sections[1::2], strict=True) if pair[1].strip())
    if not re.fullmatch(rf"{re.escape(version)} - \d{{4}}-\d\d-\d\d", heading):
        raise ReleaseError(
            f"CHANGELOG.md: the first section with entries is {heading!r} ({len(text.splitlines())} lines); call it "
            f"'{version} - YYYY-MM-DD', with the date of the release"
        )


def prepare(folder: Path, address: str, tag: str) -> None:
    """Give a copy of a checkout the links and addresses of an index page; `address` is the repository's."""
    page = folder / "README.md"
    page.write_text(
        absolute(PLACEHOLDER.sub(rf"git clone {address} \1", page.read_text(encoding="utf-8")), address, tag),
        encoding="utf-8",
    )
    project = folder / "pyproject.toml"
    lines = [f'{name} = "{address}{path.format(tag=tag)}"' for name, path in URLS.items()]
    urls = "\n".join(["[project.urls]", *lines, "", "[project.scripts]"])
    project.write_text(project.read_text(encoding="utf-8").replace("[project.scripts]", urls, 1), encoding="utf-8")


def absolute(page: str, address: str, tag: str) -> str:
    """Return a page in Markdown whose relative links and pictures lead to a tag of the repository."""

    def full(found: re.Match[str]) -> str:
        picture, text, target = found.groups()
        return f"{picture}[{LINK.sub(full, text)}]({address}/{'raw' if picture else 'blob'}/{tag}/{target})"

    return LINK.sub(full, page)


def build(address: str, tag: str, output: Path) -> list[Path]:
    """Write sdist and wheel of the files that git tracks to a directory, once twine finds no fault with them.

    Raises:
        ReleaseError: if one cannot be built, or twine finds a fault.
    """
    tracked = _run("git", "-C", ROOT, "ls-files", "-z")
    with TemporaryDirectory() as scratch:
        folder = Path(scratch, "source")
        for name in filter(None, tracked.split("\0")):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
        prepare(folder, address, tag)
        _run(sys.executable, "-m", "build", "--no-isolation", "--outdir", Path(scratch, "dist"), folder)
        files = sorted(Path(scratch, "dist").iterdir())
        _run(sys.executable, "-m", "twine", "check", "--strict", *files)
        output.mkdir(parents=True, exist_ok=True)
        return [Path(shutil.copy(file, output)) for file in files]


def _run(*command: str | Path) -> str:
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)  # noqa: S603
    if done.returncode:
        raise ReleaseError(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def main(arguments: Sequence[str] | None = None) -> int:
    """Check, build, and print the files."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--address", required=True, help="address of the repository, as its pages have it")
    parser.add_argument("--tag", required=True, help="tag of the release: v and the version")
    parser.add_argument("-o", "--output", type=Path, default=Path("dist"), help="directory (default: %(default)s)")
    given = parser.parse_args(arguments)
    try:
        check_release(ROOT, given.tag)
        files = build(given.address.rstrip("/"), given.tag, given.output)
    except ReleaseError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print(*files, sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
