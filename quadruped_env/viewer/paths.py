"""Paths as the page shows them: without the directories of this machine."""

import re
from pathlib import Path
from typing import Final

from quadruped_env.files import shown_path

_ABSOLUTE: Final = re.compile(r"(?<![\w./])/(?:[^\s/'\"]+/)+[^\s/'\",;]*")


def without_directories(text: str) -> str:
    """A text whose absolute paths are as `shown_path` shows them."""
    # First those whose names may have spaces.
    text = text.replace(f"{Path.cwd()}/", "").replace(f"{Path.home()}/", "")
    return _ABSOLUTE.sub(lambda match: shown_path(Path(match[0])), text)
