"""A policy as one HTML file, in which its robot walks in the reader's browser."""

from quadruped_env.export.manifest import PAGE_FILE
from quadruped_env.walking_page.document import check_exportable
from quadruped_env.walking_page.html_file import write_page

__all__ = ["PAGE_FILE", "check_exportable", "write_page"]
