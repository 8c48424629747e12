"""Notebooks and IPython: completion, the line that says what takes long, and the example."""

import pytest
from conftest import REPOSITORY, library

import homogen

EXAMPLES = REPOSITORY / "examples/python"

# Of the kernel, and of what it is started by.
pytestmark = pytest.mark.filterwarnings("ignore")


def test_names_are_completed(arm):
    shell = library("IPython.core.interactiveshell").InteractiveShell()
    shell.user_ns.update(arm=arm, homogen=homogen)
    completer = library("IPython.core.completer")

    def offered(text):
        with completer.provisionalcompleter():
            return {found.text for found in shell.Completer.completions(text, len(text))}

    assert {"inverse_dynamics", "inverse_kinematics"} <= offered("arm.inv")
    assert "inverse_dynamics" in offered("arm.plain.inv")
    assert "frame=" in offered("arm.forward_kinematics(q, fr")
    assert "floating=" in offered("homogen.load('x', flo")


def test_a_notebook_shows_what_takes_long():
    nbclient, nbformat = library("nbclient"), library("nbformat")
    library("ipykernel")
    program = "import time\nfrom homogen._progress import working\nwith working('reading'):\n    time.sleep(1.5)"
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(program)])
    nbclient.NotebookClient(notebook, timeout=60).execute()
    shown = "".join(output["text"] for output in notebook.cells[0].outputs)
    assert "reading, 1 s" in shown


def test_a_notebook_runs():
    nbclient, nbformat = library("nbclient"), library("nbformat")
    library("ipykernel")
    library("matplotlib")
    notebook = nbformat.read(EXAMPLES / "panda.ipynb", 4)
    nbclient.NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(EXAMPLES)}}).execute()
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    kinds = {kind for output in outputs for kind in output.get("data", {})}
    assert {"text/html", "image/png"} <= kinds
    (printed,) = (output for output in outputs if output.output_type == "stream")
    assert printed.name == "stdout" and float(printed.text.split()[-2]) < 1e-3
    # What is kept has no outputs, which would change with every run.
    kept = nbformat.read(EXAMPLES / "panda.ipynb", 4)
    assert not any(cell.get("outputs") for cell in kept.cells)
