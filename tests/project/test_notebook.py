"""The notebook: it runs from the first cell to the last, and is kept without results."""

import asyncio
import json
import warnings

import pytest
from pages import links
from paths import ROOT
from waiting import SCALE

NOTEBOOK = ROOT / "docs" / "first-walk.ipynb"


def test_notebook_is_kept_without_results_and_links_pages_that_exist():
    cells = json.loads(NOTEBOOK.read_text())["cells"]
    code = [cell for cell in cells if cell["cell_type"] == "code"]
    assert code
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in code)
    assert all((NOTEBOOK.parent / target).exists() for cell in cells for target in links("".join(cell["source"])))


@pytest.mark.slow
def test_notebook_trains_films_and_reports(opengl, tmp_path, monkeypatch):
    nbclient = pytest.importorskip("nbclient", reason="nbclient is not installed: pip install -e '.[dev]'")
    pytest.importorskip("ipykernel", reason="ipykernel is not installed: pip install -e '.[dev]'")
    import nbformat

    monkeypatch.setenv("FIRST_WALK_STEPS", "12288")
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    client = nbclient.NotebookClient(
        notebook, timeout=300 * SCALE, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of Jupyter's own libraries
        asyncio.run(client.async_execute())
    kinds = {kind for cell in notebook.cells for output in cell.get("outputs", ()) for kind in output.get("data", ())}
    assert {"image/png", "text/html"} <= kinds, "the learning curve and the film"
    printed = "".join(output.get("text", "") for cell in notebook.cells for output in cell.get("outputs", ()))
    assert "Forwards: velocity error" in printed
    (run,) = tmp_path.glob("runs/2*")
    assert (run / "evaluation" / "report.html").stat().st_size > 100_000
    assert (tmp_path / "walk.html").stat().st_size > 1_000_000
