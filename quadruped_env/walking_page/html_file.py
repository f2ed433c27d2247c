"""The page that walks: one HTML file that opens from the disk and makes no request."""

import base64
import gzip
import hashlib
import json
import re
from pathlib import Path
from typing import Final

from quadruped_env.policies.policy import Policy
from quadruped_env.utils.files import write_whole
from quadruped_env.walking_page.document import page_document

_ASSETS: Final = Path(__file__).parent / "assets"
"""Built by tools/page/build.mjs."""
_POLICY: Final = (
    "default-src 'none'; base-uri 'none'; form-action 'none'; img-src data: blob:; worker-src blob:; "
    "style-src {style}; script-src {script} 'wasm-unsafe-eval'"
)
"""Content security policy: nothing is loaded, and only these very scripts and styles run."""


def write_page(policy: Policy, path: Path, name: str = "policy") -> None:
    """Write the page in which a policy's robot walks; an existing file is replaced.

    Args:
        policy: the policy, of any robot.
        path: the file.
        name: name of the policy to show.

    Raises:
        QuadrupedError: if the policy is code or observes terms of the task's own file, or the file cannot be written.
    """
    content = json.dumps(page_document(policy, name), allow_nan=False).encode()
    style, script = ((_ASSETS / file).read_text(encoding="utf-8") for file in ("page.css", "page.js"))
    parts = {
        "csp": _POLICY.format(style=_source(style), script=_source(script)),
        "style": style,
        "script": script,
        "wasm": base64.b64encode((_ASSETS / "mujoco.wasm.gz").read_bytes()).decode(),
        "worker": base64.b64encode((_ASSETS / "worker.js.gz").read_bytes()).decode(),
        "document": base64.b64encode(gzip.compress(content, mtime=0)).decode(),
    }
    template = (_ASSETS / "page.html").read_text(encoding="utf-8")
    html = re.sub(r"\{\{(\w+)\}\}", lambda found: parts[found[1]], template)
    write_whole({path: html.encode()})


def _source(text: str) -> str:
    """Return an inline script or style as a source of a content security policy."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"
