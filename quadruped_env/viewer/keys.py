"""Script on the page that makes arrow keys and the space bar control the robot."""

from typing import Final

# viser moves its camera with the arrow keys, focused sliders and buttons consume keys, and held keys repeat. Therefore
# the script captures these keys before other listeners and dispatches them only to the hotkeys, which listen on the
# document element. Text fields keep their keys.
_SCRIPT: Final = """
if (!window.quadrupedKeys) {
  window.quadrupedKeys = ['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'Space'];
  window.addEventListener('keydown', function (event) {
    var typing = event.target.closest &amp;&amp; event.target.closest('input:not([type=checkbox]), textarea, [contenteditable]');
    var held = event.ctrlKey || event.altKey || event.metaKey || event.shiftKey;
    if (!event.isTrusted || typing || held || window.quadrupedKeys.indexOf(event.code) === -1) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (!event.repeat) {
      document.documentElement.dispatchEvent(
        new KeyboardEvent('keydown', {key: event.key, code: event.code, cancelable: true}));
    }
  }, true);
}
"""  # noqa: E501

# HTML inserted into a page later does not run <script> elements; the load event of an image does.
_PIXEL: Final = "data:image/gif;base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7"

ARROWS_FIRST: Final = f'<img alt="" hidden src="{_PIXEL}" onload="{" ".join(_SCRIPT.split())}">'
"""HTML that installs the script; inserting it twice has no effect."""
