"""Runs docs/python/tour.ipynb: every cell runs and prints the stored output. Argument: the sources.

notebook_test.py SOURCES --write puts the outputs of this run into the notebook.
"""
import os
import pathlib
import sys
import tempfile

import nbclient
import nbformat

notebook = pathlib.Path(sys.argv[1], "docs", "python", "tour.ipynb")


def printed(cells):
    return [[output["text"] for output in cell.get("outputs", []) if output["output_type"] == "stream"] for cell in cells]


shown = nbformat.read(notebook, as_version=4)
found = nbformat.read(notebook, as_version=4)
with tempfile.TemporaryDirectory() as folder:
    os.environ["IPYTHONDIR"] = os.environ["JUPYTER_RUNTIME_DIR"] = folder  # no settings of the user
    client = nbclient.NotebookClient(found, kernel_name="python3", timeout=300, record_timing=False, resources={"metadata": {"path": folder}})
    client.execute()  # raises the error of a cell
found.metadata.pop("language_info", None)
if "--write" in sys.argv:
    nbformat.write(found, notebook)
elif printed(found.cells) != printed(shown.cells):
    sys.exit(f"tour.ipynb prints {printed(found.cells)}, and shows {printed(shown.cells)}: run notebook_test.py --write, and read it")
