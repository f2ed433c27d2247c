"""Paths as the page shows them: without the directories of this machine."""

import re
from pathlib import Path
from typing import Final

_ABSOLUTE: Final = re.compile(r"(?<![\w./])/(?:[^\s/'\"]+/)+[^\s/'\",;]*")


def shown_path(path: Path) -> str:
    """A path from the working directory on; of one that lies elsewhere, its own name and its directory's."""
    if not path.is_absolute():
        return str(path)
    try:
        return str(path.relative_to(Path.cwd()))
    except ValueError:
        # The root, and what is often a person's directory below it, are not shown.
        return "/".join(path.parts[-2:]) if len(path.parts) > 4 else path.name


def without_directories(text: str) -> str:
    """A text whose absolute paths are as `shown_path` shows them."""
    # First those whose names may have spaces.
    text = text.replace(f"{Path.cwd()}/", "").replace(f"{Path.home()}/", "")
    return _ABSOLUTE.sub(lambda match: shown_path(Path(match[0])), text)
