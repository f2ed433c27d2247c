"""The one script that the page runs for this package: arrow keys and the space bar command the robot."""

from typing import Final

# viser turns its own camera with the arrow keys, sliders and buttons take keys that they have the focus of, and a key
# that is held repeats. So these keys are taken before anybody sees them, and handed to the hotkeys alone, which listen
# on the document's element. Text that is being typed keeps them.
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

# HTML that is put into a page later runs no <script>; an image that has loaded tells.
_PIXEL: Final = "data:image/gif;base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7"

ARROWS_FIRST: Final = f'<img alt="" hidden src="{_PIXEL}" onload="{" ".join(_SCRIPT.split())}">'
"""HTML that makes it so; twice does no harm."""
