"""HTML pages: templates, embedded files, and the fields that tell where numbers come from."""

import base64
import json
import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import MissingExtraError
from quadruped_env.utils.files import write_whole
from quadruped_env.utils.provenance import circumstances

METRICS_FILE: Final = "metrics.json"
FORMAT_VERSION: Final = 3


def provenance(command_line: str) -> dict[str, Any]:
    """Return the first fields of a document of numbers: its format, and where it comes from."""
    return {"format_version": FORMAT_VERSION, **circumstances(command_line)}


def figure(title: str, svg: str, caption: str) -> dict[str, str]:
    """Return the template variables of a figure: title, SVG document as a data URL, and caption."""
    return {"title": title, "source": data_url("image/svg+xml", svg.encode()), "caption": caption}


def data_url(kind: str, content: bytes) -> str:
    """Return a file as a base64 data URL; `kind` is its media type."""
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def without_nan(value: Any) -> Any:
    """Return nested plain values with None for NaN and infinities, which JSON cannot represent."""
    if isinstance(value, Mapping):
        return {key: without_nan(item) for key, item in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [without_nan(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def write_html(path: Path, template: str, context: Mapping[str, Any]) -> None:
    """Render a template to a file; an existing file is replaced. A MissingExtraError if jinja2 is not installed."""
    try:
        from jinja2 import Environment, FileSystemLoader, StrictUndefined
    except ImportError as error:
        raise MissingExtraError("The report", "report") from error

    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent / "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["glued"] = _glued
    environment.filters["json"] = lambda value: json.dumps(value, indent=2)
    html = environment.get_template(template).render(**context)
    write_whole({path: html.encode()})


def _glued(text: str) -> str:
    """Return the text with no-break spaces between numbers and their units."""
    return re.sub(r"(?<=\d) (?=(%|m|s|N|W|Hz|rad)\b|%)", "\N{NO-BREAK SPACE}", text)
