"""Take the README's picture of the page that walks, in a headless Chromium.

The button of the language needs a font with Chinese characters.
"""

import argparse
import shutil
import sys
import tempfile
from io import BytesIO
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)

# isort: split
from quadruped_env.policies import load_policy
from quadruped_env.policies.files import SHOWN as POLICY
from quadruped_env.utils.program import run_program
from quadruped_env.walking_page import PAGE_FILE, write_page

PICTURE = Path("assets/pictures/page.webp")
BROWSER = "chromium"
WINDOW, WIDTH = {"width": 1230, "height": 780}, 640
"""Size of the window, and width of the picture, pixels."""
SHOWN = """() => {
    const { page } = quadruped;
    page.setPaused(true);
    document.getElementById('terrain').value = 'stairs';
    page.setTerrain('stairs');
    page.step(250);
    page.frame(1);
}"""


def main() -> int:
    """Parse the arguments and take the picture."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, default=PICTURE, help="what to write, over")
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Open the page, let the robot walk for 5 s, and write the picture."""
    from PIL import Image
    from playwright.sync_api import sync_playwright

    # With WebGL on the CPU. The page draws only on request: on the CPU a picture takes long.
    options = ["--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        write_page(load_policy(POLICY), Path(folder, PAGE_FILE), POLICY)
        browser = driver.chromium.launch(executable_path=shutil.which(BROWSER), args=options)
        page = browser.new_page(viewport=WINDOW, locale="en-US")
        page.add_init_script("window.requestAnimationFrame = () => 0;")
        page.goto(Path(folder, PAGE_FILE).as_uri())
        while not page.evaluate("Boolean(window.quadruped)"):
            page.wait_for_timeout(100)
        page.evaluate(SHOWN)
        picture = Image.open(BytesIO(page.screenshot()))
        browser.close()
    height = round(picture.height * WIDTH / picture.width)
    picture.convert("RGB").resize((WIDTH, height), Image.Resampling.LANCZOS).save(
        arguments.output, quality=80, method=6
    )
    print(f"written to {arguments.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
