"""Paths for display on the page, without this machine's directories."""

import re
from pathlib import Path
from typing import Final

from quadruped_env.utils.files import shown_path

_ABSOLUTE: Final = re.compile(r"(?<![\w./])/(?:[^\s/'\"]+/)+[^\s/'\",;]*")


def without_directories(text: str) -> str:
    """Replace absolute paths in a text as `shown_path` does."""
    # First the known directories, whose names may contain spaces.
    text = text.replace(f"{Path.cwd()}/", "").replace(f"{Path.home()}/", "")
    return _ABSOLUTE.sub(lambda match: shown_path(Path(match[0])), text)
