"""Content of a page that walks, for tests."""

import base64
import gzip
import json
import re


def document_of(path):
    """The document of the page in a file."""
    (text,) = re.findall(r'id="document">([^<]*)<', path.read_text(encoding="utf-8"))
    return json.loads(gzip.decompress(base64.b64decode(text)))
